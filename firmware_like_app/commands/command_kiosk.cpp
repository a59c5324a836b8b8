// croquis kiosk: the screen.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/parallel.hpp"
#include "firmware_like_app/collection/sketch_searcher.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/kiosk/kiosk.hpp"
#include "input/formats/any_ink.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

struct KioskCommandOptions {
    std::string database, size, shots, record, language = "en";
    std::vector<std::string> replays;
    bool windowed = false, headless = false, left_handed = false, json = false, early = false;
    int jobs = core::core_count();
};

/// "1920x1080"
std::optional<ui::SizePx> parse_size(const std::string& text) {
    int width = 0, height = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2) return std::nullopt;
    if (width < 320 || height < 240 || width > 8192 || height > 8192) return std::nullopt;
    return ui::SizePx{width, height};
}

/// Drawings only: a picture has no strokes to replay.
core::Result<std::vector<NamedDrawing>> read_replays(const std::vector<std::string>& files) {
    std::vector<NamedDrawing> drawings;
    for (const std::string& file : files) {
        core::Result<core::Drawing> drawing = input::read_drawing_of_ink(file);
        if (!drawing) return core::unexpected(drawing.error());
        drawings.push_back({file, std::move(*drawing)});
    }
    return drawings;
}

/// A missing or damaged index is no reason not to open: the sheet works, and a calm screen says what is missing.
std::unique_ptr<SketchSearcher> open_collection(const KioskCommandOptions& options, KioskOptions& kiosk) {
    constexpr int kBest = 10;  // nine cards, and one more to know what is just below
    if (options.database.empty()) {
        kiosk.collection = CollectionState::Empty;
        return nullptr;
    }
    core::Result<std::unique_ptr<SketchSearcher>> searcher =
        SketchSearcher::open(options.database, options.jobs, kBest);
    if (!searcher) {
        std::fprintf(stderr, "croquis: %s\n", searcher.error().sentence().c_str());
        kiosk.collection =
            searcher.error().code == core::ErrorCode::FileMissing ? CollectionState::Missing : CollectionState::Damaged;
        return nullptr;
    }
    for (const std::string& warning : (*searcher)->collection().warnings()) {
        std::fprintf(stderr, "croquis: %s: %s\n", options.database.c_str(), warning.c_str());
    }
    if ((*searcher)->collection().models().empty()) {
        kiosk.collection = CollectionState::Empty;
        return nullptr;
    }
    return std::move(*searcher);
}

/// What a replay found, in words.
std::string outcome(const ReplayReport& replay) {
    if (!replay.failure.empty()) return replay.failure;
    if (replay.message_key == "too_little") return "too little is drawn to compare";
    if (replay.names.empty()) return "nothing found";
    std::string words;
    for (std::size_t k = 0; k < std::min<std::size_t>(replay.names.size(), 5); ++k) {
        if (k > 0) words += ", ";
        words += replay.names[k];
    }
    return words;
}

/// A sheet on which nothing was replayed has no name, only its picture.
void print_for_people(const ReplayReport& replay) {
    if (!replay.name.empty()) std::printf("%s: %s\n", replay.name.c_str(), outcome(replay).c_str());
    for (const auto& shot : replay.shots) std::printf("  %s\n", shot.string().c_str());
}

/// Shares of the replays that found something at all.
ordered_json early_shares(const KioskReport& report) {
    std::array<int, 3> seen{};
    int found = 0;
    for (const ReplayReport& r : report.replays) {
        if (r.ids.empty()) continue;
        ++found;
        for (std::size_t i = 0; i < seen.size(); ++i) seen[i] += r.end_seen[i] ? 1 : 0;
    }
    const auto share = [&](int n) { return found > 0 ? static_cast<double>(n) / found : 0.0; };
    return {{"40", share(seen[0])}, {"60", share(seen[1])}, {"80", share(seen[2])}};
}

void print_early(const KioskReport& report) {
    const ordered_json shares = early_shares(report);
    for (const auto& [ink, share] : shares.items()) {
        std::printf("at %s %% of the ink the first result of the end is among ten in %.0f %% of the drawings\n",
                    ink.c_str(), share.get<double>() * 100);
    }
}

void print_report(const KioskReport& report, bool as_json, bool early) {
    ordered_json replays = ordered_json::array();
    for (const ReplayReport& r : report.replays) {
        if (!as_json) {
            print_for_people(r);
            continue;
        }
        ordered_json shots = ordered_json::array();
        for (const auto& shot : r.shots) shots.push_back(shot.string());
        replays.push_back(
            {{"drawing", r.name},
             {"ids", r.ids},
             {"models", r.names},
             {"message", r.message_key},
             {"failure", r.failure},
             {"searches", r.searches},
             {"shots", shots},
             {"ms", {{"silhouette", r.silhouette_ms}, {"describe", r.describe_ms}, {"search", r.search_ms}}}});
    }
    if (early && !as_json) print_early(report);
    if (!as_json) return;
    ordered_json out{{"replays", replays},
                     {"frames", report.frames},
                     {"renderer", report.renderer},
                     {"frame_ms", {{"median", report.median_frame_ms}, {"worst", report.worst_frame_ms}}}};
    if (early) out["end_among_first_ten"] = early_shares(report);
    std::printf("%s\n", out.dump().c_str());
}

void run_kiosk_command(const KioskCommandOptions& options, CommandState& state) {
    KioskOptions kiosk;
    if (!options.size.empty()) {
        kiosk.size = parse_size(options.size);
        if (!kiosk.size) {
            std::fprintf(stderr, "croquis: --size %s: give WIDTHxHEIGHT from 320x240 to 8192x8192\n",
                         options.size.c_str());
            state.exit_code = 2;
            return;
        }
    }
    kiosk.windowed = options.windowed;
    kiosk.headless = options.headless;
    kiosk.end_after_replays = !options.replays.empty();
    kiosk.shots = options.shots;
    kiosk.record = options.record;
    kiosk.early_looks = options.early;
    kiosk.language = options.language;
    if (options.left_handed) kiosk.hand = ui::Hand::Left;
    core::Result<std::vector<NamedDrawing>> replays = read_replays(options.replays);
    if (!replays) return fail(state, replays.error());
    const std::unique_ptr<SketchSearcher> searcher = open_collection(options, kiosk);
    const core::Result<KioskReport> report = run_kiosk(kiosk, searcher.get(), std::move(*replays));
    if (!report) {
        fail(state, report.error());
        if (report.error().code == core::ErrorCode::BadArgument) state.exit_code = 2;
        return;
    }
    print_report(*report, options.json, options.early);
    for (const ReplayReport& r : report->replays) {
        if (r.failure.empty()) continue;
        std::fprintf(stderr, "croquis: %s: %s\n", r.name.c_str(), r.failure.c_str());
        state.exit_code = 1;
    }
}

}  // namespace

void add_kiosk_command(CLI::App& cli, CommandState& state) {
    auto options = std::make_shared<KioskCommandOptions>();
    CLI::App* command = cli.add_subcommand("kiosk", "The full-screen kiosk");
    command->add_option("--db", options->database, "the index to search");
    command->add_option("--size", options->size, "WIDTHxHEIGHT");
    command->add_flag("--windowed", options->windowed, "a framed window instead of the full screen");
    command->add_flag("--headless", options->headless, "render without a screen; ends when the replays do");
    command->add_option("--replay", options->replays,
                        "recorded drawings: traces, recordings of tablets, SVG, InkML, Quick-Draw lines, "
                        "stroke lists");
    command->add_option("--record", options->record, "folder for traces of what visitors draw");
    command->add_option("--shots", options->shots, "folder for numbered pictures");
    command->add_option("--language", options->language, "en, fr or de");
    command->add_option("--jobs", options->jobs, "search threads")->check(CLI::PositiveNumber);
    command->add_flag(
        "--early", options->early,
        "headless: report how often the first result of the end is among ten at 40, 60 and 80 % of the ink");
    command->add_flag("--left", options->left_handed, "controls for a left-handed visitor");
    command->add_flag("--json", options->json, "one JSON object on standard output");
    command->callback([options, &state] { run_kiosk_command(*options, state); });
}

}  // namespace app
