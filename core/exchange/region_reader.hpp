#pragma once
// Regions of cloth from JSON: {"sides": [[[x, y, z], …], …]}.

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/garment/region.hpp"

namespace core {

/// The sides as they are written; their geometry is not looked at (outline_ring does that). ErrorCode::BadFormat for
/// text that is no JSON, is longer than 16 MB, has no "sides", or has a side that is no list of three numbers each.
[[nodiscard]] Result<RegionOutline> parse_region(std::string_view text);

/// The same from a file, named in the error.
[[nodiscard]] Result<RegionOutline> read_region(const std::string& path);

}  // namespace core
