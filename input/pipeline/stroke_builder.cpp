#include "input/pipeline/stroke_builder.hpp"

#include <algorithm>
#include <utility>

namespace input {

std::optional<PenStroke> StrokeBuilder::add(const PenSample& s) {
    const auto open =
        std::find_if(open_.begin(), open_.end(), [&](const PenStroke& o) { return o.device == s.device; });
    const bool draws = s.in_range && s.tip && s.x && s.y;
    if (open != open_.end() && draws && open->tool == s.tool) {
        open->samples.push_back(s);
        return std::nullopt;
    }
    std::optional<PenStroke> ended = end(s.device);
    if (draws) open_.push_back({s.device, s.tool, {s}});
    return ended;
}

std::optional<PenStroke> StrokeBuilder::end(std::uint32_t device) {
    const auto open = std::find_if(open_.begin(), open_.end(), [&](const PenStroke& o) { return o.device == device; });
    if (open == open_.end()) return std::nullopt;
    PenStroke ended = std::move(*open);
    open_.erase(open);
    return ended;
}

std::vector<PenStroke> StrokeBuilder::finish() {
    std::vector<PenStroke> ended = std::exchange(open_, {});
    std::sort(ended.begin(), ended.end(), [](const PenStroke& a, const PenStroke& b) { return a.device < b.device; });
    return ended;
}

std::vector<PenStroke> strokes_of(const std::vector<PenSample>& samples) {
    StrokeBuilder builder;
    std::vector<PenStroke> strokes;
    for (const PenSample& s : samples) {
        if (auto ended = builder.add(s)) strokes.push_back(std::move(*ended));
    }
    for (PenStroke& last : builder.finish()) strokes.push_back(std::move(last));
    return strokes;
}

core::Drawing drawing_of(const std::vector<PenStroke>& strokes) {
    core::Drawing drawing;
    std::optional<std::int64_t> start_ns;
    for (const PenStroke& stroke : strokes) {
        if (stroke.tool == PenTool::Eraser || stroke.tool == PenTool::Lens || stroke.tool == PenTool::Mouse) continue;
        if (!start_ns || stroke.samples.front().time_ns < *start_ns) start_ns = stroke.samples.front().time_ns;
    }
    for (const PenStroke& stroke : strokes) {
        if (stroke.tool == PenTool::Eraser || stroke.tool == PenTool::Lens || stroke.tool == PenTool::Mouse) continue;
        core::Stroke& s = drawing.strokes.emplace_back();
        for (const PenSample& sample : stroke.samples) s.samples.push_back(to_core(sample, *start_ns));
    }
    return drawing;
}

}  // namespace input
