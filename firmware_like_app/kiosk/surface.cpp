#include "firmware_like_app/kiosk/surface.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "firmware_like_app/kiosk/input_fault.hpp"
#include "ui/gl/headless_context.hpp"

namespace app {
namespace {

constexpr std::int64_t kFrame_us = 1'000'000 / 60, kLook_us = 2'000;

/// Frames are drawn into a picture that stays and is copied to the window whole: what a window's own buffers hold after
/// they were shown is not known everywhere.
class WindowSurface final : public Surface {
  public:
    explicit WindowSurface(std::unique_ptr<ui::Window> window)
        : window_(std::move(window)), target_(window_->size(), ui::PixelFormat::Colour) {}
    ui::SizePx size() const override { return window_->size(); }
    std::vector<ui::WindowEvent> poll() override { return window_->poll(); }
    std::int64_t now_us() const override { return window_->now_us(); }
    bool shows_frames() const override { return window_->visible(); }
    std::string no_input_code() const override { return window_->has_desktop() ? "" : input_fault("/dev/input"); }
    bool bind() override {
        kept_ = drawn_ && target_.size() == size();
        if (target_.size() != size()) target_ = ui::Target(size(), ui::PixelFormat::Colour);
        target_.bind();
        drawn_ = true;
        return true;
    }
    bool kept() const override { return kept_; }
    void next_frame(bool drawn, const std::function<void()>& meanwhile, const std::function<void()>& look) override {
        if (drawn) {
            target_.copy_to_window();
            window_->present();
        }
        meanwhile();
        // some drivers do not wait for the screen: do not run faster than it
        const std::int64_t due_us = std::min(last_us_ + kFrame_us - 1500, now_us() + kFrame_us);
        for (std::int64_t rest = due_us - now_us(); rest > 0; rest = due_us - now_us()) {
            const bool looks = look && rest > kLook_us;
            std::this_thread::sleep_for(std::chrono::microseconds(looks ? kLook_us : rest));
            if (looks) look();
        }
        last_us_ = now_us();
    }
    core::RgbaImage read_back() override {
        core::RgbaImage image = target_.read_back();
        const auto row = static_cast<std::ptrdiff_t>(image.width) * 4;
        for (int y = 0; y < image.height / 2; ++y) {  // its first row is the bottom one
            const auto upper = image.pixels.begin() + y * row, lower = image.pixels.end() - (y + 1) * row;
            std::swap_ranges(upper, upper + row, lower);
        }
        return image;
    }

  private:
    std::unique_ptr<ui::Window> window_;
    ui::Target target_;
    bool drawn_ = false, kept_ = false;
    std::int64_t last_us_ = 0;
};

class HeadlessSurface final : public Surface {
  public:
    HeadlessSurface(std::unique_ptr<ui::Context> context, ui::SizePx size)
        : context_(std::move(context)), target_(size, ui::PixelFormat::Colour) {}
    ui::SizePx size() const override { return target_.size(); }
    std::vector<ui::WindowEvent> poll() override { return {}; }
    std::int64_t now_us() const override { return now_us_; }
    bool shows_frames() const override { return false; }
    std::string no_input_code() const override { return {}; }
    bool bind() override {
        target_.bind();
        kept_ = std::exchange(drawn_, true);
        return false;
    }
    bool kept() const override { return kept_; }
    void next_frame(bool /*drawn*/, const std::function<void()>& meanwhile,
                    const std::function<void()>& /*look*/) override {
        meanwhile();
        now_us_ += kFrame_us;
    }
    core::RgbaImage read_back() override { return target_.read_back(); }

  private:
    std::unique_ptr<ui::Context> context_;
    ui::Target target_;
    bool drawn_ = false, kept_ = false;
    std::int64_t now_us_ = 0;
};

}  // namespace

core::Result<std::unique_ptr<Surface>> open_window_surface(const ui::WindowOptions& options) {
    core::Result<std::unique_ptr<ui::Window>> window = ui::Window::open(options);
    if (!window) return core::unexpected(window.error());
    return std::unique_ptr<Surface>(std::make_unique<WindowSurface>(std::move(*window)));
}

core::Result<std::unique_ptr<Surface>> make_headless_surface(ui::SizePx size) {
    core::Result<std::unique_ptr<ui::Context>> context = ui::make_headless_context();
    if (!context) return core::unexpected(context.error());
    return std::unique_ptr<Surface>(std::make_unique<HeadlessSurface>(std::move(*context), size));
}

}  // namespace app
