#pragma once
// Open lines in space: length, places along them, resampling, smoothing that keeps what was drawn.

#include <vector>

#include "core/geometry/point.hpp"

namespace core {

using SpaceLine = std::vector<Vec3>;

[[nodiscard]] double line_length(const SpaceLine& line);

/// The place `along` from the start, clamped to the line. The line must not be empty. Linear.
[[nodiscard]] Vec3 place_along(const SpaceLine& line, double along);

/// `edges` + 1 points at equal distances along the line; ends stay as they are, bit for bit. edges >= 1.
[[nodiscard]] SpaceLine resampled(const SpaceLine& line, int edges);

/// Moves the ends of a line to given places; what lies between follows in proportion to its distance from them.
void pull_ends(SpaceLine& line, Vec3 first, Vec3 last);

/// The nearest place on a line.
struct NearestOnLine {
    double along = 0.0, distance = 0.0;
    Vec3 place;
};
[[nodiscard]] NearestOnLine nearest_on_line(const SpaceLine& line, Vec3 point);

/// The two pieces at `along`, which must lie inside the line.
struct SplitLine {
    SpaceLine before, after;
};
[[nodiscard]] SplitLine split_line(const SpaceLine& line, double along);

/// The trembling of a hand taken out, waves longer than about 8 `spacing` kept: the line resampled at `spacing` and
/// passed through `passes` rounds of a filter that does not shrink (Taubin 1995). Ends stay.
[[nodiscard]] SpaceLine smoothed(const SpaceLine& line, double spacing, int passes);

/// Places along a line where it turns by more than `angle` within `reach` to either side, the sharpest of each
/// neighbourhood, in order; ends are none.
[[nodiscard]] std::vector<double> sharp_turns(const SpaceLine& line, double angle, double reach);

}  // namespace core
