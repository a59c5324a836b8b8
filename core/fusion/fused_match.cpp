#include "core/fusion/fused_match.hpp"

namespace core {

Result<OutlineReadings> read_outline(const Polygon& contour, const ShapeParameters& parameters) {
    Result<ShapeDescriptor> parts = describe(contour, parameters);
    if (!parts) return unexpected(parts.error());
    Result<ContourDescriptor> whole = describe_contour(contour);
    if (!whole) return unexpected(whole.error());
    return OutlineReadings{std::move(*parts), *whole};
}

ComparableShape comparable(const ShapeDescriptor& parts, const ContourDescriptor& contour,
                           const ShapeParameters& parameters) {
    return {matchable(parts, parameters), matchable(contour)};
}

ComparableShape comparable(const OutlineReadings& readings, const ShapeParameters& parameters) {
    return comparable(readings.parts, readings.contour, parameters);
}

double FusedMatcher::distance_from(double contour, const ComparableShape& a, const ComparableShape& b,
                                   double give_up_at) {
    if (contour >= give_up_at) return contour;
    const double parts_give_up_at = (give_up_at - contour) * (kPartsScale / kPartsWeight);
    // A little above, so that rounding never makes a distance of one that was given up below the limit.
    const double parts = parts_.distance(a.parts, b.parts, parts_give_up_at * 1.0001);
    return fused_distance(parts, contour);
}

double FusedMatcher::distance(const ComparableShape& a, const ComparableShape& b, double give_up_at) {
    return distance_from(contour_.distance(a.contour, b.contour, give_up_at), a, b, give_up_at);
}

}  // namespace core
