#pragma once
// The window of the kiosk: full screen or in a frame, with an OpenGL ES 3 context through EGL, and what happens to it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ui/gl/context.hpp"

namespace ui {

/// What a mouse, a finger, a pen or the window manager did. Positions are in pixels of the drawable, y down.
struct WindowEvent {
    /// Leave: the pen is out of range, nothing points any more. TakeBack: what began with the last Down was a palm.
    /// Cancel: what pointed is gone, with its device.
    enum class Kind {
        Down,
        Move,
        Up,
        Cancel,
        Resized,
        Exposed,
        FocusLost,
        FocusGained,
        Close,
        Escape,
        Leave,
        TakeBack,
        Zoom  ///< a wheel, or two fingers that move apart
    };
    Kind kind = Kind::Move;
    double x = 0.0;
    double y = 0.0;
    double pressure = 1.0;     ///< 0 … 1; 1 for the mouse and for fingers that report none
    std::int64_t time_us = 0;  ///< when it happened, on the clock of Window::now_us()
    bool finger = false;
    bool pen = false;                     ///< of a tablet; a Move without a Down before it is one that hovers
    bool eraser = false;                  ///< the pen's other end
    bool button = false;                  ///< a pen with its button held, or the mouse's other button
    double zoom = 0.0;                    ///< of Zoom: doublings of the size
    double shift_x = 0.0, shift_y = 0.0;  ///< of Zoom: how far two fingers moved together
    /// How far the pen leans from upright, radians; nothing where the tablet does not say.
    std::optional<double> tilt_rad = {};
};

struct WindowOptions {
    SizePx size{1920, 1080};  ///< of the framed window; full screen takes the screen's own size
    bool full_screen = true;
    std::string title = "Croquis";
};

/// One pointer at a time: the first finger or the left button; others are ignored until it lifts.
class Window : public Context {
  public:
    /// Opens the window and makes its context current. ErrorCode::NoDisplay with what SDL says where it cannot.
    [[nodiscard]] static core::Result<std::unique_ptr<Window>> open(const WindowOptions& options);

    /// Everything since the last call, in order. Does not wait.
    [[nodiscard]] virtual std::vector<WindowEvent> poll() = 0;
    /// Size of the drawable, which a resize changes.
    [[nodiscard]] virtual SizePx size() const = 0;
    /// Shows what was drawn; waits for the screen's next refresh where the driver offers that.
    virtual void present() = 0;
    /// Monotonic microseconds, the clock of the events.
    [[nodiscard]] virtual std::int64_t now_us() const = 0;
    /// False while minimised or hidden: nothing needs to be drawn then.
    [[nodiscard]] virtual bool visible() const = 0;
    /// Whether input comes from a desktop, which sees to it, and not from the devices themselves (KMSDRM).
    [[nodiscard]] virtual bool has_desktop() const = 0;
};

}  // namespace ui
