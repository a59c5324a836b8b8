#pragma once
// SVG path data, point lists and transforms as plain geometry (SVG 1.1, chapters 7.6, 8.3 and 9).

#include <optional>
#include <string_view>
#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// x' = a x + c y + e, y' = b x + d y + f, as SVG's matrix(a b c d e f).
struct Affine {
    double a = 1.0, b = 0.0, c = 0.0, d = 1.0, e = 0.0, f = 0.0;
    [[nodiscard]] Point operator()(Point p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    /// First `inner`, then this.
    [[nodiscard]] Affine after(const Affine& inner) const;
};

/// Largest number of points that one path or list may give.
inline constexpr std::size_t kMaxSvgPoints = 1'000'000;

/// Each Bézier curve becomes this many chords; an arc one for every 1/32 of a turn it covers.
inline constexpr int kChordsPerCurve = 24;

/// The subpaths of a "d" attribute, all commands (M L H V C S Q T A Z), relative and absolute; curves flattened, a
/// closed subpath ends with its first point. Nothing when the data is damaged, holds numbers out of range or too many
/// points. Linear time.
[[nodiscard]] std::optional<std::vector<Polyline>> parse_svg_path(std::string_view data);

/// The "points" of a polyline. Nothing when damaged or odd in number.
[[nodiscard]] std::optional<Polyline> parse_svg_points(std::string_view data);

/// A "transform" attribute: matrix, translate, scale, rotate, skewX, skewY in a row. Nothing when damaged.
[[nodiscard]] std::optional<Affine> parse_svg_transform(std::string_view text);

/// The number that a length begins with, its unit left aside; 0 for an empty text. Nothing when there is no number.
[[nodiscard]] std::optional<double> parse_svg_length(std::string_view text);

/// An ellipse as a closed chain of 64 chords.
[[nodiscard]] Polyline ellipse_chain(Point centre, double radius_x, double radius_y);

}  // namespace core
