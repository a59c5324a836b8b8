#pragma once
// OpenGL ES 3 without any screen (EGL surfaceless): pictures go to framebuffer objects and are read back.

#include <memory>

#include "ui/gl/context.hpp"

namespace ui {

/// Makes a context and makes it current on the calling thread. ErrorCode::NoDisplay, naming the missing packages, where
/// EGL has no surfaceless platform or no OpenGL ES 3.
[[nodiscard]] core::Result<std::unique_ptr<Context>> make_headless_context();

}  // namespace ui
