#pragma once
// The operator's page at work: what it shows is gathered here, what is touched is done and kept.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "firmware_like_app/config/config.hpp"
#include "firmware_like_app/kiosk/alignment.hpp"
#include "firmware_like_app/kiosk/collection_host.hpp"
#include "ui/gl/window.hpp"
#include "ui/screens/station_screen.hpp"

namespace app {

/// What the loop knows of the running program.
struct StationFacts {
    std::int64_t running_s = 0;
    double worst_frame_ms = 0;  ///< of the last day
    std::string renderer;
    std::vector<std::string> tablets;  ///< names
    bool pen_asleep = false;
    std::optional<double> pen_to_screen_ms;  ///< of the last reports, median
    std::vector<std::string> problems;       ///< with tablets, in sentences
    double memory_mb = 0, free_disk_gb = 0;
};

class OperatorDesk {
  public:
    static constexpr std::int64_t kHold_us = 1'000'000;  ///< of Exit

    struct Setup {
        Config config;
        std::string config_file;                     ///< where changes are kept; empty: until the program ends
        CollectionHost* collection = nullptr;        ///< may be null; must outlive the desk
        std::function<void(const Config&)> changed;  ///< called when a setting was changed
        std::filesystem::path media = "/media";      ///< where a search for models begins
    };
    OperatorDesk(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, Setup setup);

    enum class Wish { Close, Clean, Restart, Exit };
    void open();
    void pointer(const ui::WindowEvent& event, const ui::StationState& state, ui::SizePx screen);
    void cancel_pointer();
    /// The page is left: what was not finished is as it was before.
    void leave();
    /// Once a frame.
    void update(std::int64_t now_us);
    [[nodiscard]] std::optional<Wish> take_wish() { return std::exchange(wish_, std::nullopt); }
    void set_facts(StationFacts facts) { facts_ = std::move(facts); }
    /// An import or a held button: the page must not close by itself.
    [[nodiscard]] bool busy() const;

    [[nodiscard]] ui::StationState state(std::size_t language, std::int64_t now_us) const;
    [[nodiscard]] ui::StationPage build(const ui::StationState& state, ui::SizePx screen) const {
        return screen_.build(state, screen);
    }
    [[nodiscard]] const Config& config() const { return setup_.config; }

  private:
    void act(std::size_t item);
    void change(const std::string& key, const std::string& value);
    void step(std::size_t which, int direction);
    void show_folder(const std::filesystem::path& folder);
    void show_problems();
    void run_self_test();
    void save_report();
    void show_rows();
    void begin_aligning();
    void align_with(const ui::WindowEvent& event, ui::SizePx screen);
    void finish_aligning(double aspect);
    [[nodiscard]] std::string align_words(const ui::Strings& words) const;
    [[nodiscard]] std::string report_text() const;
    [[nodiscard]] std::string ended_words(const CollectionStatus& status, const ui::Strings& words) const;

    const std::vector<ui::Strings>& languages_;
    Setup setup_;
    ui::StationScreen screen_;
    StationFacts facts_;
    std::optional<ui::StationState::List> list_;
    std::filesystem::path folder_;
    std::vector<std::filesystem::path> folders_;
    std::size_t first_folder_ = 0;
    /// Pen and screen while they are aligned.
    struct Aligning {
        std::vector<CrossHit> hits;
        std::vector<core::Point> touch;  ///< shares of the screen, since the tip came down
    };
    std::optional<Aligning> aligning_;
    std::optional<AlignmentFit::Fault> aligned_;  ///< how the last try ended
    enum class Message { None, Tested, Saved, NotSaved } message_ = Message::None;
    std::string message_value_;
    std::optional<Wish> wish_;

    ui::BoardTouch touch_;
    std::optional<std::int64_t> exit_since_us_;
    std::optional<double> scroll_grip_;
    double scroll_ = 0, most_scroll_ = 0;
    bool testing_ = false;
    std::optional<core::Point> last_point_;
    double last_radius_ = 0, pressure_ = 0;
    std::vector<ui::InkPiece> trail_;
    std::vector<std::int64_t> report_times_us_;
    std::optional<double> tilt_rad_;
    std::optional<core::Point> across_;
    struct Progress {
        std::int64_t at_us = 0, done = 0;
    };
    std::optional<Progress> import_began_;
    std::optional<double> per_minute_;
    std::int64_t looked_us_ = 0;
};

}  // namespace app
