#include "firmware_like_app/health/self_test.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <thread>

#include "db/stores/two_view_index.hpp"
#include "firmware_like_app/collection/model_views.hpp"
#include "input/sources/tablet_hub.hpp"
#include "ui/draw/fonts.hpp"
#include "ui/gl/headless_context.hpp"
#include "ui/gl/objects.hpp"
#include "ui/screens/strings.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;
constexpr double kLeastDisk_gb = 1.0;

std::string gigabytes(double gb) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f GB free", gb);
    return text.data();
}

Check check_fonts() {
    const core::Result<ui::FontSet> fonts = ui::FontSet::load();
    if (!fonts) return {"fonts", false, fonts.error().sentence(), "apt-get install fonts-inter fonts-noto-core"};
    if (fonts->has_inter()) return {"fonts", true, "Inter", ""};
    return {"fonts", false, "Noto Sans in place of Inter", "apt-get install fonts-inter"};
}

Check check_languages(const Config& config) {
    const core::Result<std::vector<ui::Strings>> languages = ui::Strings::load_all(config.visitors.languages_folder);
    if (!languages)
        return {"languages", false, languages.error().sentence(),
                "mend the file, or set visitors.languages_folder anew"};
    std::string names;
    for (const ui::Strings& language : *languages) {
        names += (names.empty() ? "" : ", ") + language["name"];
        if (language.keys() != (*languages)[0].keys()) {
            return {"languages", false, language["name"] + " lacks words or has others",
                    "compare its file with en.json"};
        }
    }
    return {"languages", true, names, ""};
}

Check check_database(const std::string& database) {
    if (database.empty()) return {"database", false, "none is set", "set collection.database, or call with --db"};
    const core::Result<db::TwoViewIndex> index =
        db::TwoViewIndex::open(database, db::OpenMode::ReadOnly, {.parameters = parameters_text(ViewParameters{})});
    if (!index) return {"database", false, index.error().sentence(), "croquis index build FOLDER --db " + database};
    const core::Result<db::IndexInfo> info = index->info();
    const core::Result<std::vector<std::int64_t>> damaged = index->damaged_models();
    if (!info) return {"database", false, info.error().sentence(), "croquis index check --db " + database};
    const std::string models = std::to_string(info->models) + " models";
    if (!damaged || !damaged->empty()) {
        const std::string count = damaged ? std::to_string(damaged->size()) : std::string("some");
        return {"database", false, models + ", " + count + " damaged", "croquis index check --db " + database};
    }
    if (info->models == 0) return {"database", false, "no models", "croquis index build FOLDER --db " + database};
    if (info->stale_models > 0) {
        return {"database", false, models + ", " + std::to_string(info->stale_models) + " of an older Croquis",
                "update on the station page, or call croquis index build again"};
    }
    return {"database", true, models, ""};
}

Check check_disk(const std::string& path) {
    const double gb = free_disk_gb(path);
    return {"disk", gb >= kLeastDisk_gb, gigabytes(gb), gb >= kLeastDisk_gb ? "" : "make room on the disk"};
}

/// A folder that is written to, or that of a file.
Check check_writable(const std::string& name, const fs::path& folder) {
    const fs::path place = folder.empty() ? fs::path(".") : folder;
    const bool good = access(place.c_str(), W_OK) == 0;
    return {name, good, place.string() + (good ? " can be written" : " cannot be written"),
            good ? "" : "give this user the right to write there"};
}

Check check_graphics() {
    const core::Result<std::unique_ptr<ui::Context>> context = ui::make_headless_context();
    if (!context)
        return {"OpenGL ES", false, context.error().sentence(), "apt-get install libegl1 libegl-mesa0 libgl1-mesa-dri"};
    return {"OpenGL ES", true, ui::renderer_name(), ""};
}

Check check_screen() {
    const auto given = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != 0;
    };
    if (given("WAYLAND_DISPLAY")) return {"screen", true, "Wayland", ""};
    if (given("DISPLAY")) return {"screen", true, "X11", ""};
    if (access("/dev/dri/card0", R_OK | W_OK) == 0) return {"screen", true, "console with graphics", ""};
    if (access("/dev/dri/card0", F_OK) == 0) {
        return {"screen", false, "/dev/dri/card0 may not be opened by this user",
                "add the user to the groups video and render"};
    }
    return {"screen", false, "none", "start a desktop, or use a console with a graphics card"};
}

Check check_tablets() {
    input::TabletHub hub({.hot_plug = false});
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    std::vector<input::SourceEvent> events;
    hub.drain(events);
    std::string names;
    for (const input::SourceEvent& event : events) {
        if (event.kind != input::SourceEventKind::Attached) continue;
        names += (names.empty() ? "" : ", ") + hub.device(event.device).identity.name;
    }
    const std::vector<std::string> problems = hub.take_problems();
    if (!problems.empty())
        return {"tablets", false, problems.front(), "see \"My tablet is not recognised\" in the README"};
    if (names.empty()) return {"tablets", false, "none", "plug one in; until then a finger or the mouse draws"};
    return {"tablets", true, names, ""};
}

}  // namespace

std::vector<Check> check_station(const Config& config, const std::string& config_file) {
    std::vector<Check> checks{check_fonts(), check_languages(config), check_database(config.collection.database)};
    const std::string on_disk = config.collection.database.empty() ? "." : config.collection.database;
    checks.push_back(check_disk(on_disk));
    if (!config_file.empty()) checks.push_back(check_writable("settings", fs::path(config_file).parent_path()));
    if (!config.record.folder.empty()) checks.push_back(check_writable("recordings", config.record.folder));
    return checks;
}

std::vector<Check> check_machine() {
    return {check_screen(), check_graphics(), check_tablets()};
}

Check check_permissions(const Config& config, const std::string& config_file) {
    std::string good;
    std::optional<Check> fault;
    const auto look = [&](const fs::path& place, int mode, const char* may, const char* advice) {
        std::error_code error;
        if (fault || place.empty() || !fs::exists(place, error)) return;
        if (access(place.c_str(), mode) == 0) {
            good += (good.empty() ? "" : "; ") + place.string() + " may be " + may;
        } else {
            fault = Check{"permissions", false, place.string() + " may not be " + may + " by this user", advice};
        }
    };
    const char* const kRead = "give this user the right to read it";
    const char* const kWrite = "give this user the right to write there";
    const auto folder_of = [](const std::string& file) {
        return file.empty() ? fs::path() : fs::absolute(file).parent_path();
    };
    look("/dev/dri/renderD128", R_OK | W_OK, "used", "add the user to the groups video and render");
    look(config_file, R_OK, "read", kRead);
    look(folder_of(config_file), W_OK, "written", kWrite);
    look(config.collection.database, R_OK, "read", kRead);
    if (!config.collection.models.empty()) {  // what is new there is written into the index
        look(config.collection.database, W_OK, "written", kWrite);
        look(folder_of(config.collection.database), W_OK, "written", kWrite);
        look(config.collection.models, R_OK | X_OK, "read", kRead);
    }
    look(config.garment.designs, R_OK | W_OK, "read and written", kWrite);
    look(folder_of(config.garment.designs), W_OK, "written", kWrite);
    look(config.garment.export_to, W_OK, "written", kWrite);
    look(config.record.folder, W_OK, "written", kWrite);
    look(config.station.report_folder, W_OK, "written", kWrite);
    if (fault) return *fault;
    return {"permissions", true, good.empty() ? "nothing is named that needs any" : good, ""};
}

double resident_mb() {
    std::ifstream in("/proc/self/statm");
    double whole = 0, resident = 0;
    in >> whole >> resident;
    return in ? resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6 : 0;
}

double free_disk_gb(const std::string& path) {
    std::error_code error;
    fs::path place = fs::absolute(path, error);
    while (!fs::exists(place, error) && place.has_parent_path() && place != place.parent_path())
        place = place.parent_path();
    const fs::space_info space = fs::space(place, error);
    return error ? 0 : static_cast<double>(space.available) / 1e9;
}

int open_handles() {
    std::error_code error;
    int count = 0;
    for (auto it = fs::directory_iterator("/proc/self/fd", error); !error && it != fs::directory_iterator();
         it.increment(error))
        ++count;
    return count;
}

}  // namespace app
