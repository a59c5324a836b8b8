#include "firmware_like_app/kiosk/surface.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "ui/gl/headless_context.hpp"

namespace app {
namespace {

constexpr std::int64_t kFrame_us = 1'000'000 / 60;

class WindowSurface final : public Surface {
  public:
    explicit WindowSurface(std::unique_ptr<ui::Window> window) : window_(std::move(window)) {}
    ui::SizePx size() const override { return window_->size(); }
    std::vector<ui::WindowEvent> poll() override { return window_->poll(); }
    std::int64_t now_us() const override { return window_->now_us(); }
    bool shows_frames() const override { return window_->visible(); }
    bool bind() override {
        ui::bind_window(size());
        return true;
    }
    void next_frame(bool drawn) override {
        if (drawn) window_->present();
        // some drivers do not wait for the screen: do not run faster than it
        const std::int64_t rest = last_us_ + kFrame_us - 1500 - now_us();
        if (rest > 0) std::this_thread::sleep_for(std::chrono::microseconds(std::min(rest, kFrame_us)));
        last_us_ = now_us();
    }
    core::RgbaImage read_back() override { return ui::read_window(size()); }

  private:
    std::unique_ptr<ui::Window> window_;
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
    bool bind() override {
        target_.bind();
        return false;
    }
    void next_frame(bool /*drawn*/) override { now_us_ += kFrame_us; }
    core::RgbaImage read_back() override { return target_.read_back(); }

  private:
    std::unique_ptr<ui::Context> context_;
    ui::Target target_;
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
