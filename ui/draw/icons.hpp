#pragma once
// The icons of the design as strokes on a 32 × 32 grid with round ends.

#include <vector>

#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"

namespace ui {

enum class Icon {
    Pen,
    Eraser,
    Undo,
    Redo,
    New,
    Hand,
    Collection,
    Warning,
    Tablet,
    Back,
    Check,
    Minus,
    Plus,
    Turn,
    // of Garment
    OnPlane,
    OnBody,
    TemporaryPlane,
    Corner,
    Cut,
    Add,
    Mirror,
    Move,
    Smooth,
    Bump,
    Weld,
    Hole,
    Remove,
    Measure,
    Fabric,
    Quads,
    Drape,
    Designs,
    Eye,
    EyeShut,
    Tape,
    Export,
    Close,
    Up,
    Down,
    Layers
};
inline constexpr int kIconCount = static_cast<int>(Icon::Layers) + 1;

/// Polylines on the 32 grid, y down; curves come as short chords.
[[nodiscard]] const std::vector<core::Polyline>& icon_strokes(Icon icon);

/// The icon drawn size_px wide and high with lines line_px thick, as coverage. Linear in pixels times chords.
[[nodiscard]] core::GrayImage rasterise_icon(Icon icon, int size_px, double line_px);

}  // namespace ui
