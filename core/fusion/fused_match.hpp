#pragma once
// Two readings of a shape that fail differently, in one distance: its parts (core/match) and its whole contour
// (core/contour). Which part answers to which stays what the parts say.
//
//     core::Result<core::OutlineReadings> a = core::read_outline(contour);
//     core::FusedMatcher matcher;
//     matcher.distance(core::comparable(*a), core::comparable(*b));

#include <limits>

#include "core/base/result.hpp"
#include "core/contour/contour_match.hpp"
#include "core/fusion/parts_bound.hpp"
#include "core/match/match.hpp"
#include "core/parts/describe.hpp"

namespace core {

/// Both descriptors of one outline.
struct OutlineReadings {
    ShapeDescriptor parts;
    ContourDescriptor contour;
};

/// The contour as largest_contour gives it. BadOutline where either reading has nothing to describe.
[[nodiscard]] Result<OutlineReadings> read_outline(const Polygon& contour, const ShapeParameters& parameters = {});

/// Both readings made ready for matching.
struct ComparableShape {
    MatchableShape parts;
    MatchableContour contour;
};
[[nodiscard]] ComparableShape comparable(const ShapeDescriptor& parts, const ContourDescriptor& contour,
                                         const ShapeParameters& parameters = {});
[[nodiscard]] ComparableShape comparable(const OutlineReadings& readings, const ShapeParameters& parameters = {});

/// What distances of the parts are divided by, so that 1 is the median between classes, and nearly so for the contour.
inline constexpr double kPartsScale = 80.0;
/// Weight of the parts beside the contour's 1. Kimia-99 / Kimia-216, per cent: the contour alone 98.0 / 98.3; with 0.1,
/// 0.2, 0.35, 0.5 of the parts 98.2 / 98.2, 98.2 / 98.1, 98.1 / 98.0, 97.8 / 97.7; the parts alone 95.3 / 94.9. Chosen
/// along with the spacing of the contour's points on all classes but one, 0.2 comes out whichever is left out.
inline constexpr double kPartsWeight = 0.2;

/// Contours that differ less are those of one shape, or nearly, and their parts then differ by where the outlines were
/// cut, not by what they are: so the parts count less, the nearer the contours. Half of the pairs within a class are
/// nearer. From 0.05 to 0.6 nothing changes on the Kimia sets, but a turned or scaled copy is nearer to its original.
inline constexpr double kNearlyEqualContours = 0.3;

/// What a distance of the parts counts for beside this distance of the contours.
[[nodiscard]] constexpr double parts_share(double contour) {
    const double nearness = contour / kNearlyEqualContours;
    return kPartsWeight / kPartsScale * (nearness < 1.0 ? nearness : 1.0);
}

/// The sum that ranks. It never falls when one of the two grows.
[[nodiscard]] constexpr double fused_distance(double parts, double contour) {
    return contour + parts_share(contour) * parts;
}

/// The distance of the parts from which on the fused one is not below `give_up_at`. A little above, so that rounding
/// never makes a distance of one that was given up below the limit. Infinite where the parts do not count.
[[nodiscard]] double parts_limit(double contour, double give_up_at);

/// Working memory for both; one per thread.
class FusedMatcher {
  public:
    /// fused_distance of both distances. >= 0, symmetric, 0 for equal shapes. As soon as it cannot come below
    /// `give_up_at`, some value not below `give_up_at` comes back.
    [[nodiscard]] double distance(const ComparableShape& a, const ComparableShape& b,
                                  double give_up_at = std::numeric_limits<double>::infinity());
    /// The same where the contour's distance is known.
    [[nodiscard]] double distance_from(double contour, const ComparableShape& a, const ComparableShape& b,
                                       double give_up_at = std::numeric_limits<double>::infinity());
    /// The same, with the parts compared only where their bound, which is that of `a`, leaves it open: for one shape
    /// against many.
    [[nodiscard]] double distance_from(double contour, const ComparableShape& a, const PartsBound& bound,
                                       const ComparableShape& b, double give_up_at);

    [[nodiscard]] Matcher& parts() { return parts_; }
    [[nodiscard]] ContourMatcher& contour() { return contour_; }

  private:
    Matcher parts_;
    ContourMatcher contour_;
};

}  // namespace core
