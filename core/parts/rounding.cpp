#include "core/parts/rounding.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/point_grid.hpp"
#include "core/geometry/polygon.hpp"
#include "core/parts/features.hpp"

namespace core {

namespace {

Part measured(const Polygon& samples, const ArcMeasures& arcs, const Part& part, const ShapeParameters& p) {
    Part again = measure_part(samples, arcs, {part.start_sample, part.end_sample}, p);
    again.first_terminal = part.first_terminal;
    again.terminal_count = part.terminal_count;
    again.salient = part.salient;
    return again;
}

bool is_finite(const Part& part) {
    const auto finite = [](float f) { return std::isfinite(f); };
    return std::all_of(part.features.begin(), part.features.end(), finite) &&
           std::all_of(part.signature.begin(), part.signature.end(), finite);
}

bool can_be_measured(const ShapeDescriptor& shape) {
    const auto names_samples = [n = static_cast<int>(shape.samples.size())](const Part& part) {
        return part.start_sample >= 0 && part.start_sample < n && part.end_sample >= 0 && part.end_sample < n;
    };
    return shape.samples.size() >= 3 && signed_area(shape.samples) > 0.0 &&
           std::all_of(shape.parts.begin(), shape.parts.end(), names_samples);
}

}  // namespace

bool measure_again(ShapeDescriptor& shape, const ShapeParameters& p) {
    const ArcMeasures arcs(shape.samples);
    bool finite = true;
    for (Part& part : shape.parts) {
        part = measured(shape.samples, arcs, part, p);
        finite = finite && is_finite(part);
    }
    shape.whole = measure_part(shape.samples, arcs, {0, 0}, p);
    return finite && is_finite(shape.whole);
}

bool is_measured(const ShapeDescriptor& shape, const ShapeParameters& p) {
    if (!can_be_measured(shape)) return false;
    const ArcMeasures arcs(shape.samples);
    const auto is = [&](const Part& part) { return measured(shape.samples, arcs, part, p) == part; };
    return measure_part(shape.samples, arcs, {0, 0}, p) == shape.whole &&
           std::all_of(shape.parts.begin(), shape.parts.end(), is);
}

std::optional<ShapeDescriptor> rounded(const ShapeDescriptor& shape, const ShapeParameters& p) {
    if (!is_measured(shape, p)) return std::nullopt;
    ShapeDescriptor out = shape;
    const int exponent = finest_grid(out.samples, kOutlineSteps);
    for (Point& sample : out.samples) sample = on_grid(sample, exponent);
    const auto length = static_cast<float>(out.skeletal_length);
    out.skeletal_length = static_cast<double>(length);
    if (!std::isfinite(length) || !(signed_area(out.samples) > 0.0) || !measure_again(out, p)) return std::nullopt;
    return out;
}

}  // namespace core
