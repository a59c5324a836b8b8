// croquis eval shapes, croquis eval sketches: the retrieval figures.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <random>

#include "core/base/parallel.hpp"
#include "core/evaluate/retrieval_metrics.hpp"
#include "core/exchange/list_file.hpp"
#include "core/rerank/set_rerank.hpp"
#include "firmware_like_app/collection/collection.hpp"
#include "firmware_like_app/collection/sketch_description.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/commands.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

struct EvalOptions {
    std::string list, files, database;
    int ranks = 0;
    int jobs = core::core_count();
    std::optional<unsigned> shuffle;
    bool json = false;
};

/// The described files of a list, in its order.
struct DescribedList {
    std::vector<std::string> classes;
    std::vector<core::ComparableShape> shapes;
    std::vector<std::string> failures;
};

core::Result<core::LabelledList> read_list(const EvalOptions& options) {
    std::optional<std::string> files;
    if (!options.files.empty()) files = options.files;
    core::Result<core::LabelledList> list = core::read_list_file(options.list, files);
    if (!list) return core::unexpected(list.error());
    if (list->files.empty()) {
        return core::unexpected(core::ErrorCode::FileMissing, "none of the files that it names is there; check --files",
                                options.list);
    }
    for (const core::LabelledFile& missing : list->missing) {
        if (list->missing.size() > 20) break;
        std::fprintf(stderr, "croquis: %s: listed but not there\n", missing.path.c_str());
    }
    if (list->missing.size() > 20)
        std::fprintf(stderr, "croquis: %zu listed files are not there\n", list->missing.size());
    return list;
}

DescribedList describe_list(const std::vector<core::LabelledFile>& files, int jobs) {
    std::vector<std::optional<core::ComparableShape>> shapes(files.size());
    std::vector<std::string> why(files.size());
    core::parallel_for(files.size(), jobs, [&](std::size_t i, int) {
        const core::Result<SketchDescription> d = describe_file(files[i].path);
        if (d) {
            shapes[i] = core::comparable(d->shape.descriptor, d->contour);
        } else {
            why[i] = d.error().sentence();
        }
    });
    DescribedList out;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (!shapes[i]) {
            out.failures.push_back(why[i]);
            continue;
        }
        out.classes.push_back(files[i].class_name);
        out.shapes.push_back(std::move(*shapes[i]));
    }
    for (const std::string& failure : out.failures) std::fprintf(stderr, "croquis: %s\n", failure.c_str());
    return out;
}

int largest_class(const std::vector<std::string>& classes) {
    std::map<std::string, int> count;
    int largest = 0;
    for (const std::string& c : classes) largest = std::max(largest, ++count[c]);
    return largest;
}

/// A shuffled list in which equal distances are still broken by the order of the unshuffled one.
std::vector<std::size_t> shuffled_order(std::size_t n, std::optional<unsigned> seed) {
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = i;
    if (!seed) return order;
    std::mt19937 random(*seed);
    for (std::size_t i = n; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
}

/// n x n distances, row: query.
using Square = std::vector<float>;

struct ReadingDistances {
    Square parts, fused;
    double parts_us = 0.0, fused_us = 0.0;  ///< a pair, on one core
};

/// Both distances of all pairs. Row and column stand for the file's place in the list, so that shuffling changes the
/// order of the work alone.
ReadingDistances all_distances(const std::vector<core::ComparableShape>& shapes, const std::vector<std::size_t>& order,
                               int jobs) {
    const std::size_t n = shapes.size();
    std::vector<core::FusedMatcher> matchers(static_cast<std::size_t>(jobs));
    const auto fill = [&](Square& square, const auto& distance) {
        square.resize(n * n);
        const Stopwatch watch;
        core::parallel_for(n, jobs, [&](std::size_t i, int worker) {
            core::FusedMatcher& matcher = matchers[static_cast<std::size_t>(worker)];
            for (std::size_t j = 0; j < n; ++j) {
                square[order[i] * n + order[j]] = static_cast<float>(distance(matcher, i, j));
            }
        });
        return watch.ms() * 1000.0 * jobs / static_cast<double>(n * n);
    };
    ReadingDistances out;
    Square contour;
    out.parts_us = fill(out.parts, [&](core::FusedMatcher& matcher, std::size_t i, std::size_t j) {
        return matcher.parts().distance(shapes[i].parts, shapes[j].parts);
    });
    const double contour_us = fill(contour, [&](core::FusedMatcher& matcher, std::size_t i, std::size_t j) {
        return matcher.contour().distance(shapes[i].contour, shapes[j].contour);
    });
    out.fused_us = out.parts_us + contour_us;
    out.fused.resize(n * n);
    for (std::size_t k = 0; k < n * n; ++k) {
        out.fused[k] = static_cast<float>(core::fused_distance(out.parts[k], contour[k]));
    }
    return out;
}

struct NamedTest {
    const char* name;
    core::ShapeTest test;
};

void print_tests(const std::vector<NamedTest>& rows, std::size_t n, int ranks, const ReadingDistances& distances,
                 double ms_per_query, bool as_json) {
    if (as_json) {
        ordered_json json;
        for (const auto& [name, test] : rows) {
            json[name] = {{"hits_by_rank", test.hits_by_rank}, {"total", test.total}, {"bullseye", test.bullseye}};
        }
        const ordered_json out{{"queries", n},
                               {"rows", json},
                               {"us_per_pair", {{"parts", distances.parts_us}, {"fused", distances.fused_us}}},
                               {"ms_per_query", ms_per_query}};
        std::printf("%s\n", out.dump().c_str());
        return;
    }
    std::printf("%zu shapes; a pair takes %.1f us by parts, %.1f us fused\n", n, distances.parts_us,
                distances.fused_us);
    for (const auto& [name, test] : rows) {
        std::printf("%-9s %6.2f %% of the class in the nearest %d, bull's-eye %6.2f %%; hits by rank:", name,
                    100.0 * test.total, ranks, 100.0 * test.bullseye);
        for (const int hits : test.hits_by_rank) std::printf(" %d", hits);
        std::printf("\n");
    }
}

void run_shapes(const EvalOptions& options, CommandState& state) {
    const core::Result<core::LabelledList> list = read_list(options);
    if (!list) return fail(state, list.error());
    const std::vector<std::size_t> order = shuffled_order(list->files.size(), options.shuffle);
    std::vector<core::LabelledFile> files;
    files.reserve(order.size());
    for (const std::size_t i : order) files.push_back(list->files[i]);
    const DescribedList described = describe_list(files, options.jobs);
    if (!described.failures.empty()) {
        state.exit_code = 1;
        return;
    }
    const std::size_t n = described.shapes.size();
    std::vector<std::string> classes(n);
    for (std::size_t i = 0; i < n; ++i) classes[order[i]] = described.classes[i];
    const Stopwatch watch;
    const ReadingDistances distances = all_distances(described.shapes, order, options.jobs);
    const Square reranked = core::reranked_distances(distances.fused, n, options.jobs);
    const double ms_per_query = watch.ms() / static_cast<double>(n);
    const int ranks = options.ranks > 0 ? options.ranks : largest_class(classes) - 1;
    print_tests({{"parts", core::shape_test(distances.parts, classes, ranks)},
                 {"fused", core::shape_test(distances.fused, classes, ranks)},
                 {"reranked", core::shape_test(reranked, classes, ranks)}},
                n, ranks, distances, ms_per_query, options.json);
}

ordered_json to_json(const core::RetrievalMetrics& m) {
    return {{"NN", m.nn},
            {"FT", m.ft},
            {"ST", m.st},
            {"E", m.e},
            {"DCG", m.dcg},
            {"AP", m.ap},
            {"precision_recall", m.precision}};
}

/// Rankings of all queries by one reading, and how long each took.
struct SketchTest {
    std::vector<core::RetrievalMetrics> metrics;
    std::vector<double> ms;
};

SketchTest test_sketches(const DescribedList& queries, const Collection& collection, RankBy by, int jobs) {
    SketchTest test;
    std::map<std::string, int> class_size;
    for (const CollectionModel& m : collection.models()) ++class_size[m.record.class_name];
    for (std::size_t q = 0; q < queries.shapes.size(); ++q) {
        const Stopwatch watch;
        const std::vector<RankedModel> ranked = collection.rank(queries.shapes[q], by, jobs);
        test.ms.push_back(watch.ms());
        std::vector<char> relevant;
        relevant.reserve(ranked.size());
        for (const RankedModel& r : ranked) {
            relevant.push_back(collection.models()[r.model].record.class_name == queries.classes[q] ? 1 : 0);
        }
        const auto size = class_size.find(queries.classes[q]);
        test.metrics.push_back(core::metrics_of_ranking(relevant, size == class_size.end() ? 0 : size->second));
    }
    return test;
}

/// How long the kiosk's search takes: the first ten alone.
std::vector<double> time_queries(const DescribedList& queries, const Collection& collection, int jobs) {
    constexpr std::size_t kCards = 10;
    std::vector<double> ms;
    for (const core::ComparableShape& query : queries.shapes) {
        const Stopwatch watch;
        (void)collection.nearest(query, kCards, jobs);
        ms.push_back(watch.ms());
    }
    return ms;
}

std::map<std::string, core::RetrievalMetrics> means_by_class(const DescribedList& queries, const SketchTest& test) {
    std::map<std::string, std::vector<core::RetrievalMetrics>> by_class;
    for (std::size_t q = 0; q < queries.classes.size(); ++q) by_class[queries.classes[q]].push_back(test.metrics[q]);
    std::map<std::string, core::RetrievalMetrics> means;
    for (const auto& [name, all] : by_class) means[name] = core::mean_metrics(all);
    return means;
}

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

void run_sketches(const EvalOptions& options, CommandState& state) {
    const core::Result<core::LabelledList> list = read_list(options);
    if (!list) return fail(state, list.error());
    const core::Result<Collection> collection = Collection::load(options.database);
    if (!collection) return fail(state, collection.error());
    for (const db::Damage& d : collection->damaged()) std::fprintf(stderr, "croquis: %s\n", d.sentence().c_str());
    const DescribedList queries = describe_list(list->files, options.jobs);
    if (!queries.failures.empty()) state.exit_code = 1;
    const SketchTest parts = test_sketches(queries, *collection, RankBy::Parts, options.jobs);
    const SketchTest fused = test_sketches(queries, *collection, RankBy::Fused, options.jobs);
    const std::vector<double> ms = time_queries(queries, *collection, options.jobs);
    const auto parts_by_class = means_by_class(queries, parts), fused_by_class = means_by_class(queries, fused);
    const core::RetrievalMetrics parts_mean = core::mean_metrics(parts.metrics);
    const core::RetrievalMetrics fused_mean = core::mean_metrics(fused.metrics);
    if (options.json) {
        ordered_json classes;
        for (const auto& [name, mean] : parts_by_class) {
            classes[name] = {{"parts", to_json(mean)}, {"fused", to_json(fused_by_class.at(name))}};
        }
        const ordered_json out{{"queries", queries.shapes.size()},
                               {"models", collection->models().size()},
                               {"rows", {{"parts", to_json(parts_mean)}, {"fused", to_json(fused_mean)}}},
                               {"by_class", classes},
                               {"ms_per_query",
                                {{"median", percentile(ms, 0.5)},
                                 {"p95", percentile(ms, 0.95)},
                                 {"p99", percentile(ms, 0.99)},
                                 {"max", percentile(ms, 1.0)}}}};
        std::printf("%s\n", out.dump().c_str());
        return;
    }
    const auto print = [](const std::string& name, const core::RetrievalMetrics& m) {
        std::printf("%-24s NN %.3f  FT %.3f  ST %.3f  E %.3f  DCG %.3f  AP %.3f\n", name.c_str(), m.nn, m.ft, m.st, m.e,
                    m.dcg, m.ap);
    };
    std::printf("%zu sketches, %zu models; the first ten take %.1f ms (median), %.1f ms (p95), %.1f ms (p99)\n",
                queries.shapes.size(), collection->models().size(), percentile(ms, 0.5), percentile(ms, 0.95),
                percentile(ms, 0.99));
    print("parts", parts_mean);
    print("fused", fused_mean);
    for (const auto& [name, mean] : parts_by_class) {
        print("  " + name + ", parts", mean);
        print("  " + name + ", fused", fused_by_class.at(name));
    }
}

}  // namespace

void add_eval_commands(CLI::App& cli, CommandState& state) {
    CLI::App* eval = cli.add_subcommand("eval", "Retrieval figures");
    eval->require_subcommand(1);
    auto options = std::make_shared<EvalOptions>();
    CLI::App* shapes = eval->add_subcommand("shapes", "Every shape of a list queries the others");
    CLI::App* sketches = eval->add_subcommand("sketches", "Sketches of a list query a collection");
    for (CLI::App* command : {shapes, sketches}) {
        command->add_option("LIST", options->list, "path<TAB>class lines, or a Princeton .cla file")->required();
        command->add_option("--files", options->files, "folder of the files that a .cla numbers");
        command->add_option("--jobs", options->jobs, "threads")->check(CLI::PositiveNumber);
        command->add_flag("--json", options->json, "one JSON object on standard output");
    }
    shapes->add_option("--ranks", options->ranks, "nearest results that count; default: class size less one")
        ->check(CLI::PositiveNumber);
    shapes->add_option("--shuffle", options->shuffle, "reorder the list first, by this seed; changes no rank");
    sketches->add_option("--db", options->database, "the index")->required();
    shapes->callback([options, &state] { run_shapes(*options, state); });
    sketches->callback([options, &state] { run_sketches(*options, state); });
}

}  // namespace app
