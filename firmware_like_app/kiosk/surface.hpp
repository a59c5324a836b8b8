#pragma once
// Where frames go: a window, or a picture that is read back. The loop is the same for both.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/silhouette/image.hpp"
#include "ui/gl/objects.hpp"
#include "ui/gl/window.hpp"

namespace app {

class Surface {
  public:
    virtual ~Surface() = default;
    [[nodiscard]] virtual ui::SizePx size() const = 0;
    /// Input since the last call; none without a window.
    [[nodiscard]] virtual std::vector<ui::WindowEvent> poll() = 0;
    /// Microseconds: real time for a window; a virtual clock that only next_frame() moves for pictures.
    [[nodiscard]] virtual std::int64_t now_us() const = 0;
    /// Whether every frame is seen, so that it must be drawn.
    [[nodiscard]] virtual bool shows_frames() const = 0;
    /// Why no input can come, as a code for whoever is called; empty where some can. Looks at the devices.
    [[nodiscard]] virtual std::string no_input_code() const = 0;
    /// Directs drawing here. True when the first row is the bottom one.
    virtual bool bind() = 0;
    /// After bind(): whether what was drawn the last time is still there, so that only changes need be drawn.
    [[nodiscard]] virtual bool kept() const = 0;
    /// Shows the frame (when one was drawn), calls `meanwhile`, and goes on to the next frame when it is due. Where it
    /// waits for that and not for the screen, it calls `look`, if there is one, every 2 ms.
    virtual void next_frame(bool drawn, const std::function<void()>& meanwhile, const std::function<void()>& look) = 0;
    /// What was drawn since bind().
    [[nodiscard]] virtual core::RgbaImage read_back() = 0;
};

/// Opens the window; see ui::Window::open.
[[nodiscard]] core::Result<std::unique_ptr<Surface>> open_window_surface(const ui::WindowOptions& options);
/// See ui::make_headless_context. Frames are 1/60 s apart.
[[nodiscard]] core::Result<std::unique_ptr<Surface>> make_headless_surface(ui::SizePx size);

}  // namespace app
