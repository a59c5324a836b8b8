#pragma once
// A kiosk without a screen on a clock that the test moves: taps and strokes in, scenes and pictures out.

#include <filesystem>
#include <memory>
#include <vector>

#include "firmware_like_app/kiosk/collection_host.hpp"
#include "firmware_like_app/kiosk/shell.hpp"
#include "tests/support/figures.hpp"
#include "ui/gl/headless_context.hpp"

namespace test {

/// What stands may share, one after the other: a context with its shaders, fonts, words, and the animals. Making them
/// is most of what a stand costs.
struct StandBase {
    /// Throws std::runtime_error with the sentence of what is missing.
    StandBase();
    std::unique_ptr<ui::Context> context;
    std::vector<ui::Program> shaders;  // kept built
    ui::FontSet fonts;
    std::vector<ui::Strings> languages;
    FigureSearcher figures;
};

class KioskStand {
  public:
    /// A small collection of built animals. Throws std::runtime_error with the sentence of what is missing.
    /// `record`: a folder for what is drawn in Garment. `base`: of earlier stands; one of its own without. Of `garment`
    /// what this stand does not set itself counts.
    explicit KioskStand(ui::SizePx size, app::ShellOptions options = {}, app::FindOptions find_options = {},
                        const std::filesystem::path& record = {}, std::shared_ptr<StandBase> base = nullptr,
                        app::GarmentOptions garment = {});

    /// Frames of 1/60 s until that time is over; of 1/10 s where it is longer than five seconds.
    void wait(double seconds);
    void event(ui::WindowEvent::Kind kind, double x, double y);
    void tap(double x, double y);
    void tap(const ui::Rect& rect) { tap(rect.centre_x(), rect.centre_y()); }
    /// A drag across the screen, 12 samples.
    void stroke(double x0, double y0, double x1, double y1);
    /// The horse of make_horse_drawing() drawn with the pointer into the middle of the sheet; its answer is waited for.
    /// With a share, only that much of its samples: the pen is still down then.
    void draw_horse(double share = 1);
    /// Digits on the PIN page.
    void type(const std::string& digits);
    /// A tap on the station page.
    void press_station(ui::StationAction action, std::size_t index = 0);
    [[nodiscard]] core::RgbaImage picture();
    [[nodiscard]] const ui::FontSet& fonts() const { return base_->fonts; }
    [[nodiscard]] app::Scene scene() const { return shell->station().scene(); }

  private:
    std::shared_ptr<StandBase> base_;

  public:
    const std::vector<ui::Strings>& languages;
    app::FixedCollection collection;
    std::unique_ptr<app::FindMode> find;
    std::unique_ptr<app::GarmentMode> garment;
    std::unique_ptr<app::Shell> shell;
    std::int64_t now_us = 1'000'000;
    ui::SizePx size;
};

}  // namespace test
