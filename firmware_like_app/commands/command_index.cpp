// croquis index build|list|show|remove|check|vacuum, croquis starter.

#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "core/base/parallel.hpp"
#include "core/starter/starter_collection.hpp"
#include "firmware_like_app/collection/index_builder.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "firmware_like_app/commands/progress_bar.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

struct IndexOptions {
    std::vector<std::string> paths;
    std::string database, classes, files, picture;
    std::int64_t id = 0;
    int view = 0;
    int jobs = core::core_count();
    bool json = false;
    bool graph = false;
};

std::stop_source& interruption() {
    static std::stop_source source;
    return source;
}

/// Safe in a signal handler as long as nobody registers a stop_callback: then it is one atomic exchange.
extern "C" void on_interrupt(int) {
    interruption().request_stop();
}

/// While it lives, Ctrl-C and SIGTERM ask the work to come to an end; a second one ends the program at once, which an
/// index survives.
class Interruptible {
  public:
    Interruptible() {
        interruption() = std::stop_source();
        struct sigaction action {};
        action.sa_handler = on_interrupt;
        action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
        sigemptyset(&action.sa_mask);
        sigaction(SIGINT, &action, &before_int_);
        sigaction(SIGTERM, &action, &before_term_);
        std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is an error like a full disk, not the end
    }
    ~Interruptible() {
        sigaction(SIGINT, &before_int_, nullptr);
        sigaction(SIGTERM, &before_term_, nullptr);
    }
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;
    [[nodiscard]] static std::stop_token token() { return interruption().get_token(); }

  private:
    struct sigaction before_int_ {};
    struct sigaction before_term_ {};
};

ordered_json as_json(const std::vector<PassedOver>& files) {
    ordered_json out = ordered_json::array();
    for (const PassedOver& f : files) out.push_back({{"file", f.file}, {"why", f.why}});
    return out;
}

void print_build_report(const IndexBuildReport& report, bool json) {
    for (const PassedOver& f : report.failed) {
        std::fprintf(stderr, "croquis: %s: passed over: %s\n", f.file.c_str(), f.why.c_str());
    }
    for (const PassedOver& f : report.kept) {
        std::fprintf(stderr, "croquis: %s: %s\n", f.file.c_str(), f.why.c_str());
    }
    if (json) {
        const ordered_json out{
            {"added", report.added},        {"skipped", report.skipped},   {"failed", as_json(report.failed)},
            {"kept", as_json(report.kept)}, {"measured", report.measured}, {"ms", report.ms}};
        print_json(out);
        return;
    }
    std::printf("%d added, %d unchanged, %zu not readable, %.1f s\n", report.added, report.skipped,
                report.failed.size(), report.ms / 1000.0);
}

core::Result<IndexBuildReport> build_with_progress(const IndexBuildOptions& build) {
    const Interruptible interruptible;
    std::optional<ProgressBar> bar;
    bool measuring = true;
    return build_index(build, Interruptible::token(), [&](IndexBuildProgress p) {
        if (!bar || measuring != p.measuring) {
            bar.reset();
            bar.emplace(p.measuring ? "models compared" : "models");
            measuring = p.measuring;
        }
        bar->show(p.done, p.total);
    });
}

void run_build(const IndexOptions& options, CommandState& state) {
    IndexBuildOptions build;
    build.paths = options.paths;
    build.database = options.database;
    build.jobs = options.jobs;
    build.likeness = options.graph;
    if (!options.classes.empty()) {
        const std::string folder = options.files.empty() ? options.paths.front() : options.files;
        const core::Result<core::LabelledList> list = core::read_list_file(options.classes, folder);
        if (!list) return fail(state, list.error());
        if (list->files.empty()) {
            return fail(state,
                        {core::ErrorCode::FileMissing,
                         "none of the files that it names is there; check the list and --files", options.classes});
        }
        build.classes = list->files;
    }
    const core::Result<IndexBuildReport> report = build_with_progress(build);
    if (!report) return fail(state, report.error());
    print_build_report(*report, options.json);
    if (report->interrupted) std::fprintf(stderr, "croquis: interrupted; call it again to go on from here\n");
    if (report->interrupted || !report->failed.empty()) state.exit_code = 1;
}

core::Result<db::TwoViewIndex> open_index(const IndexOptions& options, db::OpenMode mode) {
    return db::TwoViewIndex::open(options.database, mode, {.parameters = parameters_text({})});
}

void run_list(const IndexOptions& options, CommandState& state) {
    const auto index = open_index(options, db::OpenMode::ReadOnly);
    if (!index) return fail(state, index.error());
    const auto entries = index->list();
    if (!entries) return fail(state, entries.error());
    ordered_json out = ordered_json::array();
    for (const db::ModelEntry& e : *entries) {
        if (options.json) {
            out.push_back(
                {{"id", e.id}, {"name", e.name}, {"class", e.class_name}, {"path", e.source_path}, {"stale", e.stale}});
        } else {
            std::printf("%lld\t%s\t%s\t%s%s\n", static_cast<long long>(e.id), e.name.c_str(), e.class_name.c_str(),
                        e.source_path.c_str(), e.stale ? "\tstale" : "");
        }
    }
    if (options.json) print_json(ordered_json{{"models", out}});
    if (const auto stale = index->stale(); stale && *stale) std::fprintf(stderr, "croquis: %s\n", (*stale)->c_str());
}

core::Result<void> write_picture(const std::string& path, const std::vector<std::byte>& png) {
    if (png.empty()) {
        return core::unexpected(core::ErrorCode::BadArgument,
                                "the model has no picture yet; call `croquis index build` again");
    }
    std::ofstream file(path, std::ios::binary);
    file.write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
    if (file.flush()) return {};
    return core::unexpected(core::ErrorCode::WriteFailed,
                            "the picture cannot be written; check that the folder exists and has room", path);
}

void run_show(const IndexOptions& options, CommandState& state) {
    const auto index = open_index(options, db::OpenMode::ReadOnly);
    if (!index) return fail(state, index.error());
    const auto model = index->load(options.id);
    if (!model) return fail(state, model.error());
    ordered_json views = ordered_json::array();
    for (const db::ModelView& v : model->views) {
        views.push_back({{"camera", v.camera_number},
                         {"direction", {v.camera.direction.x, v.camera.direction.y, v.camera.direction.z}},
                         {"skeletal_length", v.skeletal_length},
                         {"asymmetry", v.asymmetry},
                         {"terminals", v.descriptor.terminal_count},
                         {"parts", v.descriptor.parts.size()},
                         {"thumbnail_bytes", v.thumbnail.size()}});
    }
    if (!options.picture.empty()) {
        const auto written =
            write_picture(options.picture, model->views[static_cast<std::size_t>(options.view)].thumbnail);
        if (!written) return fail(state, written.error());
    }
    const ordered_json out{{"id", model->id},
                           {"name", model->name},
                           {"class", model->class_name},
                           {"path", model->source_path},
                           {"triangles", model->display_mesh.triangles.size()},
                           {"views", views}};
    print_json(out, options.json ? -1 : 2);
}

void run_remove(const IndexOptions& options, CommandState& state) {
    auto index = open_index(options, db::OpenMode::ReadWrite);
    if (!index) return fail(state, index.error());
    const auto removed = index->remove(options.id);
    if (!removed) return fail(state, removed.error());
    if (options.json) print_json(ordered_json{{"removed", options.id}});
}

void run_check(const IndexOptions& options, CommandState& state) {
    const auto index = open_index(options, db::OpenMode::ReadOnly);
    if (!index) return fail(state, index.error());
    const auto damaged = index->check();
    if (!damaged) return fail(state, damaged.error());
    const auto info = index->info();
    ordered_json list = ordered_json::array();
    for (const db::Damage& d : *damaged) {
        list.push_back({{"id", d.model_id}, {"model", d.model}, {"part", d.part}, {"message", d.message}});
        std::fprintf(stderr, "croquis: %s: %s\n", options.database.c_str(), d.sentence().c_str());
    }
    if (options.json) {
        print_json(ordered_json{{"models", info ? info->models : 0}, {"damaged", list}});
    } else if (damaged->empty()) {
        std::printf("%lld models, all whole\n", static_cast<long long>(info ? info->models : 0));
    }
    if (!damaged->empty()) state.exit_code = 1;
}

void run_vacuum(const IndexOptions& options, CommandState& state) {
    auto index = open_index(options, db::OpenMode::ReadWrite);
    if (!index) return fail(state, index.error());
    const auto done = index->vacuum();
    if (!done) return fail(state, done.error());
    const auto info = index->info();
    if (options.json) print_json(ordered_json{{"bytes", info ? info->bytes : 0}});
}

}  // namespace

void add_index_commands(Command cli, CommandState& state) {
    Command index = cli.group("index", "The collection's index");
    auto options = std::make_shared<IndexOptions>();
    const auto add = [&](const char* name, const char* what, void (*run)(const IndexOptions&, CommandState&)) {
        Command command = index.command(name, what);
        command.option("--db", options->database, "the index, one SQLite file").required();
        command.flag("--json", options->json, "one JSON object on standard output");
        command.runs([options, &state, run] { run(*options, state); });
        return command;
    };
    Command build = add("build", "Add model files and folders; unchanged files are skipped", run_build);
    build.option("PATH", options->paths, "model files, and folders to search").required();
    build.option("--classes", options->classes, "path<TAB>class list, or a Princeton .cla file");
    build.option("--files", options->files, "folder of the files that a .cla numbers; default: the first PATH");
    build.option("--jobs", options->jobs, "threads").range(1, kMostJobs);
    build.flag("--graph", options->graph,
               "also find each model's nearest others, for query --rerank; later builds keep them up to date");
    add("list", "All models", run_list);
    Command show = add("show", "One model", run_show);
    show.option("ID", options->id, "").required();
    show.option("--picture", options->picture, "write its thumbnail, a PNG");
    show.option("--view", options->view, "of which of its two views, 0 or 1").range(0, 1);
    add("remove", "Take one model out", run_remove).option("ID", options->id, "").required();
    add("check", "Verify every record", run_check);
    add("vacuum", "Give the space of removed models back", run_vacuum);
}

void add_starter_command(Command cli, CommandState& state) {
    auto folder = std::make_shared<std::string>();
    Command command = cli.command("starter", "Write the built-in starter collection as files");
    command.option("--out", *folder, "folder, made if missing").required();
    command.runs([folder, &state] {
        const core::Result<void> written = core::write_starter_collection(*folder);
        if (!written) return fail(state, written.error());
        std::fprintf(stderr, "croquis: the starter collection is in %s\n", folder->c_str());
    });
}

}  // namespace app
