#include "core/fusion/fused_match.hpp"

#include <algorithm>

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

double parts_limit(double contour, double give_up_at) {
    const double share = parts_share(contour);
    return share > 0.0 ? (give_up_at - contour) / share * 1.0001 : std::numeric_limits<double>::infinity();
}

double FusedMatcher::distance_from(double contour, const ComparableShape& a, const ComparableShape& b,
                                   double give_up_at) {
    if (contour >= give_up_at || contour == 0.0) return contour;
    return fused_distance(parts_.distance(a.parts, b.parts, parts_limit(contour, give_up_at)), contour);
}

double FusedMatcher::distance_from(double contour, const ComparableShape& a, const PartsBound& bound,
                                   const ComparableShape& b, double give_up_at) {
    if (contour >= give_up_at || contour == 0.0) return contour;
    const double limit = parts_limit(contour, give_up_at);
    const LeastOutlines least = bound.least_outlines(b.parts);
    if (configuration_distance(0.0F, std::min(least.along, least.against)) >= static_cast<float>(limit)) {
        return give_up_at;
    }
    return fused_distance(parts_.distance(a.parts, b.parts, limit, least), contour);
}

double FusedMatcher::distance(const ComparableShape& a, const ComparableShape& b, double give_up_at) {
    return distance_from(contour_.distance(a.contour, b.contour, give_up_at), a, b, give_up_at);
}

}  // namespace core
