#include "core/garment/desk/garment_desk.hpp"

#include <algorithm>
#include <utility>

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/desk_steps.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;

}  // namespace

GarmentDesk::GarmentDesk(Design settings, DesignRunner start)
    : settings_only_(std::move(settings)), history_(std::move(start)) {
    shown_form_ = {state().worn(), &state().worn()->form};
}

Result<GarmentDesk> GarmentDesk::open(Design design, const DressForm& form, FormSource source) {
    Result<DesignRunner> start = DesignRunner::start(design, form, std::move(source));
    if (!start) return unexpected(start.error());
    return with_steps(std::move(design), std::move(*start));
}

GarmentDesk GarmentDesk::open(Design design, const DesignRunner& on) {
    DesignRunner start = DesignRunner::start(design, on);
    return with_steps(std::move(design), std::move(start));
}

GarmentDesk GarmentDesk::with_steps(Design design, DesignRunner start) {
    const std::vector<DesignStep> steps = std::exchange(design.steps, {});
    GarmentDesk desk(std::move(design), std::move(start));
    int number = 0;
    for (std::size_t first = 0; first < steps.size();) {
        std::size_t end = first + 1;
        while (end < steps.size() && steps[end].with_last) ++end;
        DesignRunner next = desk.state();
        std::vector<DesignStep> act(steps.begin() + static_cast<std::ptrdiff_t>(first),
                                    steps.begin() + static_cast<std::ptrdiff_t>(end));
        for (DesignStep& step : act) {
            ++number;
            Result<DesignStep> done = next.take(step);
            if (done)
                step = std::move(*done);
            else
                desk.faults_.push_back({number, done.error().sentence()});
        }
        desk.history_.push(std::move(act), std::move(next));
        first = end;
    }
    return desk;
}

// ---- acts

/// Takes steps as one act; all or, where one fails, none of them.
DeskReply GarmentDesk::act(const std::vector<DesignStep>& steps, bool closes) {
    cancel();
    finish_line();
    DeskReply reply;
    DesignRunner next = state();
    std::vector<DesignStep> saved;
    for (const DesignStep& step : steps) {
        Result<DesignStep> done = next.take(step);
        if (!done) {
            reply.notes.push_back(note_of_step(step, next, done.error(), {}));
            return reply;
        }
        saved.push_back(std::move(*done));
    }
    if (closes) {
        give_way(next, saved);
        join_ends(next, saved);
        meet_lines(next, saved);
    }
    if (closes && settings_.closes_regions && settings_.closes_middle && next.look().mirror) close_middle(next, saved);
    if (closes && settings_.closes_regions) close_regions(next, saved, reply);
    for (std::size_t k = 0; k < saved.size(); ++k) saved[k].with_last = k > 0;
    journal_.push_back({JournalEvent::Kind::Steps, saved, 0});
    history_.push(std::move(saved), std::move(next));
    ++number_;
    reply.changed = true;
    return reply;
}

/// After undo and redo: nothing of the state before is shown on.
void GarmentDesk::went() {
    journal_.push_back({JournalEvent::Kind::Place, {}, history_.place()});
    live_.reset();
    live_shown_ = false;
    ++number_;
}

DeskReply GarmentDesk::set_alpha(const std::string& region, double alpha) {
    DesignStep step = region_step(Kind::Alpha, region);
    step.alpha = std::clamp(alpha, kCoonsAlpha, kHarmonicAlpha);
    slide_alpha(region, step.alpha);
    return act({step});
}

DeskReply GarmentDesk::set_material(const std::string& region, const ClothMaterial& material) {
    return set_materials({{region, material}});
}

DeskReply GarmentDesk::set_materials(const std::vector<std::pair<std::string, ClothMaterial>>& of_regions) {
    std::vector<DesignStep> steps;
    for (const auto& [region, material] : of_regions) {
        steps.push_back(region_step(Kind::Material, region));
        steps.back().material = material;
    }
    return steps.empty() ? DeskReply{} : act(steps);
}

DeskReply GarmentDesk::rename_region(const std::string& region, const std::string& name) {
    DesignStep step = region_step(Kind::Rename, region);
    step.name = name;
    return act({step});
}

DeskReply GarmentDesk::remove_region(const std::string& region) {
    return act({region_step(Kind::Remove, region)});
}

DeskReply GarmentDesk::associate(const std::string& region, PartSet parts) {
    DesignStep step = region_step(Kind::Associate, region);
    step.parts = parts;
    return act({step});
}

/// Several changes in a row are one act.
DeskReply GarmentDesk::set_edge(double cm) {
    if (cm == network().options().edge_cm) return {};
    DesignStep step = step_of(Kind::Edges);
    step.radius = cm;
    const std::size_t was = history_.place();
    if (was > 0) {
        const std::vector<DesignStep>& last = history_.act(was - 1);
        if (last.size() == 1 && last.front().kind == Kind::Edges) (void)go_to(was - 1);
    }
    DeskReply reply = act({step});
    if (!reply.changed && history_.place() != was) (void)go_to(was);
    return reply;
}

DeskReply GarmentDesk::set_mirror(bool on) {
    DesignStep step = step_of(Kind::Mirror);
    step.on = on;
    return act({step}, true);
}

DeskReply GarmentDesk::new_layer() {
    return act({step_of(Kind::Layer)});
}

DeskReply GarmentDesk::work_on(int layer) {
    if (layer == this->layer()) return {};
    return act({layer_step(Kind::Work, layer)});
}

DeskReply GarmentDesk::move_layer(int layer, int by) {
    DesignStep step = step_of(Kind::Order);
    step.order = state().look().order;
    const auto at = std::find(step.order.begin(), step.order.end(), layer);
    if (at == step.order.end() || by == 0) return {};
    const auto from = at - step.order.begin();
    const auto to = std::clamp<std::ptrdiff_t>(from + by, 0, static_cast<std::ptrdiff_t>(step.order.size()) - 1);
    if (from == to) return {};
    step.order.erase(at);
    step.order.insert(step.order.begin() + to, layer);
    return act({step});
}

DeskReply GarmentDesk::show_layer(int layer, bool shown) {
    DesignStep step = layer_step(Kind::Show, layer);
    step.on = shown;
    return act({step});
}

DeskReply GarmentDesk::rename_layer(int layer, const std::string& name) {
    DesignStep step = layer_step(Kind::Rename, layer);
    step.name = name;
    return act({step});
}

DeskReply GarmentDesk::set_body(const BodyMeasures& measures) {
    DesignStep step = step_of(Kind::Body);
    step.body = measures;
    return act({step});
}

DeskReply GarmentDesk::set_own_body(const std::string& file) {
    DesignStep step = step_of(Kind::Body);
    step.name = file;
    return act({step});
}

DeskReply GarmentDesk::place(const PlacedObject& object) {
    DesignStep step = step_of(Kind::Place);
    step.object = object;
    return act({step});
}

DeskReply GarmentDesk::unplace(const std::string& name) {
    DesignStep step = step_of(Kind::Unplace);
    step.name = name;
    return act({step});
}

// ---- history

DeskReply GarmentDesk::go_to(std::size_t place) {
    cancel();
    finish_line();
    place = std::min(place, history_.acts());
    if (place == history_.place()) return {};
    history_.go_to(place);
    went();
    DeskReply reply;
    reply.changed = true;
    return reply;
}

DeskReply GarmentDesk::undo() {
    if (going_) return take_back_stroke();
    return can_undo() ? go_to(history_.place() - 1) : DeskReply{};
}

DeskReply GarmentDesk::redo() {
    return can_redo() ? go_to(history_.place() + 1) : DeskReply{};
}

Result<void> GarmentDesk::replay(const JournalEvent& event) {
    cancel();
    finish_line();
    live_.reset();
    live_shown_ = false;
    ++number_;
    if (event.kind == JournalEvent::Kind::Place) {
        if (event.place > history_.acts())
            return unexpected(ErrorCode::Damaged, "The journal goes back to a place that the design does not have.");
        history_.go_to(event.place);
        return {};
    }
    DesignRunner next = state();
    Result<void> all;
    for (const DesignStep& step : event.steps)
        if (const Result<DesignStep> done = next.take(step); !done && all) all = unexpected(done.error());
    history_.push(event.steps, std::move(next));
    return all;
}

std::vector<JournalEvent> GarmentDesk::take_journal() {
    return std::exchange(journal_, {});
}

// ---- what there is

Design GarmentDesk::design() const {
    Design out = settings_only_;
    out.steps = history_.steps();
    return out;
}

void GarmentDesk::each_step(const std::function<void(const DesignStep&)>& use) const {
    for (std::size_t act = 0; act < history_.place(); ++act)
        for (const DesignStep& step : history_.act(act)) use(step);
}

std::vector<LayerRow> GarmentDesk::layers() const {
    const DesignLook& look = state().look();
    std::vector<LayerRow> rows;
    for (const int layer : look.order) {
        const DesignLook::Layer& own = look.layers[static_cast<std::size_t>(layer)];
        LayerRow row{layer, own.name, own.shown, layer == this->layer(), {}, {}};
        for (const NetworkRegion& region : network().regions())
            if (region.alive && region.layer == layer) row.regions.push_back(region.name);
        for (const BuiltLayer& built : cloth_)
            if (built.layer == layer) row.clash = fitting_warning(built.cloth->report);
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<DeskNote> GarmentDesk::open_places() const {
    std::vector<DeskNote> notes;
    for (const OpenEnd& end : open_ends(network(), layer())) {
        const bool middle = state().look().mirror && end.place.x == 0.0;
        notes.push_back(
            {middle ? DeskNote::Key::OpenMiddle : DeskNote::Key::OutlineOpen,
             middle ? "This outline is open in the middle: draw the line in the middle." : "This outline is open here.",
             end.place, end.line, end.gap_cm});
    }
    return notes;
}

const Network& GarmentDesk::shown_network() const {
    return open_ && open_->dragged ? *open_->dragged : network();
}

// ---- cloth

std::optional<BuildRequest> GarmentDesk::build_request() {
    if (cloth_is_current() || asked_ == number_) return std::nullopt;
    asked_ = number_;
    return BuildRequest{state(), number_, std::nullopt};
}

BuildRequest GarmentDesk::try_body(const BodyMeasures& measures) {
    DesignStep step = step_of(Kind::Body);
    step.body = measures;
    return {state(), number_, std::move(step)};
}

bool GarmentDesk::accept(BuildResult result) {
    const bool newer = result.trial ? result.number == number_ : result.number > cloth_number_;
    if (!result.complete || !newer) {
        if (result.number == number_ && !cloth_is_current()) asked_ = 0;
        return false;
    }
    cloth_ = std::move(result.layers);
    cloth_faults_ = std::move(result.faults);
    shown_form_ = std::move(result.form);
    cloth_number_ = result.trial ? 0 : result.number;
    if (result.trial) asked_ = 0;
    if (!open_ || !open_->dragged) {
        live_.reset();
        live_shown_ = false;
    }
    return true;
}

void GarmentDesk::build_now() {
    if (cloth_is_current()) return;
    (void)accept(build({state(), number_, std::nullopt}, {}));
}

/// Live cloth for a layer, on what is shown; false where none is shown for its lines.
bool GarmentDesk::ready_live(int layer) {
    if (live_ && live_layer_ == layer) return true;
    live_.reset();
    live_shown_ = false;
    if (!cloth_is_current()) return false;
    for (const BuiltLayer& built : cloth_) {
        if (built.layer != layer) continue;
        const std::shared_ptr<const WornForm> worn = state().worn();
        live_.emplace(network(), layer, state().look().mirror, *built.cloth,
                      layer == state().layer() ? state().shared_obstacle()
                                               : std::shared_ptr<const Obstacle>(worn, &worn->obstacle));
        live_layer_ = layer;
    }
    return live_.has_value();
}

std::optional<GarmentDesk::Live> GarmentDesk::live() const {
    if (!live_ || !live_shown_) return std::nullopt;
    return Live{live_layer_, &live_->places()};
}

void GarmentDesk::slide_alpha(const std::string& region, double alpha) {
    const NetworkRegion* found = network().find_region(region);
    if (found == nullptr || !ready_live(found->layer)) return;
    live_->set_alpha(region, alpha);
    live_shown_ = true;
}

void GarmentDesk::drop_live() {
    live_.reset();
    live_shown_ = false;
}

}  // namespace core
