// croquis query: ranks the collection for one drawing.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/parallel.hpp"
#include "firmware_like_app/collection/collection.hpp"
#include "firmware_like_app/collection/sketch_description.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "ui/draw/shape_picture.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

struct QueryOptions {
    std::string sketch, database, picture;
    int top = 10;
    int jobs = core::core_count();
    bool json = false;
    bool rerank = false;
};

/// The nearest models with their correspondences.
struct Answer {
    std::vector<RankedModel> ranked;
    std::vector<core::Match> matches;
    double search_ms = 0.0;
};

std::vector<RankedModel> reranked_by(const Collection& collection, const std::vector<core::ComparableShape>& readings,
                                     const QueryOptions& options) {
    const core::QueryReranker reranker(core::neighbour_graph(*collection.likeness()), options.jobs);
    std::vector<RankedModel> ranked = reranked(reranker, collection.rank(readings, RankBy::Fused, options.jobs));
    ranked.resize(std::min(ranked.size(), static_cast<std::size_t>(options.top)));
    return ranked;
}

Answer search(const std::vector<SketchDescription>& query, const Collection& collection, const QueryOptions& options) {
    const Stopwatch watch;
    const std::vector<core::ComparableShape> readings = comparable(query);
    Answer answer;
    answer.ranked = options.rerank ? reranked_by(collection, readings, options)
                                   : collection.nearest(readings, static_cast<std::size_t>(options.top), options.jobs);
    core::Matcher matcher;
    for (const RankedModel& r : answer.ranked) {
        answer.matches.push_back(
            matcher.match(readings[static_cast<std::size_t>(r.reading)].parts,
                          collection.models()[r.model].views[static_cast<std::size_t>(r.view)].parts));
    }
    answer.search_ms = watch.ms();
    return answer;
}

/// Of all readings together.
struct DescriptionTimes {
    double silhouette_ms = 0.0, describe_ms = 0.0;

    explicit DescriptionTimes(const std::vector<SketchDescription>& readings) {
        for (const SketchDescription& reading : readings) {
            silhouette_ms += reading.silhouette_ms;
            describe_ms += reading.describe_ms;
        }
    }
};

void print_object(const Answer& answer, const Collection& collection, const DescriptionTimes& times) {
    ordered_json results = ordered_json::array();
    for (std::size_t k = 0; k < answer.ranked.size(); ++k) {
        const RankedModel& r = answer.ranked[k];
        const db::ModelRecord& model = collection.models()[r.model].record;
        ordered_json parts = ordered_json::array();
        for (const core::MatchedPair& p : answer.matches[k].pairs) {
            parts.push_back({{"query", p.part_a}, {"model", p.part_b}, {"cost", p.cost()}});
        }
        results.push_back({{"rank", k + 1},
                           {"model", model.name},
                           {"class", model.class_name},
                           {"distance", r.distance},
                           {"view", r.view},
                           {"id", model.id},
                           {"path", model.source_path},
                           {"mirrored", answer.matches[k].reversed},
                           {"reading", r.reading},
                           {"parts", parts}});
    }
    const ordered_json out{
        {"results", results},
        {"ms", {{"silhouette", times.silhouette_ms}, {"describe", times.describe_ms}, {"search", answer.search_ms}}}};
    print_json(out);
}

core::Result<void> draw(const Answer& answer, const Collection& collection, const std::vector<SketchDescription>& query,
                        const std::string& path) {
    std::vector<ui::MatchPictureItem> items;
    for (std::size_t k = 0; k < answer.ranked.size(); ++k) {
        const RankedModel& r = answer.ranked[k];
        const db::ModelRecord& model = collection.models()[r.model].record;
        items.push_back({&query[static_cast<std::size_t>(r.reading)].shape.descriptor,
                         &model.views[static_cast<std::size_t>(r.view)].descriptor, &answer.matches[k],
                         std::to_string(k + 1) + ".",
                         model.name + (model.class_name.empty() ? "" : " (" + model.class_name + ")")});
    }
    return ui::write_match_picture(items, path);
}

void run_query(const QueryOptions& options, CommandState& state) {
    const core::Result<Collection> collection = Collection::load(options.database);
    if (!collection) return fail(state, collection.error());
    for (const std::string& warning : collection->warnings()) {
        std::fprintf(stderr, "croquis: %s: %s\n", options.database.c_str(), warning.c_str());
    }
    if (collection->models().empty()) {
        return fail(state, {core::ErrorCode::FileMissing, "the index has no models; add some with croquis index build",
                            options.database});
    }
    if (options.rerank && !collection->likeness()) {
        return fail(state, {core::ErrorCode::FileMissing,
                            "the index does not know which models are near to which; call `croquis index build` with "
                            "--graph on its models",
                            options.database});
    }
    const core::Result<std::vector<SketchDescription>> query = describe_file_readings(options.sketch);
    if (!query) return fail(state, query.error());
    const Answer answer = search(*query, *collection, options);
    if (!options.picture.empty()) {
        const auto written = draw(answer, *collection, *query, options.picture);
        if (!written) return fail(state, written.error());
    }
    const DescriptionTimes times(*query);
    if (options.json) return print_object(answer, *collection, times);
    for (std::size_t k = 0; k < answer.ranked.size(); ++k) {
        const db::ModelRecord& model = collection->models()[answer.ranked[k].model].record;
        std::printf("%3zu  %-28s %-16s %8.3f\n", k + 1, model.name.c_str(), model.class_name.c_str(),
                    answer.ranked[k].distance);
    }
    std::printf("silhouette %.1f ms, description %.1f ms, search %.1f ms\n", times.silhouette_ms, times.describe_ms,
                answer.search_ms);
}

}  // namespace

void add_query_command(Command cli, CommandState& state) {
    auto options = std::make_shared<QueryOptions>();
    Command command = cli.command("query", "Rank the collection for one drawing");
    command
        .option("SKETCH", options->sketch,
                "picture, SVG, InkML, Quick-Draw line, stroke list, trace or a tablet's recording")
        .required();
    command.option("--db", options->database, "the index").required();
    command.option("--top", options->top, "results to give").positive().show_default();
    command.option("--jobs", options->jobs, "threads").range(1, kMostJobs);
    command.flag("--rerank", options->rerank,
                 "rank along the likeness of the models among themselves too; the first stays the first");
    command.flag("--json", options->json, "one JSON object on standard output");
    command.option("--picture", options->picture, "write a PNG with the results' matched parts");
    command.runs([options, &state] { run_query(*options, state); });
}

}  // namespace app
