#pragma once
// A current OpenGL ES 3 context and the place its pictures go: a window, or nothing (framebuffer objects only).

#include "core/base/result.hpp"

namespace ui {

/// In pixels of the target.
struct SizePx {
    int width = 0;
    int height = 0;
    friend bool operator==(const SizePx&, const SizePx&) = default;
};

/// Owns the context of the thread that made it; everything in ui/gl and ui/draw must be destroyed before it.
class Context {
  public:
    Context() = default;
    virtual ~Context() = default;
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
};

}  // namespace ui
