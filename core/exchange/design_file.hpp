#pragma once
// Garment designs as JSON; core/exchange/README.md has the format.

#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/garment/design.hpp"

namespace core {

/// 2 added landmarks at the ends of lines and the parts of the body that regions lie over; 3 pieces of lines, layers
/// in any order, materials, other bodies, placed objects, and which steps are one act; 4 the
/// length of quads as a step, and temporary planes off their point.
inline constexpr int kDesignVersion = 4;

/// Reads a design of this version or an older one. ErrorCode::BadFormat with the step at fault (from 1) for text that
/// is no JSON or ends early, a missing or wrong field, an unknown step, view, tool or size; ErrorCode::NewerVersion for
/// a design of a later version.
[[nodiscard]] Result<Design> parse_design(std::string_view text);
[[nodiscard]] Result<Design> read_design(const std::string& path);

/// The same design gives the same bytes, and is read back as it was.
[[nodiscard]] std::string design_text(const Design& design);

/// One step as design_text writes it, on one line, and back; for journals. ErrorCode::BadFormat as above.
[[nodiscard]] Result<DesignStep> parse_step(std::string_view text);
[[nodiscard]] std::string step_text(const DesignStep& step);

}  // namespace core
