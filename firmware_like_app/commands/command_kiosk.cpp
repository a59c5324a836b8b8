// croquis kiosk: the screen.

#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/parallel.hpp"
#include "core/exchange/file_bytes.hpp"
#include "firmware_like_app/collection/kept_collection.hpp"
#include "firmware_like_app/collection/picture_drawing.hpp"
#include "firmware_like_app/collection/sketch_description.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "firmware_like_app/kiosk/kiosk.hpp"
#include "firmware_like_app/kiosk/settings.hpp"
#include "input/formats/any_ink.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

constexpr int kRestart = 3;  // whoever started the program starts it again

struct KioskCommandOptions {
    std::string config, shots;
    std::vector<std::string> settings;  ///< "section.name=value", those of the short options among them
    std::vector<std::string> replays;
    bool headless = false, json = false, early = false;
};

/// "1920x1080", as the settings have checked it.
std::optional<ui::SizePx> parse_size(const std::string& text) {
    ui::SizePx size;
    if (std::sscanf(text.c_str(), "%dx%d", &size.width, &size.height) != 2) return std::nullopt;
    return size;
}

/// The file, then what the call says.
core::Result<Config> settings_of(const KioskCommandOptions& options) {
    Config config;
    if (!options.config.empty()) {
        core::Result<Config> file = read_config(options.config);
        if (!file) return file;
        config = std::move(*file);
    }
    for (const std::string& setting : options.settings) {
        if (const core::Result<void> set = set_option(config, setting); !set) return core::unexpected(set.error());
    }
    return config;
}

/// What was recorded while a garment was drawn; nothing for all other files.
core::Result<std::optional<GarmentReplay>> read_garment(const std::string& file) {
    const core::Result<std::string> text = core::read_file_bytes(file, input::kMaxTraceBytes);
    if (!text) return std::optional<GarmentReplay>();  // a drawing by another name, "file.ndjson:3"
    if (!input::looks_like_trace(*text)) return std::optional<GarmentReplay>();
    const core::Result<input::Trace> trace = input::parse_trace(*text);
    if (!trace || !is_garment_trace(*trace)) return std::optional<GarmentReplay>();
    core::Result<GarmentReplay> replay = garment_replay(*trace, std::filesystem::path(file).stem().string());
    if (!replay) return core::unexpected(replay.error());
    return std::optional<GarmentReplay>(std::move(*replay));
}

/// Strokes as they were drawn, or those that go around what a picture shows.
core::Result<core::Drawing> read_replay(const std::string& file) {
    core::Result<core::Drawing> drawing = input::read_drawing_of_ink(file);
    if (drawing || drawing.error().code != core::ErrorCode::UnknownFormat) return drawing;
    const core::Result<core::Sketch> sketch = read_any_sketch(file);
    if (!sketch) return core::unexpected(sketch.error());
    if (!sketch->image) return drawing;
    drawing = drawing_of_picture(*sketch->image);
    if (!drawing) return core::unexpected(drawing.error().code, drawing.error().message, file);
    return drawing;
}

/// Garments go to `garments`.
core::Result<std::vector<NamedDrawing>> read_replays(const std::vector<std::string>& files,
                                                     std::vector<GarmentReplay>& garments) {
    std::vector<NamedDrawing> drawings;
    for (const std::string& file : files) {
        core::Result<std::optional<GarmentReplay>> garment = read_garment(file);
        if (!garment) return core::unexpected(garment.error());
        if (*garment) {
            garments.push_back(std::move(**garment));
            continue;
        }
        core::Result<core::Drawing> drawing = read_replay(file);
        if (!drawing) return core::unexpected(drawing.error());
        drawings.push_back({file, std::move(*drawing)});
    }
    return drawings;
}

/// What is wrong with the collection is no reason not to open: the sheet works, and a calm screen says what it is.
std::unique_ptr<KeptCollection> open_collection(const Config& config) {
    KeptCollection::Options options;
    options.database = config.collection.database;
    options.models = config.collection.models;
    const auto threads = static_cast<int>(config.collection.search_threads);
    options.jobs = threads > 0 ? threads : core::core_count();
    auto collection = std::make_unique<KeptCollection>(std::move(options));
    const CollectionStatus status = collection->status();
    for (const std::string& problem : status.problems) std::fprintf(stderr, "croquis: %s\n", problem.c_str());
    return collection;
}

/// An index that was named and answers nothing; its sentence has been printed.
bool is_at_fault(CollectionState state) {
    return state == CollectionState::Missing || state == CollectionState::Damaged || state == CollectionState::Stale;
}

/// What a replay found, in words.
std::string outcome(const ReplayReport& replay) {
    if (!replay.failure.empty()) return replay.failure;
    if (replay.steps > 0) {
        return "a garment of " + std::to_string(replay.pieces) + " pieces in " + std::to_string(replay.steps) +
               " steps";
    }
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
    if (!replay.design.empty()) std::printf("  %s\n", replay.design.string().c_str());
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
             {"design", r.design.string()},
             {"steps", r.steps},
             {"pieces", r.pieces},
             {"ms", {{"silhouette", r.silhouette_ms}, {"describe", r.describe_ms}, {"search", r.search_ms}}}});
    }
    if (early && !as_json) print_early(report);
    if (!as_json) return;
    ordered_json out{{"replays", replays},
                     {"frames", report.frames},
                     {"renderer", report.renderer},
                     {"frame_ms", {{"median", report.median_frame_ms}, {"worst", report.worst_frame_ms}}}};
    if (early) out["end_among_first_ten"] = early_shares(report);
    print_json(out);
}

void run_kiosk_command(const KioskCommandOptions& options, CommandState& state) {
    const core::Result<Config> config = settings_of(options);
    if (!config) {
        const bool wrong_call = config.error().code == core::ErrorCode::BadArgument;
        return wrong_call ? fail_call(state, config.error()) : fail(state, config.error());
    }
    KioskOptions kiosk;
    kiosk.config = *config;
    kiosk.config_file = options.config;
    if (!config->screen.size.empty()) kiosk.size = parse_size(config->screen.size);
    kiosk.windowed = config->screen.windowed;
    kiosk.escape_exits = config->screen.escape_exits;
    kiosk.headless = options.headless;
    kiosk.end_after_replays = !options.replays.empty();
    kiosk.shots = options.shots;
    kiosk.early_looks = options.early;
    kiosk.record = config->record.folder;
    kiosk.language = config->visitors.language;
    kiosk.languages_folder = config->visitors.languages_folder;
    kiosk.hand = hand_of(*config);
    kiosk.attract = config->visitors.attract;
    kiosk.times = times_of(*config);
    kiosk.expect_tablet = config->tablet.expected;
    kiosk.pens = pens_of(*config);
    core::Result<std::vector<NamedDrawing>> replays = read_replays(options.replays, kiosk.garments);
    if (!replays) return fail(state, replays.error());
    const std::unique_ptr<KeptCollection> collection = open_collection(*config);
    const core::Result<KioskReport> report = run_kiosk(kiosk, *collection, std::move(*replays));
    if (!report) {
        const bool wrong_call = report.error().code == core::ErrorCode::BadArgument;
        return wrong_call ? fail_call(state, report.error()) : fail(state, report.error());
    }
    print_report(*report, options.json, options.early);
    for (const ReplayReport& r : report->replays) {
        if (r.failure.empty()) continue;
        std::fprintf(stderr, "croquis: %s: %s\n", r.name.c_str(), r.failure.c_str());
        state.exit_code = 1;
    }
    if (options.headless && is_at_fault(collection->status().state)) state.exit_code = 1;
    if (report->restart) state.exit_code = kRestart;
}

}  // namespace

void add_kiosk_command(Command cli, CommandState& state) {
    auto options = std::make_shared<KioskCommandOptions>();
    Command command = cli.command("kiosk", "The full-screen kiosk");
    command.option("--config", options->config, "the settings of the station, a TOML file; see croquis config");
    command.option("--set", options->settings, "one setting, section.name=value; wins over the file").repeated();
    const auto shorthand = [&](const char* name, const char* setting, const char* what) {
        command.option(
            name,
            [options, setting](const std::string& value) { options->settings.push_back(setting + ("=" + value)); },
            what);
    };
    shorthand("--db", "collection.database", "the index to search");
    shorthand("--models", "collection.models", "a folder of models that is read into the index while visitors draw");
    shorthand("--size", "screen.size", "WIDTHxHEIGHT");
    shorthand("--record", "record.folder", "folder for traces of what visitors draw");
    shorthand("--language", "visitors.language", "en, fr, de or the code of a further language file");
    shorthand("--jobs", "collection.search_threads", "search threads");
    command.flag(
        "--windowed", [options] { options->settings.push_back("screen.windowed=true"); },
        "a framed window instead of the full screen");
    command.flag(
        "--left", [options] { options->settings.push_back("visitors.hand=left"); },
        "controls for a left-handed visitor");
    command.flag("--headless", options->headless, "render without a screen; ends when the replays do");
    command.option("--replay", options->replays,
                   "drawings: traces, those of garments too, recordings of tablets, SVG, InkML, Quick-Draw lines, "
                   "stroke lists, and pictures, around which a pen goes");
    command.option("--shots", options->shots, "folder for numbered pictures");
    command.flag("--early", options->early,
                 "headless: report how often the first result of the end is among ten at 40, 60 and 80 % of the ink");
    command.flag("--json", options->json, "one JSON object on standard output");
    command.runs([options, &state] { run_kiosk_command(*options, state); });
}

void add_config_command(Command cli, CommandState& state) {
    auto file = std::make_shared<std::string>();
    Command command =
        cli.command("config", "Prints the settings of a station with their defaults, or checks a file of them");
    command.option("FILE", *file, "a file to check");
    command.runs([file, &state] {
        if (file->empty()) {
            std::printf("%s", default_config_text().c_str());
            return;
        }
        const core::Result<Config> config = read_config(*file);
        if (!config) return fail(state, config.error());
        std::printf("%s: every setting is good\n", file->c_str());
    });
}

}  // namespace app
