#pragma once
// Fabrics made by code: one tile of each, which repeats without a seam. No GL.

#include <array>
#include <string>
#include <string_view>

#include "core/silhouette/image.hpp"
#include "ui/draw/palette.hpp"

namespace ui {

enum class Fabric { Plain, Linen, Denim, Stripe, Check, Dots, Knit, Herringbone };
inline constexpr int kFabricCount = 8;

/// "plain", "linen", …: what designs call them.
[[nodiscard]] std::string_view fabric_name(Fabric fabric);
/// The fabric of a name; Plain for any other.
[[nodiscard]] Fabric fabric_of(std::string_view name);

/// Width and height of one tile on the cloth.
[[nodiscard]] double fabric_tile_cm(Fabric fabric);

/// The tile in this colour, kFabricTile_px wide and high, opaque. The same arguments give the same bytes.
inline constexpr int kFabricTile_px = 128;
[[nodiscard]] core::RgbaImage weave(Fabric fabric, Colour colour);

/// "#rrggbb" as the design file writes it; nothing else is a colour: `otherwise`.
[[nodiscard]] Colour colour_of(std::string_view hex, Colour otherwise);
[[nodiscard]] std::string hex_of(Colour colour);

}  // namespace ui
