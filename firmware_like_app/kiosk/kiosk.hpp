#pragma once
// The kiosk's loop: one for the window and for pictures without a screen, for visitors and for replayed drawings.

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "firmware_like_app/config/config.hpp"
#include "firmware_like_app/kiosk/collection_host.hpp"
#include "firmware_like_app/kiosk/garment_trace.hpp"
#include "firmware_like_app/kiosk/pen_desk.hpp"
#include "firmware_like_app/kiosk/replay_player.hpp"
#include "firmware_like_app/kiosk/searcher.hpp"
#include "firmware_like_app/kiosk/station.hpp"
#include "ui/gl/context.hpp"
#include "ui/screens/find_layout.hpp"

namespace app {

struct KioskOptions {
    std::optional<ui::SizePx> size;  ///< default: the whole screen, 1920 × 1080 headless
    bool windowed = false;           ///< a framed window instead of the full screen
    bool headless = false;           ///< no screen at all; a virtual clock; ends when the replays do
    bool end_after_replays = true;   ///< false: in a window the sheet is free when the replays end
    std::filesystem::path shots;     ///< folder for numbered pictures at 25, 50, 75 and 100 % of each replay's ink
    std::filesystem::path record;    ///< folder for what visitors draw: a trace a drawing, and one of all that pointed
    std::vector<GarmentReplay> garments;                      ///< played after the drawings
    bool tablets = true;                                      ///< read the tablets of this machine, in a window
    input::PipelineOptions pens;                              ///< calibration, pressure, smoothing of tablets
    std::function<void(const TabletChange&)> tablet_changed;  ///< called between frames
    std::string language = "en";                              ///< code of a language file
    ui::Hand hand = ui::Hand::Right;
    CollectionState collection = CollectionState::Ready;  ///< other than ready: a calm screen says so
    StationTimes times;
    bool attract = true;           ///< false: an empty sheet waits for visitors
    bool expect_tablet = false;    ///< say so when none is there; one that was there once is always expected
    bool early_looks = false;      ///< headless: also search when 40, 60 and 80 % of a replay's ink are drawn
    bool escape_exits = true;      ///< the Escape key ends the program
    std::string languages_folder;  ///< with further language files
    Config config;                 ///< what the operator sees and changes
    std::string config_file;       ///< where that is kept; empty: until the program ends
};

/// What came of one replayed drawing.
struct ReplayReport {
    std::string name;
    std::vector<std::int64_t> ids;   ///< of the last ranking, best first, all that the searcher gave
    std::vector<std::string> names;  ///< of the same models
    std::string message_key;         ///< of the last answer
    double silhouette_ms = 0, describe_ms = 0, search_ms = 0;  ///< of the last search
    int searches = 0;
    /// With KioskOptions::early_looks: whether the best model of the end was among the first ten at 40, 60 and 80 %.
    std::array<bool, 3> end_seen{};
    std::filesystem::path design;  ///< of a garment: the file it was written to, beside the shots
    int steps = 0, pieces = 0;     ///< of a garment
    std::string failure;           ///< what went wrong while searching; empty when all is well
    std::vector<std::filesystem::path> shots;
};

struct KioskReport {
    std::vector<ReplayReport> replays;
    std::int64_t frames = 0;     ///< drawn
    double median_frame_ms = 0;  ///< time to draw one, presenting left out
    double worst_frame_ms = 0;
    std::uint64_t pen_reports_lost = 0;  ///< that a full queue refused
    std::vector<std::string> problems;   ///< with tablets and recordings, in sentences for people; at most 100
    std::string renderer;                ///< what draws, as GL names it
    bool restart = false;                ///< the operator asked for a new start
};

/// Runs until the window is closed, Escape is pressed, or (headless or end_after_replays) the replays end.
/// A collection that is not ready: the sheet works and nothing is found. Headless, the loop waits for the search after
/// each stroke and at each picture, so two runs give the same pictures. Errors: NoDisplay, FileMissing (fonts),
/// BadArgument (unknown language, headless without replays or shots), WriteFailed (shots; record where it cannot
/// begin).
[[nodiscard]] core::Result<KioskReport> run_kiosk(const KioskOptions& options, CollectionHost& collection,
                                                  std::vector<NamedDrawing> replays);
/// The same on a collection that never changes; `searcher` may be null.
[[nodiscard]] core::Result<KioskReport> run_kiosk(const KioskOptions& options, Searcher* searcher,
                                                  std::vector<NamedDrawing> replays);

}  // namespace app
