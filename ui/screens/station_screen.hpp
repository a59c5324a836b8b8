#pragma once
// The operator's page: tablet, collection, idle times, what visitors see, health, restart and exit (design picture 09).
// Three columns, two that scroll on smaller and upright screens.

#include <optional>
#include <string>
#include <vector>

#include "ui/screens/find_screen.hpp"

namespace ui {

/// What an operator wants; `item` of Control::Station is one of these, with an index of its own added in hundreds.
enum class StationAction : std::size_t {
    Close,
    Clean,
    Curve,  ///< index: 0 soft, 1 normal, 2 firm
    Add,
    Update,
    Stop,
    Problems,
    FolderUp,
    Folder,  ///< index: which of the folders shown
    AddThese,
    LeaveList,
    Less,  ///< index: which idle time
    More,
    Language,  ///< index
    Hand,      ///< index: 0 left, 1 right
    Garment,   ///< index: 0 off, 1 on
    Shadow,    ///< index: 0 off, 1 on
    Colours,   ///< index: 0 soft, 1 strong
    Turn,      ///< index: quarters clockwise
    SelfTest,
    SaveReport,
    Align,
    LeaveAlign,
    Earlier,  ///< of the folders
    Later,
    Restart,
    Exit,
};
[[nodiscard]] constexpr std::size_t station_item(StationAction action, std::size_t index = 0) {
    return static_cast<std::size_t>(action) + 100 * index;
}
[[nodiscard]] constexpr StationAction station_action(std::size_t item) {
    return static_cast<StationAction>(item % 100);
}
[[nodiscard]] constexpr std::size_t station_index(std::size_t item) {
    return item / 100;
}

inline constexpr std::size_t kIdleTimeCount = 4;  ///< ask, countdown, empty, ask in Garment
inline constexpr std::size_t kFolderRows = 6;

struct StationState {
    std::size_t language = 0;
    std::string place;
    // tablet
    std::string tablet_name;
    bool tablet_there = false;
    std::optional<double> report_rate_hz;
    std::optional<double> pen_to_screen_ms;  ///< from a report until its frame was shown, median
    double pressure = 0;                     ///< of the last pointer in the test area, 0 … 1
    std::optional<double> tilt_deg;          ///< of the same, from upright
    std::optional<core::Point> across;       ///< where it is on the screen, per cent
    std::vector<InkPiece> trail;             ///< what was drawn there, on the screen
    std::size_t curve = 1;
    std::size_t turn = 0;  ///< quarters clockwise
    bool can_align = false;
    std::string align_message;  ///< in words, of the last try
    /// Pen and screen are being aligned: nothing but this is shown.
    struct Align {
        std::size_t step = 0, count = 0;
        core::Point cross;  ///< shares of the screen
        friend bool operator==(const Align&, const Align&) = default;
    };
    std::optional<Align> align;
    // collection
    std::int64_t models = 0, views = 0;
    std::optional<double> search_ms;
    std::string changed;  ///< a date, written out; empty: never
    bool can_add = false, stale = false, importing = false;
    std::int64_t done = 0, total = 0, unreadable = 0;
    std::optional<double> per_minute;
    std::optional<int> minutes_left;
    std::string import_ended;  ///< in words, of the last one
    /// Shown in place of the collection: folders to choose from, or sentences.
    struct List {
        bool folders = false;
        std::string title;  ///< the folder's path, or what the sentences are about
        std::vector<std::string> rows;
        std::int64_t model_files = 0;    ///< directly or farther below
        std::size_t first = 0, all = 0;  ///< of folders: which of them the first row is, and how many there are
        friend bool operator==(const List&, const List&) = default;
    };
    std::optional<List> open_list;
    // the rest
    std::array<int, kIdleTimeCount> idle_s{};
    std::size_t start_language = 0;
    bool start_left = false;
    bool garment = true;  ///< offered to visitors
    bool shadow = true;
    std::size_t colours = 0;  ///< of parts: 0 soft, 1 strong
    std::int64_t running_s = 0;
    double worst_frame_ms = 0;
    std::optional<bool> pen_live;  ///< nothing where there is no tablet
    double memory_mb = 0, free_disk_gb = 0;
    std::string health_message;
    double exit_held = 0;                ///< 0 … 1
    double scroll = 0;                   ///< pixels, 0 or more
    std::optional<std::size_t> pressed;  ///< item of Control::Station
    friend bool operator==(const StationState&, const StationState&) = default;
};

/// The page as it is drawn, and where it can be touched.
struct StationPage {
    DrawList list;
    std::vector<BoardTouch::Target> targets;
    Rect test_area;          ///< where the pen is tested
    double most_scroll = 0;  ///< pixels
};

class StationScreen {
  public:
    /// Both must outlive the screen.
    StationScreen(const FontSet& fonts, const std::vector<Strings>& languages)
        : fonts_(&fonts), languages_(&languages) {}
    [[nodiscard]] StationPage build(const StationState& state, SizePx screen) const;

  private:
    const FontSet* fonts_;
    const std::vector<Strings>* languages_;
};

}  // namespace ui
