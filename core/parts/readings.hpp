#pragma once
// Several segmentations of one outline. Where a corner, a chord or a threshold is near its edge, two outlines that look
// the same fall into different parts; readings of the same outline with slightly different sampling rarely all do. A
// distance is the mean over the readings, each compared with the same reading of the other shape.
//
// What it gained (sum of Kimia-99 and Kimia-216, per cent): the first reading alone 169.8, the first and second 175.9,
// all three 178.3, seven 180.0.

#include <vector>

#include "core/parts/describe.hpp"

namespace core {

/// Descriptors of one outline by reading_parameters(0 …); the first is the thesis's own, and the one that is shown.
using ShapeReadings = std::vector<ShapeDescriptor>;

inline constexpr std::size_t kReadingCount = 3;

/// The first reading is `base` itself; the second takes a fifth more samples; the third smooths the contour half as
/// much again.
[[nodiscard]] ShapeParameters reading_parameters(std::size_t reading, const ShapeParameters& base);

/// All further readings of a contour: those after the first. A reading that fails where the first did not (an outline
/// that a stronger smoothing makes vanish) repeats `first`, so that every shape has kReadingCount.
[[nodiscard]] ShapeReadings further_readings(const Polygon& contour, const ShapeDescriptor& first,
                                             const ShapeParameters& base = {});

/// All readings. BadOutline when the contour encloses no area.
[[nodiscard]] Result<ShapeReadings> describe_readings(const Polygon& contour, const ShapeParameters& base = {});

}  // namespace core
