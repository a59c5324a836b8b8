#include "core/garment/design.hpp"

#include <utility>

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

/// A stroke as a line of the network: lifted, and without the trembling of the hand.
Result<SpaceLine> drawn_line(const SketchStroke& stroke, const Obstacle& body) {
    Result<std::vector<Vec3>> line = lift_stroke(stroke, body);
    if (!line) return unexpected(line.error());
    return smoothed(*line, kDrawnSmoothing_cm, kDrawnPasses);
}

}  // namespace

DesignRunner::DesignRunner(const Design& design, Obstacle obstacle)
    : settings_{design.name, design.body, design.mirror, design.network, design.fitting, {}},
      obstacle_(std::move(obstacle)),
      network_(design.network) {}

Result<DesignRunner> DesignRunner::start(const Design& design, const TriangleMesh& body) {
    Result<Obstacle> obstacle = Obstacle::of_body(body);
    if (!obstacle) return unexpected(obstacle.error());
    return DesignRunner(design, std::move(*obstacle));
}

Result<void> DesignRunner::take(const DesignStep& step) {
    Network next = network_;
    const auto with_line = [&](const std::function<Result<void>(SpaceLine)>& use) -> Result<void> {
        Result<SpaceLine> line = drawn_line(step.stroke, obstacle_);
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
            case Kind::Layer:
                break;
        }
        return {};
    }();
    if (!done) return unexpected(done.error().code, done.error().message, step_subject(step));
    network_ = std::move(next);
    return {};
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

Result<Garment> make_garment(const Design& design, const TriangleMesh& body) {
    Result<DesignRunner> runner = DesignRunner::start(design, body);
    if (!runner) return unexpected(runner.error());
    Garment garment{Network(design.network), {}, {}};
    int number = 0;
    for (const DesignStep& step : design.steps) {
        ++number;
        if (step.kind == Kind::Layer) {
            runner->next_layer(garment);
        } else if (const Result<void> done = runner->take(step); !done) {
            garment.faults.push_back({number, done.error().sentence()});
        }
    }
    runner->next_layer(garment);
    garment.network = runner->network();
    return garment;
}

}  // namespace core
