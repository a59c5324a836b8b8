#pragma once
// Why something was not done, as notes to the designer.

#include "core/base/error.hpp"
#include "core/garment/design.hpp"
#include "core/garment/desk/desk_tool.hpp"

namespace core {

/// Why a sample of this part cannot lie in space: only its tool tells.
[[nodiscard]] DeskNote note_of_lift(const StrokePart& part, const Error& error, Vec3 place);

/// Why a step was refused in this state.
[[nodiscard]] DeskNote note_of_step(const DesignStep& step, const DesignRunner& state, const Error& error, Vec3 place);

/// A reply that did nothing but say why.
[[nodiscard]] DeskReply told(DeskNote::Key key, const char* sentence, Vec3 place);

}  // namespace core
