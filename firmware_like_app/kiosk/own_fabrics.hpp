#pragma once
// Fabrics of the studio's own: the PNG pictures of a folder, as tiles that repeat.

#include <filesystem>
#include <string>
#include <vector>

#include "core/silhouette/image.hpp"

namespace app {

struct OwnFabric {
    std::string name;     ///< of the file, without its ending
    std::string picture;  ///< the file; what designs call it
    core::RgbaImage tile;
};

struct OwnFabrics {
    std::vector<OwnFabric> fabrics;
    std::string problem;  ///< a sentence about the first picture that could not be read; empty: none
};

inline constexpr std::size_t kMostOwnFabrics = 10;
inline constexpr int kOwnTile_px = 256;

/// The first kMostOwnFabrics files *.png by name, each its largest square from the middle, kOwnTile_px wide at the
/// most, opaque. An empty path gives none. Pictures of more than 16 MB and what is no PNG are passed over and told.
[[nodiscard]] OwnFabrics read_own_fabrics(const std::filesystem::path& folder);

}  // namespace app
