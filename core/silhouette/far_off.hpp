#pragma once
// Stray marks that lie far off: they must not decide what is small on the drawing.

#include <algorithm>

#include "core/silhouette/ink.hpp"

namespace core {

/// An object smaller than this share of all that is drawn is laid out again on its own.
inline constexpr double kFarOffShare = 0.7;

[[nodiscard]] inline bool rest_is_far_off(const GridBox& object, const GridBox& all) {
    const auto larger = [](const GridBox& b) { return std::max(b.right - b.left, b.bottom - b.top); };
    return larger(object) <= kFarOffShare * larger(all);
}

/// The samples that lie within the box, grid pixels of the layout. A stroke that leaves the box and comes back becomes
/// two. Linear.
[[nodiscard]] inline Drawing part_within(const Drawing& drawing, const DrawingLayout& layout, const GridBox& box) {
    Drawing part;
    for (const Stroke& stroke : drawing.strokes) {
        bool inside = false;
        for (const PenSample& s : stroke.samples) {
            const FixedPoint p = layout.place(s);
            const bool here = p.x >= box.left * kSubpixels && p.x <= box.right * kSubpixels &&
                              p.y >= box.top * kSubpixels && p.y <= box.bottom * kSubpixels;
            if (here && !inside) part.strokes.emplace_back();
            if (here) part.strokes.back().samples.push_back(s);
            inside = here;
        }
    }
    return part;
}

}  // namespace core
