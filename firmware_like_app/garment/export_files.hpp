#pragma once
// What an export consists of, as bytes: nothing here touches a disk.

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/pattern/pattern.hpp"
#include "firmware_like_app/garment/dressed_design.hpp"

namespace app {

struct NamedBytes {
    std::string name;  ///< of the file, without a folder
    std::string bytes;
};

struct ExportPlan {
    bool model = true;          ///< garment.obj and garment.glb
    bool print_pattern = true;  ///< pattern.svg, pattern-a4.pdf, …, strain.svg
    bool cut_pattern = true;    ///< pattern.dxf, seams.json
    bool design = true;         ///< design.json, which `croquis garment` reads
    int pictures = 12;          ///< turn-01.png …, all round; 0: none
    int picture_px = 1024;      ///< high, 3/4 as wide
    core::PatternOptions pattern = {};
};

/// The garment and its objects, one named group a piece, in centimetres.
[[nodiscard]] core::Result<std::string> garment_obj(const DressedDesign& dressed);
/// The same in metres, in the pieces' colours.
[[nodiscard]] core::Result<std::string> garment_glb(const DressedDesign& dressed);
/// Both kinds of pattern, as the plan says. ErrorCode::EmptyMesh when no piece can be laid flat.
[[nodiscard]] core::Result<std::vector<NamedBytes>> pattern_files(const DressedDesign& dressed, const ExportPlan& plan);

/// The colour of a piece: its material's, or its layer's.
[[nodiscard]] core::Rgb piece_colour(const DressedDesign& dressed, std::size_t layer, const core::ClothPiece& piece);

/// The region of the network that a piece, or its mirror image, was made of.
[[nodiscard]] std::string region_of_piece(const core::ClothPiece& piece);
/// The layer's number in the order layers were made, which the look goes by; `layer` counts from the body outwards.
[[nodiscard]] std::size_t made_as(const DressedDesign& dressed, std::size_t layer);

}  // namespace app
