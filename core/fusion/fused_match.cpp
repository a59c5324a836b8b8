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

namespace {

/// The distance of parts at which the fused one is given up. A little above, so that rounding never makes a distance of
/// one that was given up below the limit.
double parts_limit(double contour, double give_up_at) {
    return (give_up_at - contour) * (kPartsScale / kPartsWeight) * 1.0001;
}

}  // namespace

double FusedMatcher::distance_from(double contour, const ComparableShape& a, const ComparableShape& b,
                                   double give_up_at) {
    if (contour >= give_up_at) return contour;
    return fused_distance(parts_.distance(a.parts, b.parts, parts_limit(contour, give_up_at)), contour);
}

double FusedMatcher::distance_from(double contour, const ComparableShape& a, const PartsBound& bound,
                                   const ComparableShape& b, double give_up_at) {
    if (contour >= give_up_at) return contour;
    if (bound.is_at_least(b.parts, parts_limit(contour, give_up_at))) return give_up_at;
    return distance_from(contour, a, b, give_up_at);
}

double FusedMatcher::distance(const ComparableShape& a, const ComparableShape& b, double give_up_at) {
    return distance_from(contour_.distance(a.contour, b.contour, give_up_at), a, b, give_up_at);
}

}  // namespace core
