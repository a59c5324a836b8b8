#pragma once
// Pictures that explain the shape method: the steps from a silhouette to its parts, and two shapes with their matched
// parts in the same colours. Drawn with Cairo, no screen needed.

#include <array>
#include <string>
#include <vector>

#include "core/match/match.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/parts/describe.hpp"

namespace ui {

/// The eight part colours of the design, in order of size.
inline constexpr std::array<core::Rgb, 8> kPartColours{{{0x75, 0xC4, 0xF1},
                                                        {0x8E, 0x87, 0x2C},
                                                        {0x7B, 0x77, 0xCF},
                                                        {0xC6, 0x90, 0x8A},
                                                        {0x73, 0x45, 0x41},
                                                        {0x12, 0x7C, 0x7D},
                                                        {0x33, 0x4A, 0x81},
                                                        {0x9D, 0xCD, 0x36}}};

/// One panel a step (corners and samples, triangles, chords, polygons, significant pieces and skeleton, depth,
/// terminals, wings), written as PNG. WriteFailed when the file cannot be written.
[[nodiscard]] core::Result<void> write_description_picture(const core::DescribedShape& shape, const std::string& title,
                                                           const std::string& path);

struct MatchPictureItem {
    const core::ShapeDescriptor* a = nullptr;
    const core::ShapeDescriptor* b = nullptr;
    const core::Match* match = nullptr;
    std::string title_a, title_b;
};

/// One row a match: both shapes, matched parts in the same colour and with the same number, paler the rest of a limb
/// whose tip was matched, parts left out in clay.
[[nodiscard]] core::Result<void> write_match_picture(const std::vector<MatchPictureItem>& items,
                                                     const std::string& path);

/// One match with both shapes and, below each, its ring of parts as a disk, as in thesis fig. 1.5: terminals are the
/// sectors of the rim, wings the arcs within, both anti-clockwise from the best start at the top (the second clockwise
/// where it was read mirrored, so that matched sectors lie alike). Names are those of the terminals, beside the rim;
/// none or one for each.
struct RingNames {
    std::vector<std::string> a, b;
};
[[nodiscard]] core::Result<void> write_ring_picture(const MatchPictureItem& item, const RingNames& names,
                                                    const std::string& path);

/// A contact sheet of final segmentations: junctions, sleeves and terminals with the skeleton over them.
[[nodiscard]] core::Result<void> write_segmentation_sheet(const std::vector<core::DescribedShape>& shapes,
                                                          const std::vector<std::string>& titles, int columns,
                                                          const std::string& path);

}  // namespace ui
