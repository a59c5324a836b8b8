#include "core/garment/desk/garment_desk.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/garment/desk/desk_notes.hpp"
#include "core/garment/desk/middle_line.hpp"
#include "core/garment/desk/network_paths.hpp"
#include "core/garment/desk/pick.hpp"
#include "core/garment/desk/region_names.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;

DesignStep step_of(Kind kind) {
    DesignStep step;
    step.kind = kind;
    return step;
}

DesignStep region_step(Kind kind, const std::string& region) {
    DesignStep step = step_of(kind);
    step.region = region;
    return step;
}

DesignStep layer_step(Kind kind, int layer) {
    DesignStep step = step_of(kind);
    step.layer = layer;
    return step;
}

}  // namespace

GarmentDesk::GarmentDesk(Design settings, DesignRunner start)
    : settings_only_(std::move(settings)), history_(std::move(start)) {
    shown_form_ = {state().worn(), &state().worn()->form};
}

Result<GarmentDesk> GarmentDesk::open(Design design, const DressForm& form, FormSource source) {
    Result<DesignRunner> start = DesignRunner::start(design, form, std::move(source));
    if (!start) return unexpected(start.error());
    const std::vector<DesignStep> steps = std::exchange(design.steps, {});
    GarmentDesk desk(std::move(design), std::move(*start));
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
            reply.notes.push_back(note_of(done.error(), {}));
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

/// Loose ends that a new line passes are joined to it, as they would be had it been there first.
void GarmentDesk::join_ends(DesignRunner& next, std::vector<DesignStep>& saved) const {
    for (const OpenEnd& end : open_ends(next.network(), next.layer())) {
        if (end.nearest == end.line || end.nearest.empty() || end.gap_cm > settings_only_.network.snap_cm) continue;
        DesignStep step = step_of(Kind::Join);
        step.at = end.place;
        step.lines = {end.nearest};
        if (Result<DesignStep> done = next.take(step); done) {
            saved.push_back(std::move(*done));
            return join_ends(next, saved);  // the other ends again: lines were split
        }
    }
}

/// New lines get vertices where they cross others, or themselves.
void GarmentDesk::meet_lines(DesignRunner& next, std::vector<DesignStep>& saved) const {
    constexpr int kMost = 32;  // crossings of one stroke
    const std::string name = saved.front().kind == Kind::Line ? saved.front().name : std::string();
    for (int k = 0; k < kMost && !name.empty(); ++k) {
        const std::optional<LineCrossing> found = first_crossing(next.network(), next.layer(), name, next.obstacle());
        if (!found) return;
        DesignStep step = step_of(Kind::Meet);
        step.lines = {next.network().piece_name(found->line), next.network().piece_name(found->other)};
        step.at = found->at;
        step.to = found->to;
        Result<DesignStep> done = next.take(step);
        if (!done) return;
        saved.push_back(std::move(*done));
    }
}

/// Lines in the middle that came by themselves give way to one that the designer draws there along them.
void GarmentDesk::give_way(DesignRunner& next, std::vector<DesignStep>& saved) const {
    if (saved.front().kind != Kind::Line) return;
    for (bool changed = true; changed;) {  // pieces of one name change their numbers as one goes
        changed = false;
        for (std::size_t i = 0; i < next.network().lines().size() && !changed; ++i) {
            const NetworkLine& line = next.network().lines()[i];
            if (!line.alive || line.layer != next.layer() || line.name.rfind(kMiddleLine, 0) != 0) continue;
            if (!runs_along(next.network(), next.layer(), saved.front().name, line.shape, next.obstacle())) continue;
            DesignStep step = step_of(Kind::Erase);
            step.lines = {next.network().piece_name(static_cast<int>(i))};
            Result<DesignStep> done = next.take(step);
            if (!done) continue;
            saved.push_back(std::move(*done));
            changed = true;
        }
    }
}

/// Where outlines are open in the middle alone: from an end there to another place of the middle, on one side of the
/// body, if a line between the two closes one.
void GarmentDesk::close_middle(DesignRunner& next, std::vector<DesignStep>& saved) const {
    std::vector<Vec3> ends, all;
    for (const OpenEnd& end : open_ends(next.network(), next.layer())) {
        if (end.place.x != 0.0) return;  // still being drawn
        ends.push_back(end.place);
    }
    for (const NetworkVertex& vertex : next.network().vertices())
        if (vertex.alive && vertex.layer == next.layer() && vertex.place.x == 0.0) all.push_back(vertex.place);
    struct Pair {
        double gap;
        Vec3 from, to;
    };
    std::vector<Pair> pairs;
    for (const Vec3& from : ends)
        for (const Vec3& to : all)
            if (from != to && is_one_side(next.obstacle(), from, to)) pairs.push_back({length(from - to), from, to});
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) { return x.gap < y.gap; });
    for (const Pair& pair : pairs) {
        DesignStep step;
        step.name = free_line_name(next.network(), kMiddleLine);
        step.stroke = middle_stroke(next.obstacle(), pair.from, pair.to);
        DesignRunner tried = next;
        Result<DesignStep> done = tried.take(step);
        if (!done) continue;
        const std::vector<OpenFace> faces = open_faces(tried.network(), tried.layer(), tried.obstacle());
        const bool closes = std::any_of(faces.begin(), faces.end(), [&](const OpenFace& face) {
            return std::any_of(face.ring.begin(), face.ring.end(), [&](LineUse use) {
                return tried.network().lines()[static_cast<std::size_t>(use.line)].name == step.name;
            });
        });
        if (!closes) continue;
        saved.push_back(std::move(*done));
        next = std::move(tried);
        return close_middle(next, saved);
    }
}

/// Regions for the outlines that are closed now.
void GarmentDesk::close_regions(DesignRunner& next, std::vector<DesignStep>& saved, DeskReply& reply) const {
    struct Whole {
        double alpha;
        PartSet parts;
    };
    std::map<std::string, Whole> parted;  // regions that lines part, as they were
    for (const OpenFace& face : open_faces(next.network(), next.layer(), next.obstacle())) {
        DesignStep step = step_of(Kind::Region);
        step.lines = names_of_ring(next.network(), next.layer(), face.ring);
        step.alpha = settings_.alpha;
        if (face.part_of.empty()) {
            step.name = name_for_region(next.network(), face.ring, next.obstacle());
        } else if (const auto known = parted.find(face.part_of); known != parted.end()) {
            step.name = free_region_name(next.network(), face.part_of);
            step.alpha = known->second.alpha;
            step.parts = known->second.parts;
        } else {
            const NetworkRegion& whole = *next.network().find_region(face.part_of);
            step.name = step.region = face.part_of;
            step.alpha = whole.alpha;
            step.parts = whole.parts;
            parted.emplace(face.part_of, Whole{whole.alpha, whole.parts});
        }
        Result<DesignStep> done = next.take(step);
        if (done) {
            saved.push_back(std::move(*done));
        } else {
            reply.notes.push_back(note_of(done.error(), ring_line(next.network(), face.ring).front()));
            reply.notes.back().key = "not_filled";
        }
    }
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
    DeskReply reply = act({step});
    for (DeskNote& note : reply.notes) note.key = "body_unfit";
    return reply;
}

DeskReply GarmentDesk::set_own_body(const std::string& file) {
    DesignStep step = step_of(Kind::Body);
    step.name = file;
    DeskReply reply = act({step});
    for (DeskNote& note : reply.notes) note.key = "body_unfit";
    return reply;
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
            {middle ? "open_middle" : "outline_open",
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
        live_.emplace(network(), layer, state().look().mirror, *built.cloth);
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
