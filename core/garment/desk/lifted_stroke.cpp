#include "core/garment/desk/lifted_stroke.hpp"

namespace core {

LiftedStroke::LiftedStroke(const SketchStroke& stroke, const Obstacle& body) {
    StrokeLifter lifter(body);
    for (std::size_t k = 0; k < stroke.size(); ++k) {
        lifter.begin_part(stroke[k].view, stroke[k].tool);
        for (const Point at : stroke[k].points) {
            const std::size_t before = lifter.line().size();
            const Result<void> done = lifter.add(at);
            if (!done && !fault) {
                fault = done.error();
                fault_part = k;
                if (!lifter.line().empty()) fault_place = lifter.line().back();
            }
            const bool lies = done && !lifter.line().empty() && (lifter.line().size() > before || before > 0);
            samples.push_back({k, at, lies ? std::optional<Vec3>(lifter.line().back()) : std::nullopt});
        }
    }
}

SketchStroke LiftedStroke::stroke(const SketchStroke& like, std::size_t first, std::size_t end) const {
    SketchStroke out;
    std::size_t part = ~std::size_t{0};
    for (std::size_t k = first; k < end; ++k) {
        if (samples[k].part != part) {
            part = samples[k].part;
            out.push_back({like[part].view, like[part].tool, {}});
        }
        out.back().points.push_back(samples[k].drawn);
    }
    return out;
}

SketchStroke on_drawn_half(const SketchStroke& stroke, const Obstacle& body, double snap_cm) {
    SketchStroke own = stroke;
    LiftedStroke lifted(own, body);
    std::size_t beyond = 0, here = 0;
    for (const auto& sample : lifted.samples) {
        if (!sample.place) continue;
        beyond += sample.place->x < -0.5 * snap_cm ? 1U : 0U;
        here += sample.place->x > 0.5 * snap_cm ? 1U : 0U;
    }
    if (beyond == 0) return own;
    if (beyond > here) {
        for (StrokePart& part : own) part = mirrored_part(std::move(part));
        lifted = LiftedStroke(own, body);
    }
    const auto [first, end] = lifted.longest([](const auto& sample) { return sample.place && sample.place->x >= 0.0; });
    SketchStroke out = lifted.stroke(own, first, end);
    if (out.empty()) return own;
    const auto crossing = [&](const auto& inside, const auto& outside) -> std::optional<Point> {
        if (!outside.place || outside.part != inside.part) return std::nullopt;
        const double t = inside.place->x / (inside.place->x - outside.place->x);
        return inside.drawn + (outside.drawn - inside.drawn) * t;
    };
    if (first > 0)
        if (const auto at = crossing(lifted.samples[first], lifted.samples[first - 1]); at)
            out.front().points.insert(out.front().points.begin(), *at);
    if (end < lifted.samples.size())
        if (const auto at = crossing(lifted.samples[end - 1], lifted.samples[end]); at)
            out.back().points.push_back(*at);
    return out;
}

}  // namespace core
