// croquis garment designs list|show|export|add|check: what a station keeps, without its screen.

#include "firmware_like_app/commands/command_designs.hpp"

#include <cstdio>
#include <ctime>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/exchange/design_file.hpp"
#include "db/stores/design_store.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "firmware_like_app/commands/progress_bar.hpp"
#include "firmware_like_app/garment/design_sources.hpp"
#include "firmware_like_app/garment/exporter.hpp"

namespace app {
namespace {

using nlohmann::ordered_json;

struct DesignsCommand {
    std::string database, out, picture, models, design;
    std::int64_t id = 0;
    int pictures = ExportPlan{}.pictures;
    bool bin = false, stick = false, json = false;
};

/// "2026-11-25 22:40", UTC.
std::string date_of(std::int64_t us) {
    const std::time_t seconds = us / 1000000;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    std::string text(20, '\0');
    text.resize(std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts));
    return text;
}

core::Result<db::DesignStore> open_store(const DesignsCommand& options, db::OpenMode mode = db::OpenMode::ReadOnly) {
    return db::DesignStore::open(options.database, mode);
}

void run_list(const DesignsCommand& options, CommandState& state) {
    const core::Result<db::DesignStore> store = open_store(options);
    if (!store) return fail(state, store.error());
    const auto entries = store->list(options.bin ? db::Shelf::Bin : db::Shelf::Kept);
    if (!entries) return fail(state, entries.error());
    ordered_json list = ordered_json::array();
    for (const db::DesignEntry& entry : *entries) {
        if (!options.json) {
            std::printf("%6lld  %s  %s\n", static_cast<long long>(entry.id), date_of(entry.changed_us).c_str(),
                        entry.name.c_str());
            continue;
        }
        list.push_back({{"id", entry.id},
                        {"name", entry.name},
                        {"created", date_of(entry.created_us)},
                        {"changed", date_of(entry.changed_us)}});
        if (entry.deleted_us) list.back()["deleted"] = date_of(*entry.deleted_us);
    }
    if (options.json) print_json({{"designs", list}});
}

core::Result<void> write_file(const std::string& path, const char* bytes, std::size_t size) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (!out.write(bytes, static_cast<std::streamsize>(size)).flush())
        return core::unexpected(core::ErrorCode::WriteFailed, "it cannot be written; check the folder and the space",
                                path);
    return {};
}

/// Damaged records are passed over, named, and make the exit code 1.
core::Result<db::OpenedDesign> load(const DesignsCommand& options, CommandState& state) {
    const core::Result<db::DesignStore> store = open_store(options);
    if (!store) return core::unexpected(store.error());
    core::Result<db::OpenedDesign> opened = store->load(options.id);
    if (!opened) return opened;
    for (const std::string& fault : opened->faults)
        fail(state, {core::ErrorCode::Damaged, "\"" + opened->state.design.name + "\": " + fault, options.database});
    return opened;
}

void run_show(const DesignsCommand& options, CommandState& state) {
    const core::Result<db::OpenedDesign> opened = load(options, state);
    if (!opened) return fail(state, opened.error());
    const core::Design& design = opened->state.design;
    if (!options.out.empty()) {
        const std::string text = core::design_text(design);
        if (const auto done = write_file(options.out, text.data(), text.size()); !done)
            return fail(state, done.error());
    }
    if (!options.picture.empty()) {
        const auto store = open_store(options);
        const auto png = store ? store->thumbnail(options.id) : core::unexpected(store.error());
        if (!png) return fail(state, png.error());
        if (png->empty())
            return fail(state, {core::ErrorCode::FileMissing, "the design has no picture yet", options.database});
        if (const auto done = write_file(options.picture, reinterpret_cast<const char*>(png->data()), png->size());
            !done)
            return fail(state, done.error());
    }
    if (options.json)
        return print_json({{"id", options.id},
                           {"name", design.name},
                           {"steps", design.steps.size()},
                           {"acts", db::count_acts(design.steps)},
                           {"undone", db::count_acts(opened->state.undone)},
                           {"entries", opened->sequence},
                           {"faults", opened->faults}});
    std::printf("%s: %zu steps in %zu acts, %zu undone; entry %lld of its journal\n", design.name.c_str(),
                design.steps.size(), db::count_acts(design.steps), db::count_acts(opened->state.undone),
                static_cast<long long>(opened->sequence));
}

/// --out, or the first stick that can be written.
ExportPlace place_for(const DesignsCommand& options) {
    if (!options.stick) return folder_place(options.out);
    for (const ExportPlace& stick : find_sticks())
        if (!stick.read_only) return stick;
    return {};
}

void print_export(const ExportState& done, bool as_json) {
    for (const std::string& warning : done.warnings) std::fprintf(stderr, "croquis: warning: %s\n", warning.c_str());
    if (as_json) return print_json({{"folder", done.folder.string()}, {"warnings", done.warnings}});
    std::printf("%s\n", done.folder.c_str());
}

void run_export_command(const DesignsCommand& options, CommandState& state) {
    const core::Result<db::OpenedDesign> opened = load(options, state);
    if (!opened) return fail(state, opened.error());
    ExportJob job{.design = opened->state.design,
                  .bodies = bodies_by_file(),
                  .models = models_of_index(options.models),
                  .place = place_for(options)};
    job.plan.pictures = options.pictures;
    ExportState done;
    {
        ProgressBar bar("%");
        done = run_export(
            job, [&](const ExportState& now) { bar.show(static_cast<std::size_t>(100.0 * now.share), 100); }, {});
    }
    if (done.fault) return fail(state, done.fault->error);
    print_export(done, options.json);
}

void run_add(const DesignsCommand& options, CommandState& state) {
    const core::Result<core::Design> design = core::read_design(options.design);
    if (!design) return fail(state, design.error());
    core::Result<db::DesignStore> store = open_store(options, db::OpenMode::Create);
    if (!store) return fail(state, store.error());
    const core::Result<std::int64_t> id = store->create(*design);
    if (!id) return fail(state, id.error());
    if (options.json) return print_json({{"id", *id}, {"name", design->name}});
    std::printf("%lld\n", static_cast<long long>(*id));
}

void run_check(const DesignsCommand& options, CommandState& state) {
    const core::Result<db::DesignStore> store = open_store(options);
    if (!store) return fail(state, store.error());
    const auto damaged = store->check();
    if (!damaged) return fail(state, damaged.error());
    std::vector<std::string> sentences;
    for (const db::DesignDamage& damage : *damaged) sentences.push_back(damage.sentence);
    for (const std::string& sentence : sentences) fail(state, {core::ErrorCode::Damaged, sentence, options.database});
    if (options.json) return print_json({{"faults", sentences}});
    if (sentences.empty()) std::printf("all is well\n");
}

using Run = void (*)(const DesignsCommand&, CommandState&);

Command add(Command designs, const char* name, const char* what, const std::shared_ptr<DesignsCommand>& options,
            CommandState& state, Run run) {
    Command command = designs.command(name, what);
    command.option("--db", options->database, "the station's file of designs").required();
    command.flag("--json", options->json, "one JSON object on standard output");
    command.runs([options, &state, run] { run(*options, state); });
    return command;
}

}  // namespace

void add_designs_command(Command garment, CommandState& state) {
    Command designs = garment.group("designs", "The designs that a station keeps");
    auto options = std::make_shared<DesignsCommand>();
    add(designs, "list", "What is kept, changed last first", options, state, run_list)
        .flag("--bin", options->bin, "what was deleted and can be taken back");
    Command show =
        add(designs, "show", "One design: its history, its design file, its picture", options, state, run_show);
    show.option("ID", options->id, "its number").required();
    show.option("--out", options->out, "design file to write");
    show.option("--picture", options->picture, "PNG to write");
    Command out = add(designs, "export", "Models, patterns and pictures of one design, in a new folder", options, state,
                      run_export_command);
    out.option("ID", options->id, "its number").required();
    Command place = out.one_of("place");
    place.option("--out", options->out, "folder in which the new one is made");
    place.flag("--stick", options->stick, "on the USB stick that is plugged in");
    out.option("--pictures", options->pictures, "how many, all round").range(0, 360).show_default();
    out.option("--models", options->models, "index that the design's objects were taken from");
    add(designs, "add", "Keeps a design file", options, state, run_add)
        .option("DESIGN", options->design, "design file")
        .required();
    add(designs, "check", "Looks at every record", options, state, run_check);
}

}  // namespace app
