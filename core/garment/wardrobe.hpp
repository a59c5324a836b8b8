#pragma once
// Worked designs, drawn stroke by stroke on a mannequin with the calls that the screen uses: a start for new ones, and
// what the engine is tested with.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/design.hpp"
#include "core/mannequin/mannequin.hpp"

namespace core {

/// "dress" (thesis, figures 3.1 to 3.6), "trousers", "outfit" (trousers, a jacket over them; 3.14), "jacket" (with
/// collar and pocket; 3.15), "skirt_flat" and "skirt_folds" (a wavy hem at alpha 0 and -0.25; 3.12).
[[nodiscard]] const std::vector<std::string>& wardrobe_names();

/// The design's strokes for this body. ErrorCode::BadArgument for a name that does not exist.
[[nodiscard]] Result<Design> wardrobe_design(std::string_view name, const Mannequin& body);

}  // namespace core
