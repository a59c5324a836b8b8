#pragma once
// Texture coordinates of cloth, in real units: a pattern printed on the fabric keeps its size on the garment.

#include <string>
#include <vector>

#include "core/garment/cloth.hpp"

namespace core {

struct TextureReport {
    double mean_strain = 0.0, largest_strain = 0.0;  ///< of the flat cloth against the garment, 0.01 is 1 %
    std::vector<std::string> left_out;               ///< pieces that cannot be laid flat; their coordinates are 0
};

/// Lays every piece flat (core/garment/pattern/flatten.hpp) and keeps where each corner of each quad lies, in the
/// cloth's unit: up along the piece, each piece from 0. A mirrored piece gets its original's coordinates with x
/// reversed, so that prints run on across the middle. Cost: flatten, without length rounds, for each piece.
TextureReport lay_texture(Cloth& cloth);

}  // namespace core
