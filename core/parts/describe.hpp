#pragma once
// From an outline to its part descriptor: chapter 5 in one call.

#include "core/base/result.hpp"
#include "core/parts/depth.hpp"
#include "core/parts/descriptor.hpp"
#include "core/silhouette/image.hpp"

namespace core {

/// A descriptor with the steps that led to it, for pictures and tests.
struct DescribedShape {
    Skeleton skeleton;
    PartTree tree;
    ShapeDescriptor descriptor;
};

/// Describes an anti-clockwise contour (y up). A shape that falls into fewer than two parts has the whole outline as
/// its only terminal, so that everything has a finite distance to everything. BadOutline when it encloses no area.
[[nodiscard]] Result<DescribedShape> describe_in_steps(const Polygon& contour, const ShapeParameters& parameters = {});

/// The descriptor alone.
[[nodiscard]] Result<ShapeDescriptor> describe(const Polygon& contour, const ShapeParameters& parameters = {});

/// Stop points of a ring of parts, ascending (6.1): terminals in no wing, or first in every wing that holds them.
/// `backwards` asks for those of the clockwise ring: last in every wing. Never empty when there are terminals.
[[nodiscard]] std::vector<int> stop_points(const std::vector<Part>& parts, int terminal_count, bool backwards);

}  // namespace core
