#pragma once
// Whatever holds a pen's movements, as a trace: a trace itself, a recording of another program, or a drawing.

#include <string>

#include "core/base/result.hpp"
#include "input/trace/trace.hpp"

namespace input {

struct AnyInk {
    Trace trace;
    std::string format;   ///< "trace", "usbhid-dump", …, "drawing"
    std::string warning;  ///< what is wrong but did not stop the reading, as a sentence; empty for nothing
};

/// Looks at the content first, then at the extension. UnknownFormat naming what could be given; a recording in which no
/// pen is gives BadFormat with the reason.
[[nodiscard]] core::Result<AnyInk> read_any_ink(const std::string& path_spec);

/// What was drawn in it, by today's decoders, for those who want strokes and nothing else. EmptyDrawing where no pen
/// draws.
[[nodiscard]] core::Result<core::Drawing> read_drawing_of_ink(const std::string& path_spec);

}  // namespace input
