#include "core/garment/design.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/garment/body_warp.hpp"
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
            return "region \"" + step.region + "\"";
        case Kind::Move:
        case Kind::Weld:
        case Kind::Layer:
            break;
    }
    return {};
}

constexpr double kDrawnSmoothing_cm = 0.5;
constexpr int kDrawnPasses = 4;

bool has_ends(Kind kind) {
    return kind == Kind::Line || kind == Kind::Cut;
}

/// A body that nothing is known of but its mesh.
DressForm plain_form(const TriangleMesh& body) {
    DressForm form;
    form.mesh = body;
    return form;
}

}  // namespace

DesignRunner::DesignRunner(const Design& design, Obstacle obstacle, std::vector<Landmark> landmarks)
    : settings_{design.name, design.body, design.mirror, design.network, design.fitting, {}},
      obstacle_(std::move(obstacle)),
      landmarks_(std::move(landmarks)),
      network_(design.network) {}

Result<DesignRunner> DesignRunner::start(const Design& design, const DressForm& form) {
    Result<Obstacle> obstacle = Obstacle::of_body(form);
    if (!obstacle) return unexpected(obstacle.error());
    return DesignRunner(design, std::move(*obstacle), form.landmarks);
}

Result<DesignRunner> DesignRunner::start(const Design& design, const TriangleMesh& body) {
    return start(design, plain_form(body));
}

/// A landmark, as far outside of the body as a stroke on the body is drawn.
void DesignRunner::put_to_landmark(Vec3& end, const std::string& name, const StrokePart& part) const {
    const Landmark* landmark = find_landmark(landmarks_, name);
    if (landmark == nullptr) return;
    const double offset = part.tool.kind == DrawingTool::Kind::Body ? part.tool.offset : 0.0;
    end = landmark->place + obstacle_.sample(landmark->place).gradient * offset;
}

/// A stroke as a line of the network: lifted, without the trembling of the hand, its ends at their landmarks.
Result<SpaceLine> DesignRunner::drawn_line(const DesignStep& step) const {
    Result<std::vector<Vec3>> lifted = lift_stroke(step.stroke, obstacle_);
    if (!lifted) return unexpected(lifted.error());
    SpaceLine line = smoothed(*lifted, kDrawnSmoothing_cm, kDrawnPasses);
    if (!has_ends(step.kind)) return line;
    Vec3 first = line.front(), last = line.back();
    put_to_landmark(first, step.starts_at, step.stroke.front());
    put_to_landmark(last, step.ends_at, step.stroke.back());
    pull_ends(line, first, last);
    return line;
}

DesignStep DesignRunner::snapped(DesignStep step) const {
    if (!has_ends(step.kind)) return step;
    const Result<SpaceLine> line = drawn_line(step);
    if (!line) return step;
    const auto name_at = [&](Vec3 end) {
        const SnapTarget target = snap_target(network_, layer_, landmarks_, end, settings_.network.snap_cm, false);
        return target.kind == SnapTarget::Kind::Landmark ? target.name : std::string();
    };
    if (step.starts_at.empty()) step.starts_at = name_at(line->front());
    if (step.ends_at.empty()) step.ends_at = name_at(line->back());
    return step;
}

/// By places on its ring and half way between opposite ones.
PartSet DesignRunner::parts_under(const NetworkRegion& region) const {
    if (obstacle_.parts().empty()) return 0;
    std::vector<Vec3> places;
    for (const LineUse use : region.ring) {
        SpaceLine line = resampled(network_.lines()[static_cast<std::size_t>(use.line)].shape, 12);
        if (use.reversed) std::reverse(line.begin(), line.end());
        places.insert(places.end(), line.begin(), line.end() - 1);
    }
    const std::size_t ring = places.size();
    for (std::size_t i = 0; i < ring / 2; ++i) places.push_back((places[i] + places[i + ring / 2]) * 0.5);
    return obstacle_.parts().parts_under(places);
}

Result<DesignStep> DesignRunner::take(const DesignStep& step) {
    Network next = network_;
    DesignStep saved = step;
    const auto with_line = [&](const std::function<Result<void>(SpaceLine)>& use) -> Result<void> {
        Result<SpaceLine> line = drawn_line(step);
        if (!line) return unexpected(line.error());
        return use(std::move(*line));
    };
    const auto done = [&]() -> Result<void> {
        switch (step.kind) {
            case Kind::Line:
                return with_line([&](SpaceLine l) { return next.add_line(step.name, std::move(l), settings_.mirror); });
            case Kind::Region: {
                if (Result<void> made = next.add_region(step.name, step.lines, &obstacle_); !made) return made;
                return next.set_alpha(step.name, step.alpha);
            }
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
                return next.move(step.at, step.to, step.radius);
            case Kind::Weld:
                return next.weld(step.at, step.to);
            case Kind::Associate:
                return next.associate(step.region, step.parts);
            case Kind::Layer:
                break;
        }
        return {};
    }();
    if (!done) return unexpected(done.error().code, done.error().message, step_subject(step));
    network_ = std::move(next);
    if (step.kind == Kind::Region) {
        if (saved.parts == 0) saved.parts = parts_under(*network_.find_region(step.name));
        (void)network_.associate(step.name, saved.parts);
    }
    return saved;
}

FinishedLayer DesignRunner::finish_layer(std::vector<DesignFault>& faults) const {
    BuiltCloth built = build_cloth(network_, layer_);
    for (const ClothFault& fault : built.faults)
        faults.push_back({0, "region \"" + fault.region + "\": " + fault.error.message});
    FinishedLayer layer;
    layer.drawn = settings_.mirror ? mirrored_and_joined(built.cloth) : std::move(built.cloth);
    layer.fitted = layer.drawn;
    layer.report = fit_cloth(layer.fitted, obstacle_, settings_.fitting);
    return layer;
}

void DesignRunner::next_layer(Garment& garment) {
    garment.layers.push_back(finish_layer(garment.faults));
    obstacle_.add_layer(garment.layers.back().fitted.mesh);
    network_.begin_layer(++layer_);
}

namespace {

Result<Garment> drawn_garment(const Design& design, const DressForm& form) {
    Result<DesignRunner> runner = DesignRunner::start(design, form);
    if (!runner) return unexpected(runner.error());
    Garment garment{Network(design.network), {}, {}};
    int number = 0;
    for (const DesignStep& step : design.steps) {
        ++number;
        if (step.kind == Kind::Layer) {
            runner->next_layer(garment);
        } else if (const Result<DesignStep> done = runner->take(step); !done) {
            garment.faults.push_back({number, done.error().sentence()});
        }
    }
    runner->next_layer(garment);
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

}  // namespace

Result<Garment> make_garment(const Design& design, const DressForm& form) {
    if (form.landmarks.empty() ||
        (form.measures && form.measures->figure == design.body.figure && form.measures->cm == design.body.cm))
        return drawn_garment(design, form);
    const Result<Mannequin> own = make_mannequin(design.body);
    if (!own) return unexpected(own.error());
    const DressForm own_form = dress_form(*own);
    // landmarks of a mesh are found by its cuts: those of the mannequin then too, so that they mean the same
    const std::optional<FoundBody> found = form.measures ? std::nullopt : find_body(own_form.mesh);
    const std::optional<BodyWarp> warp =
        BodyWarp::between(found ? found->landmarks : own_form.landmarks, form.landmarks);
    if (!warp) return drawn_garment(design, form);
    Result<Garment> garment = drawn_garment(design, own_form);
    if (!garment) return garment;
    if (const Result<void> done = carry_over(*garment, design, form, *warp); !done) return unexpected(done.error());
    return garment;
}

Result<Garment> make_garment(const Design& design, const TriangleMesh& body) {
    return drawn_garment(design, plain_form(body));
}

Design recorded(const Design& design, const DressForm& form) {
    Design out = design;
    Result<DesignRunner> runner = DesignRunner::start(design, form);
    if (!runner) return out;
    Garment garment{Network(design.network), {}, {}};
    for (DesignStep& step : out.steps) {
        if (step.kind == Kind::Layer) {
            runner->next_layer(garment);
        } else if (Result<DesignStep> saved = runner->take(step); saved) {
            step = std::move(*saved);
        }
    }
    return out;
}

}  // namespace core
