#include "ui/gl/window.hpp"

#include <SDL.h>

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <utility>

#include "ui/gl/mouse_buttons.hpp"

namespace ui {
namespace {

constexpr SDL_FingerID kMouse = -1;
constexpr double kWheelStep = 0.2;   // doublings a notch
constexpr double kSpreadStep = 4.0;  // doublings when two fingers move apart by the screen's width

class SdlWindow final : public Window {
  public:
    SdlWindow(SDL_Window* window, SDL_GLContext context) : window_(window), context_(context) {}
    ~SdlWindow() override {
        SDL_GL_DeleteContext(context_);
        SDL_DestroyWindow(window_);
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
    }

    std::vector<WindowEvent> poll() override {
        std::vector<WindowEvent> events;
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0) translate(event, events);
        let_lost_finger_go(events);
        return events;
    }

    SizePx size() const override {
        SizePx size;
        SDL_GL_GetDrawableSize(window_, &size.width, &size.height);
        return size;
    }

    void present() override { SDL_GL_SwapWindow(window_); }

    std::int64_t now_us() const override {
        const std::uint64_t ticks = SDL_GetPerformanceCounter(), rate = SDL_GetPerformanceFrequency();
        return static_cast<std::int64_t>(ticks / rate * 1000000 + ticks % rate * 1000000 / rate);
    }

    bool visible() const override {
        return (SDL_GetWindowFlags(window_) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) == 0;
    }

    bool has_desktop() const override {
        const char* driver = SDL_GetCurrentVideoDriver();
        return driver == nullptr || std::string_view(driver) != "KMSDRM";
    }

  private:
    /// SDL stamps events in milliseconds since its start.
    std::int64_t event_time_us(std::uint32_t milliseconds) const {
        return now_us() - static_cast<std::int64_t>(SDL_GetTicks() - milliseconds) * 1000;
    }

    void pointer(std::vector<WindowEvent>& events, WindowEvent::Kind kind, SDL_FingerID id, double x, double y,
                 double pressure, std::uint32_t stamp) {
        if (kind == WindowEvent::Kind::Down) {
            if (held_) return;
            held_ = id;
        } else if (held_ ? *held_ != id : id != kMouse || kind != WindowEvent::Kind::Move) {
            return;
        }
        if (kind == WindowEvent::Kind::Up) held_.reset();
        if (kind == WindowEvent::Kind::Down) together_.reset();
        events.push_back({kind, x, y, pressure, event_time_us(stamp), id != kMouse});
        events.back().button = id == kMouse && buttons_.is_other();
    }

    void mouse(std::vector<WindowEvent>& events, WindowEvent::Kind kind, int x, int y, std::uint32_t stamp) {
        int width = 1, height = 1;
        SDL_GetWindowSize(window_, &width, &height);
        const SizePx drawable = size();
        pointer(events, kind, kMouse, (x + 0.5) * drawable.width / std::max(width, 1),
                (y + 0.5) * drawable.height / std::max(height, 1), 1.0, stamp);
    }

    void finger(std::vector<WindowEvent>& events, WindowEvent::Kind kind, const SDL_TouchFingerEvent& touch) {
        const SizePx drawable = size();
        const bool free = !held_;
        pointer(events, kind, touch.fingerId, touch.x * drawable.width, touch.y * drawable.height,
                touch.pressure > 0.0F ? touch.pressure : 1.0, touch.timestamp);
        if (free && held_) touch_screen_ = touch.touchId;
    }

    /// A touch screen that goes while a finger is on it, as one does whose cable has a bad day, never says that the
    /// finger lifted: nothing else would point any more.
    void let_lost_finger_go(std::vector<WindowEvent>& events) {
        if (!held_ || *held_ == kMouse) return;
        for (int i = 0; i < SDL_GetNumTouchDevices(); ++i)
            if (SDL_GetTouchDevice(i) == touch_screen_) return;
        held_.reset();
        events.push_back({WindowEvent::Kind::Cancel, 0, 0, 1, now_us(), true});
    }

    /// Apart or nearer to each other, and where they go together.
    void two_fingers(std::vector<WindowEvent>& events, const SDL_MultiGestureEvent& gesture) {
        const SizePx drawable = size();
        WindowEvent zoom;
        zoom.kind = WindowEvent::Kind::Zoom;
        zoom.zoom = kSpreadStep * static_cast<double>(gesture.dDist);
        zoom.x = gesture.x * drawable.width;
        zoom.y = gesture.y * drawable.height;
        if (together_) {
            zoom.shift_x = zoom.x - together_->first;
            zoom.shift_y = zoom.y - together_->second;
        }
        together_ = {zoom.x, zoom.y};
        zoom.time_us = event_time_us(gesture.timestamp);
        zoom.finger = true;
        const bool still = std::abs(gesture.dDist) < 1e-4F && zoom.shift_x == 0 && zoom.shift_y == 0;
        if (!still) events.push_back(zoom);
    }

    void window_event(std::vector<WindowEvent>& events, const SDL_WindowEvent& event) {
        const auto push = [&](WindowEvent::Kind kind) {
            events.push_back({kind, 0, 0, 1, event_time_us(event.timestamp), false});
        };
        switch (event.event) {
            case SDL_WINDOWEVENT_SIZE_CHANGED:
                push(WindowEvent::Kind::Resized);
                break;
            case SDL_WINDOWEVENT_EXPOSED:
            case SDL_WINDOWEVENT_SHOWN:
            case SDL_WINDOWEVENT_RESTORED:
                push(WindowEvent::Kind::Exposed);
                break;
            case SDL_WINDOWEVENT_FOCUS_GAINED:
                push(WindowEvent::Kind::FocusGained);
                break;
            case SDL_WINDOWEVENT_FOCUS_LOST:
                buttons_.forget();
                held_.reset();  // the lift may go to another window
                push(WindowEvent::Kind::FocusLost);
                break;
            case SDL_WINDOWEVENT_CLOSE:
                push(WindowEvent::Kind::Close);
                break;
            default:
                break;
        }
    }

    void translate(const SDL_Event& event, std::vector<WindowEvent>& events) {
        using Kind = WindowEvent::Kind;
        switch (event.type) {
            case SDL_QUIT:
                events.push_back({Kind::Close, 0, 0, 1, now_us(), false});
                break;
            case SDL_KEYDOWN:
                if (event.key.keysym.sym == SDLK_ESCAPE) events.push_back({Kind::Escape, 0, 0, 1, now_us(), false});
                break;
            case SDL_WINDOWEVENT:
                window_event(events, event.window);
                break;
            case SDL_MOUSEBUTTONDOWN:
            case SDL_MOUSEBUTTONUP:
                if (const bool down = event.type == SDL_MOUSEBUTTONDOWN;
                    event.button.which != SDL_TOUCH_MOUSEID && buttons_.change(event.button.button, down)) {
                    mouse(events, down ? Kind::Down : Kind::Up, event.button.x, event.button.y, event.button.timestamp);
                    buttons_.settle();
                }
                break;
            case SDL_MOUSEMOTION:
                if (event.motion.which != SDL_TOUCH_MOUSEID) {
                    mouse(events, Kind::Move, event.motion.x, event.motion.y, event.motion.timestamp);
                }
                break;
            case SDL_MOUSEWHEEL: {
                WindowEvent zoom;
                zoom.x = -1;  // where the pointer is
                zoom.kind = Kind::Zoom;
                zoom.zoom =
                    kWheelStep * (event.wheel.direction == SDL_MOUSEWHEEL_FLIPPED ? -event.wheel.y : event.wheel.y);
                zoom.time_us = event_time_us(event.wheel.timestamp);
                events.push_back(zoom);
                break;
            }
            case SDL_MULTIGESTURE:
                two_fingers(events, event.mgesture);
                break;
            case SDL_FINGERDOWN:
                finger(events, Kind::Down, event.tfinger);
                break;
            case SDL_FINGERMOTION:
                finger(events, Kind::Move, event.tfinger);
                break;
            case SDL_FINGERUP:
                finger(events, Kind::Up, event.tfinger);
                break;
            default:
                break;
        }
    }

    SDL_Window* window_;
    SDL_GLContext context_;
    std::optional<SDL_FingerID> held_;
    SDL_TouchID touch_screen_ = 0;  // that the held finger is on
    MouseButtons buttons_;
    std::optional<std::pair<double, double>> together_;  // the middle of two fingers
};

/// SDL's drivers that somebody can see, best first: left to itself it ends by drawing into memory, unseen. Wayland only
/// where it can be, for its library complains otherwise.
const char* real_screens() {
    const char* const folder = std::getenv("XDG_RUNTIME_DIR");
    return folder != nullptr && *folder != 0 ? "x11,wayland,kmsdrm" : "x11,kmsdrm";
}

core::Unexpected no_display() {
    return core::unexpected(core::ErrorCode::NoDisplay, std::string("no screen can be opened (") + SDL_GetError() +
                                                            "); start it on a desktop or a console with graphics, or "
                                                            "use --headless with --replay");
}

}  // namespace

core::Result<std::unique_ptr<Window>> Window::open(const WindowOptions& options) {
    SDL_SetMainReady();
    SDL_SetHint(SDL_HINT_OPENGL_ES_DRIVER, "1");
    SDL_SetHint(SDL_HINT_VIDEO_X11_FORCE_EGL, "1");
    SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "0");
    SDL_SetHint(SDL_HINT_MOUSE_TOUCH_EVENTS, "0");
    SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
    SDL_SetHint(SDL_HINT_VIDEO_MINIMIZE_ON_FOCUS_LOSS, "0");
    SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");
    SDL_SetHint(SDL_HINT_VIDEODRIVER, real_screens());  // what the environment asks for wins
    if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) return no_display();
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
    SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
    SDL_GL_SetAttribute(SDL_GL_DEPTH_SIZE, 0);
    const std::uint32_t flags = SDL_WINDOW_OPENGL | SDL_WINDOW_ALLOW_HIGHDPI |
                                (options.full_screen ? SDL_WINDOW_FULLSCREEN_DESKTOP : SDL_WINDOW_RESIZABLE);
    SDL_Rect place{SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, options.size.width, options.size.height};
    if (options.full_screen) SDL_GetDisplayBounds(0, &place);  // right also where no window manager sees to it
    SDL_Window* window = SDL_CreateWindow(options.title.c_str(), place.x, place.y, place.w, place.h, flags);
    SDL_GLContext context = window != nullptr ? SDL_GL_CreateContext(window) : nullptr;
    if (context == nullptr) {
        const core::Unexpected failure = no_display();
        if (window != nullptr) SDL_DestroyWindow(window);
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        return failure;
    }
    SDL_GL_SetSwapInterval(1);
    SDL_DisableScreenSaver();
    return std::unique_ptr<Window>(std::make_unique<SdlWindow>(window, context));
}

}  // namespace ui
