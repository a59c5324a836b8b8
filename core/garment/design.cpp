#include "core/garment/design.hpp"

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "core/garment/body_warp.hpp"
#include "core/garment/layer_store.hpp"
#include "core/mannequin/body_finder.hpp"

namespace core {
namespace {

using Kind = DesignStep::Kind;

std::string step_subject(const DesignStep& step) {
    switch (step.kind) {
        case Kind::Line:
            return "line \"" + step.name + "\"";
        case Kind::Region:
            return "region \"" + step.name + "\"";
        case Kind::Cut:
        case Kind::Hole:
        case Kind::Remove:
        case Kind::Corner:
        case Kind::Alpha:
        case Kind::Associate:
        case Kind::Material:
            return "region \"" + step.region + "\"";
        case Kind::Erase:
        case Kind::Join:
        case Kind::Meet:
        case Kind::Smooth:
        case Kind::Bump:
            return step.lines.empty() ? std::string() : "line \"" + step.lines.front() + "\"";
        case Kind::Rename:
            return step.region.empty() ? std::string() : "region \"" + step.region + "\"";
        case Kind::Place:
            return "object \"" + step.object.name + "\"";
        case Kind::Unplace:
            return "object \"" + step.name + "\"";
        case Kind::Move:
        case Kind::Weld:
        case Kind::Layer:
        case Kind::Mirror:
        case Kind::Work:
        case Kind::Order:
        case Kind::Show:
        case Kind::Body:
        case Kind::Edges:
            break;
    }
    return {};
}

/// How much of a line follows an end that is put elsewhere in depth: so many times the way, this much at least and half
/// of the line at most.
constexpr double kFollow = 4.0, kLeastFollow_cm = 3.0;

/// Moves the start of a line, and less and less what follows it.
void pull_start(SpaceLine& line, Vec3 place) {
    const Vec3 shift = place - line.front();
    const double reach = std::min(0.5 * line_length(line), std::max(kLeastFollow_cm, kFollow * length(shift)));
    double passed = 0.0;
    Vec3 before = line.front();
    for (Vec3& p : line) {
        passed += length(p - before);
        if (passed >= reach) break;
        before = p;
        const double t = 1.0 - passed / reach;
        p = p + shift * (t * t);
    }
    line.front() = place;
}

constexpr double kDrawnSmoothing_cm = 0.5;
constexpr int kDrawnPasses = 4;

Unexpected bad(std::string what) {
    return unexpected(ErrorCode::BadArgument, std::move(what));
}

bool has_ends(Kind kind) {
    return kind == Kind::Line || kind == Kind::Cut;
}

/// A body that nothing is known of but its mesh.
DressForm plain_form(const TriangleMesh& body) {
    DressForm form;
    form.mesh = body;
    return form;
}

std::uint64_t form_key(const DressForm& form) {
    StateHash hash;
    for (const Vec3& v : form.mesh.vertices) hash.add(v);
    return hash.value();
}

Result<std::shared_ptr<const WornForm>> worn_form(const DressForm& form) {
    Result<Obstacle> obstacle = Obstacle::of_body(form);
    if (!obstacle) return unexpected(obstacle.error());
    return std::make_shared<const WornForm>(WornForm{form, std::move(*obstacle), form_key(form)});
}

/// The map that takes a garment from one body to another; nothing where landmarks do not tell it.
std::optional<BodyWarp> warp_between(const DressForm& from, const DressForm& to) {
    // landmarks of a mesh are found by its cuts: those of a mannequin then too, so that they mean the same
    const auto landmarks = [](const DressForm& form, const DressForm& other) {
        const bool found = form.measures && !other.measures;
        const std::optional<FoundBody> body = found ? find_body(form.mesh) : std::nullopt;
        return body ? body->landmarks : form.landmarks;
    };
    return BodyWarp::between(landmarks(from, to), landmarks(to, from));
}

bool same_measures(const DressForm& form, const BodyMeasures& measures) {
    return form.measures && form.measures->figure == measures.figure && form.measures->cm == measures.cm;
}

bool is_look(Kind kind) {
    return kind == Kind::Layer || kind == Kind::Rename || kind == Kind::Material || kind == Kind::Mirror ||
           kind == Kind::Work || kind == Kind::Order || kind == Kind::Show || kind == Kind::Place ||
           kind == Kind::Unplace;
}

}  // namespace

DesignRunner::DesignRunner(const Design& design, std::shared_ptr<const WornForm> worn, FormSource source)
    : settings_{design.name, design.body, design.mirror, design.network, design.fitting, {}},
      worn_(std::move(worn)),
      source_(std::move(source)),
      store_(std::make_shared<LayerStore>()),
      obstacle_(worn_, &worn_->obstacle),
      network_(design.network) {
    look_.mirror = design.mirror;
}

Result<DesignRunner> DesignRunner::start(const Design& design, const DressForm& form, FormSource source) {
    Result<std::shared_ptr<const WornForm>> worn = worn_form(form);
    if (!worn) return unexpected(worn.error());
    return DesignRunner(design, std::move(*worn), std::move(source));
}

Result<DesignRunner> DesignRunner::start(const Design& design, const TriangleMesh& body) {
    return start(design, plain_form(body));
}

DesignRunner DesignRunner::start(const Design& design, const DesignRunner& on) {
    DesignRunner out(design, on.worn_, on.source_);
    out.store_ = on.store_;
    return out;
}

/// A landmark, as far outside of the body as a stroke on the body is drawn.
void DesignRunner::put_to_landmark(Vec3& end, const std::string& name, const StrokePart& part) const {
    const Landmark* landmark = find_landmark(landmarks(), name);
    if (landmark == nullptr) return;
    const double offset = part.tool.kind == DrawingTool::Kind::Body ? part.tool.offset : 0.0;
    end = landmark->place + obstacle_->sample(landmark->place).gradient * offset;
}

/// The piece that a cut or hole is drawn on, where the stroke has a part that is.
std::optional<QuadMesh> DesignRunner::piece_under(const DesignStep& step) const {
    const bool on_piece = std::any_of(step.stroke.begin(), step.stroke.end(), [](const StrokePart& part) {
        return part.tool.kind == DrawingTool::Kind::Piece;
    });
    const NetworkRegion* region = on_piece ? network_.find_region(step.region) : nullptr;
    if (region == nullptr) return std::nullopt;
    const Result<RegionBoundary> boundary = network_.boundary(*region);
    if (!boundary) return std::nullopt;
    Result<FilledRegion> filled = fill_region(boundary->outline, region->alpha);
    return filled ? std::optional<QuadMesh>(std::move(filled->mesh)) : std::nullopt;
}

Result<SpaceLine> DesignRunner::drawn_line(const DesignStep& step) const {
    const std::optional<QuadMesh> piece = piece_under(step);
    Result<std::vector<Vec3>> lifted = lift_stroke(step.stroke, *obstacle_, piece ? &*piece : nullptr);
    if (!lifted) return unexpected(lifted.error());
    SpaceLine line = smoothed(*lifted, kDrawnSmoothing_cm, kDrawnPasses);
    if (!has_ends(step.kind)) return line;
    Vec3 first = line.front(), last = line.back();
    put_to_landmark(first, step.starts_at, step.stroke.front());
    put_to_landmark(last, step.ends_at, step.stroke.back());
    pull_ends(line, first, last);
    if (step.starts_to) pull_start(line, *step.starts_to);
    if (step.ends_to) {
        std::reverse(line.begin(), line.end());
        pull_start(line, *step.ends_to);
        std::reverse(line.begin(), line.end());
    }
    return line;
}

DesignStep DesignRunner::snapped(DesignStep step, double reach_cm) const {
    if (!has_ends(step.kind)) return step;
    const Result<SpaceLine> line = drawn_line(step);
    if (!line) return step;
    const auto name_at = [&](Vec3 end) {
        const SnapTarget target = snap_target(network_, layer_, landmarks(), end, reach_cm, false);
        return target.kind == SnapTarget::Kind::Landmark ? target.name : std::string();
    };
    if (step.starts_at.empty() && !step.starts_to) step.starts_at = name_at(line->front());
    if (step.ends_at.empty() && !step.ends_to) step.ends_at = name_at(line->back());
    return step;
}

/// By places on its ring and half way between opposite ones.
PartSet DesignRunner::parts_under(const NetworkRegion& region) const {
    if (obstacle_->parts().empty()) return 0;
    std::vector<Vec3> places;
    for (const LineUse use : region.ring) {
        SpaceLine line = resampled(network_.lines()[static_cast<std::size_t>(use.line)].shape, 12);
        if (use.reversed) std::reverse(line.begin(), line.end());
        places.insert(places.end(), line.begin(), line.end() - 1);
    }
    const std::size_t ring = places.size();
    for (std::size_t i = 0; i < ring / 2; ++i) places.push_back((places[i] + places[i + ring / 2]) * 0.5);
    return obstacle_->parts().parts_under(places);
}

/// What a step does to the lines and regions.
Result<void> DesignRunner::change(Network& next, const DesignStep& step) const {
    const auto with_line = [&](const std::function<Result<void>(SpaceLine)>& use) -> Result<void> {
        Result<SpaceLine> line = drawn_line(step);
        if (!line) return unexpected(line.error());
        return use(std::move(*line));
    };
    const std::string piece = step.lines.empty() ? std::string() : step.lines.front();
    switch (step.kind) {
        case Kind::Line:
            return with_line([&](SpaceLine l) { return next.add_line(step.name, std::move(l), look_.mirror); });
        case Kind::Region:
            if (!step.region.empty()) next.release_region(step.region);
            if (Result<void> made = next.add_region(step.name, step.lines, obstacle_.get()); !made) return made;
            return next.set_alpha(step.name, step.alpha);
        case Kind::Cut:
            return with_line([&](SpaceLine l) { return next.cut(step.region, std::move(l), step.name); });
        case Kind::Hole:
            return with_line([&](SpaceLine l) { return next.cut_hole(step.region, std::move(l), step.name); });
        case Kind::Remove:
            return next.remove_region(step.region);
        case Kind::Corner:
            return next.set_corner(step.region, step.at, step.on);
        case Kind::Alpha:
            return next.set_alpha(step.region, step.alpha);
        case Kind::Move:
            return next.move(step.at, step.to, step.radius, look_.mirror);
        case Kind::Weld:
            return next.weld(step.at, step.to);
        case Kind::Associate:
            return next.associate(step.region, step.parts);
        case Kind::Erase:
            return next.erase_line(piece);
        case Kind::Join:
            return next.join(step.at, piece);
        case Kind::Meet:
            return next.meet(piece, step.at, step.lines.back(), step.to);
        case Kind::Smooth:
            return next.smooth(piece, step.at, step.to);
        case Kind::Bump:
            return next.bump(piece, step.at, step.to, step.radius, step.depth,
                             [&](Vec3 p) { return obstacle_->sample(p).gradient; });
        case Kind::Edges:
            return next.set_edge(step.radius);
        default:
            return {};
    }
}

void DesignRunner::rename(const DesignStep& step) {
    const auto material = look_.materials.find(step.region);
    if (material == look_.materials.end()) return;
    look_.materials[step.name] = material->second;
    look_.materials.erase(step.region);
}

/// What a step does to all else. Checks before it changes.
Result<void> DesignRunner::change_look(const DesignStep& step) {
    const auto layers = static_cast<int>(look_.layers.size());
    const bool of_layer =
        step.kind == Kind::Work || step.kind == Kind::Show || (step.kind == Kind::Rename && step.region.empty());
    if (of_layer && (step.layer < 0 || step.layer >= layers))
        return bad("There is no layer " + std::to_string(step.layer + 1) + ".");
    const auto object_named = [&](const std::string& name) {
        return std::find_if(look_.objects.begin(), look_.objects.end(),
                            [&](const PlacedObject& o) { return o.name == name; });
    };
    switch (step.kind) {
        case Kind::Layer:
            look_.layers.emplace_back();
            look_.order.push_back(layers);
            layer_ = layers;
            break;
        case Kind::Work:
            layer_ = step.layer;
            break;
        case Kind::Order: {
            std::vector<int> sorted = step.order, own = look_.order;
            std::sort(sorted.begin(), sorted.end()), std::sort(own.begin(), own.end());
            if (sorted != own) return bad("The order must name each layer once.");
            look_.order = step.order;
            break;
        }
        case Kind::Rename:
            if (!step.region.empty()) {
                if (Result<void> done = network_.rename_region(step.region, step.name); !done) return done;
                rename(step);
            } else {
                look_.layers[static_cast<std::size_t>(step.layer)].name = step.name;
            }
            break;
        case Kind::Material:
            if (network_.find_region(step.region) == nullptr) return bad("There is no region \"" + step.region + "\".");
            look_.materials[step.region] = step.material;
            break;
        case Kind::Mirror:
            look_.mirror = step.on;
            break;
        case Kind::Show:
            look_.layers[static_cast<std::size_t>(step.layer)].shown = step.on;
            break;
        case Kind::Place:
            if (step.object.name.empty() || !(step.object.scale > 0.0))
                return bad("A placed object needs a name and a size above 0.");
            if (const auto known = object_named(step.object.name); known != look_.objects.end())
                *known = step.object;
            else
                look_.objects.push_back(step.object);
            break;
        case Kind::Unplace:
            if (object_named(step.name) == look_.objects.end())
                return bad("There is no object \"" + step.name + "\" on the figure.");
            look_.objects.erase(object_named(step.name));
            break;
        default:
            break;
    }
    if (step.kind == Kind::Layer || step.kind == Kind::Work || step.kind == Kind::Order || step.kind == Kind::Mirror)
        look_below();
    return {};
}

/// Another body: the lines are carried over by the landmarks, where both have them.
Result<void> DesignRunner::wear(const DesignStep& step) {
    Result<DressForm> form = bad("There is no body \"" + step.name + "\" here: bring its file again.");
    std::uint64_t key = 0;
    std::shared_ptr<const WornForm> known;
    if (step.body) {
        StateHash hash;
        hash.add(static_cast<int>(step.body->figure));
        for (const double cm : step.body->cm) hash.add(cm);
        key = hash.value();
        known = store_->form(key);
        if (!known) {
            const Result<Mannequin> body = make_mannequin(*step.body);
            form = body ? Result<DressForm>(dress_form(*body)) : unexpected(body.error());
        }
    } else if (source_) {
        form = source_(step.name);
    }
    if (!known) {
        if (!form) return unexpected(form.error());
        Result<std::shared_ptr<const WornForm>> worn = worn_form(*form);
        if (!worn) return unexpected(worn.error());
        known = *worn;
        if (step.body) store_->keep(key, known);
    }
    if (const std::optional<BodyWarp> warp = warp_between(worn_->form, known->form); warp)
        network_.carry([&](Vec3 p) { return (*warp)(p); });
    worn_ = known;
    look_below();
    return {};
}

Result<DesignStep> DesignRunner::take(const DesignStep& step) {
    const auto blame = [&](const Error& error) { return unexpected(error.code, error.message, step_subject(step)); };
    if (step.kind == Kind::Body) {
        if (const Result<void> done = wear(step); !done) return blame(done.error());
        return step;
    }
    if (is_look(step.kind)) {
        if (const Result<void> done = change_look(step); !done) return blame(done.error());
        return step;
    }
    Network next = network_;
    if (const Result<void> done = change(next, step); !done) return blame(done.error());
    network_ = std::move(next);
    if (step.kind == Kind::Cut || step.kind == Kind::Hole)  // both halves are of the same cloth
        if (const auto material = look_.materials.find(step.region); material != look_.materials.end())
            look_.materials[step.name] = ClothMaterial(material->second);
    DesignStep saved = step;
    if (step.kind == Kind::Region) {
        if (saved.parts == 0) saved.parts = parts_under(*network_.find_region(step.name));
        (void)network_.associate(step.name, saved.parts);
    }
    return saved;
}

// ---- layers

std::uint64_t DesignRunner::layer_key(int layer, const Below& below) const {
    StateHash hash;
    hash.add(below.key);
    hash.add(look_.mirror);
    hash.add(settings_.fitting.clearance_cm), hash.add(settings_.fitting.rounds);
    hash.add(static_cast<int>(settings_.fitting.fairing)), hash.add(settings_.fitting.strength);
    hash.add(network_.options().edge_cm);
    for (const NetworkRegion& region : network_.regions()) {
        if (!region.alive || region.layer != layer) continue;
        hash.add(region.name), hash.add(region.alpha), hash.add(region.parts);
        for (const LineUse use : region.ring) {
            const NetworkLine& line = network_.lines()[static_cast<std::size_t>(use.line)];
            hash.add(use.line), hash.add(use.reversed), hash.add(line.from), hash.add(line.to);
            hash.add(region.corners.count(use.reversed ? line.to : line.from));
            for (const Vec3& p : line.shape) hash.add(p);
        }
    }
    return hash.value();
}

std::shared_ptr<const FinishedLayer> DesignRunner::finish_layer(int layer, const Below& below) const {
    const std::uint64_t key = layer_key(layer, below);
    if (std::shared_ptr<const FinishedLayer> known = store_->layer(key); known) return known;
    BuiltCloth built = build_cloth(network_, layer);
    auto made = std::make_shared<FinishedLayer>();
    made->faults = std::move(built.faults);
    made->drawn = look_.mirror ? mirrored_and_joined(built.cloth) : std::move(built.cloth);
    made->fitted = made->drawn;
    made->report = fit_cloth(made->fitted, *below.obstacle, settings_.fitting);
    store_->keep(key, made);
    return made;
}

DesignRunner::Below DesignRunner::add_to(const Below& below, int layer, const FinishedLayer& cloth) const {
    if (cloth.fitted.mesh.quads.empty()) return below;
    const std::uint64_t key = layer_key(layer, below) ^ 0x9e3779b97f4a7c15ULL;
    if (std::shared_ptr<const Obstacle> known = store_->obstacle(key); known) return {known, key};
    auto made = std::make_shared<Obstacle>(*below.obstacle);
    made->add_layer(cloth.fitted.mesh);
    store_->keep(key, std::shared_ptr<const Obstacle>(made));
    return {made, key};
}

std::vector<BuiltLayer> DesignRunner::finish(const std::stop_token& stop) const {
    std::vector<BuiltLayer> out;
    Below below{{worn_, &worn_->obstacle}, worn_->key};
    for (const int layer : look_.order) {
        if (stop.stop_requested()) break;
        out.push_back({layer, finish_layer(layer, below)});
        if (layer != look_.order.back()) below = add_to(below, layer, *out.back().cloth);
    }
    return out;
}

/// What is drawn from here on lies on the layers below the one that is worked on.
void DesignRunner::look_below() {
    Below below{{worn_, &worn_->obstacle}, worn_->key};
    for (const int layer : look_.order) {
        if (layer == layer_) break;
        below = add_to(below, layer, *finish_layer(layer, below));
    }
    obstacle_ = below.obstacle;
    network_.begin_layer(layer_);
}

namespace {

Result<Garment> drawn_garment(const Design& design, const DressForm& form, const FormSource& source,
                              bool other_bodies) {
    Result<DesignRunner> runner = DesignRunner::start(design, form, source);
    if (!runner) return unexpected(runner.error());
    Garment garment{Network(design.network), {}, {}};
    int number = 0;
    for (const DesignStep& step : design.steps) {
        ++number;
        if (step.kind == Kind::Body && !other_bodies) continue;
        if (const Result<DesignStep> done = runner->take(step); !done)
            garment.faults.push_back({number, done.error().sentence()});
    }
    for (const BuiltLayer& layer : runner->finish()) {
        garment.layers.push_back(*layer.cloth);
        for (const ClothFault& fault : layer.cloth->faults)
            garment.faults.push_back({0, "region \"" + fault.region + "\": " + fault.error.message});
    }
    garment.network = runner->network();
    return garment;
}

/// Every layer as the other body would wear it.
Result<void> carry_over(Garment& garment, const Design& design, const DressForm& form, const BodyWarp& warp) {
    Result<Obstacle> obstacle = Obstacle::of_body(form);
    if (!obstacle) return unexpected(obstacle.error());
    for (FinishedLayer& layer : garment.layers) {
        for (Vec3& v : layer.drawn.mesh.vertices) v = warp(v);
        for (Vec3& v : layer.fitted.mesh.vertices) v = warp(v);
        layer.report = fit_cloth(layer.fitted, *obstacle, design.fitting);
        obstacle->add_layer(layer.fitted.mesh);
    }
    garment.carried = true;
    return {};
}

/// The last Body step; null when the design stays on its first body.
const DesignStep* last_body(const Design& design) {
    const DesignStep* last = nullptr;
    for (const DesignStep& step : design.steps)
        if (step.kind == Kind::Body) last = &step;
    return last;
}

Result<DressForm> form_of(const BodyMeasures& measures) {
    const Result<Mannequin> body = make_mannequin(measures);
    if (!body) return unexpected(body.error());
    return dress_form(*body);
}

}  // namespace

Result<Garment> make_garment(const Design& design, const DressForm& form, const FormSource& source) {
    const DesignStep* last = last_body(design);
    if (form.landmarks.empty() || (last == nullptr && same_measures(form, design.body)))
        return drawn_garment(design, form, source, false);
    const Result<DressForm> first = form_of(design.body);
    if (!first) return unexpected(first.error());
    Result<DressForm> own = last == nullptr ? first
                            : last->body    ? form_of(*last->body)
                            : source        ? source(last->name)
                                            : first;
    if (!own) own = first;
    const bool worn = own->measures && same_measures(form, *own->measures);
    const std::optional<BodyWarp> warp = worn ? std::nullopt : warp_between(*own, form);
    if (!worn && !warp) return drawn_garment(design, form, source, false);
    Result<Garment> garment = drawn_garment(design, *first, source, true);
    if (!garment || worn) return garment;
    if (const Result<void> done = carry_over(*garment, design, form, *warp); !done) return unexpected(done.error());
    return garment;
}

Result<Garment> make_garment(const Design& design, const TriangleMesh& body) {
    return drawn_garment(design, plain_form(body), {}, false);
}

Design recorded(const Design& design, const DressForm& form) {
    Design out = design;
    Result<DesignRunner> runner = DesignRunner::start(design, form);
    if (!runner) return out;
    for (DesignStep& step : out.steps)
        if (Result<DesignStep> saved = runner->take(step); saved) step = std::move(*saved);
    return out;
}

}  // namespace core
