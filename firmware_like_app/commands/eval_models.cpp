// croquis eval models: the leave-one-out test of thesis 7.1.3. Every model, by its two views, queries all others.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <limits>
#include <map>

#include "core/rerank/set_rerank.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/eval_lists.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "firmware_like_app/commands/progress_bar.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

/// n x n distances between models: the least over both views of each.
struct ModelDistances {
    std::vector<float> parts, fused;
};

/// Both distances of one pair. The views nearest by their contours first, so that others are given up soon.
void compare(const CollectionModel& a, const CollectionModel& b, core::FusedMatcher& matcher, float& parts,
             float& fused) {
    struct ViewPair {
        double contour = 0.0;
        std::size_t of_a = 0, of_b = 0;
    };
    std::array<ViewPair, 4> pairs;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        pairs[k] = {matcher.contour().distance(a.views[k / 2].contour, b.views[k % 2].contour), k / 2, k % 2};
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const ViewPair& p, const ViewPair& q) { return p.contour < q.contour; });
    double least_parts = std::numeric_limits<double>::infinity(), least_fused = least_parts;
    for (const ViewPair& pair : pairs) {
        // What may still lower one of the two; a little above, because of rounding.
        const double of_fused = core::parts_limit(pair.contour, least_fused);
        const double give_up_at = std::max(least_parts, of_fused);
        const double d = matcher.parts().distance(a.views[pair.of_a].parts, b.views[pair.of_b].parts, give_up_at);
        least_parts = std::min(least_parts, d);
        least_fused = std::min(least_fused, core::fused_distance(d, pair.contour));
    }
    parts = static_cast<float>(least_parts);
    fused = static_cast<float>(least_fused);
}

ModelDistances all_distances(const std::vector<CollectionModel>& models, int jobs) {
    const std::size_t n = models.size();
    ModelDistances out{std::vector<float>(n * n), std::vector<float>(n * n)};
    std::vector<core::FusedMatcher> matchers(static_cast<std::size_t>(std::max(1, jobs)));
    ProgressBar bar("models");
    std::atomic<std::size_t> done{0};
    core::parallel_for(n, std::max(1, jobs), [&](std::size_t i, int worker) {
        for (std::size_t j = i + 1; j < n; ++j) {
            float &parts = out.parts[i * n + j], &fused = out.fused[i * n + j];
            compare(models[i], models[j], matchers[static_cast<std::size_t>(worker)], parts, fused);
            out.parts[j * n + i] = parts;
            out.fused[j * n + i] = fused;
        }
        ++done;
        if (worker == 0) bar.show(done, n);
    });
    return out;
}

/// How well one distance does.
struct Row {
    std::string name;
    core::RetrievalMetrics models;   ///< every model counts alike …
    core::RetrievalMetrics classes;  ///< … or every class
    std::map<std::string, core::RetrievalMetrics> by_class;
};

Row test(const std::string& name, const std::vector<float>& distances, const std::vector<std::string>& classes) {
    const std::size_t n = classes.size();
    std::map<std::string, std::vector<core::RetrievalMetrics>> by_class;
    std::vector<core::RetrievalMetrics> all;
    for (std::size_t q = 0; q < n; ++q) {
        const std::vector<float> row(distances.begin() + static_cast<std::ptrdiff_t>(q * n),
                                     distances.begin() + static_cast<std::ptrdiff_t>((q + 1) * n));
        std::vector<char> relevant;
        for (const int other : core::ranking(row)) {
            if (static_cast<std::size_t>(other) == q) continue;
            relevant.push_back(classes[static_cast<std::size_t>(other)] == classes[q] ? 1 : 0);
        }
        const auto others = static_cast<int>(std::count(relevant.begin(), relevant.end(), 1));
        all.push_back(core::metrics_of_ranking(relevant, others));
        by_class[classes[q]].push_back(all.back());
    }
    Row out{name, core::mean_metrics(all), {}, {}};
    std::vector<core::RetrievalMetrics> means;
    for (const auto& [class_name, metrics] : by_class) {
        out.by_class[class_name] = core::mean_metrics(metrics);
        means.push_back(out.by_class[class_name]);
    }
    out.classes = core::mean_metrics(means);
    return out;
}

void print_object(const std::vector<Row>& rows, const std::map<std::string, int>& sizes, std::size_t models,
                  double ms) {
    ordered_json means, over_classes, classes;
    for (const auto& [name, size] : sizes) classes[name]["models"] = size;
    for (const Row& row : rows) {
        means[row.name] = to_json(row.models);
        over_classes[row.name] = to_json(row.classes);
        for (const auto& [name, mean] : row.by_class) classes[name][row.name] = to_json(mean);
    }
    const ordered_json out{
        {"models", models}, {"rows", means}, {"mean_over_classes", over_classes}, {"by_class", classes}, {"ms", ms}};
    print_json(out);
}

void print_table(const std::vector<Row>& rows, const std::map<std::string, int>& sizes, std::size_t models, double ms) {
    std::printf("%zu models of %zu classes, each against all others; %.1f s\n", models, sizes.size(), ms / 1000.0);
    for (const Row& row : rows) print_metrics(row.name, row.models);
    for (const Row& row : rows) print_metrics(row.name + ", mean over classes", row.classes);
    std::printf("nearest neighbour, per cent\n%-24s %6s", "class", "models");
    for (const Row& row : rows) std::printf(" %8s", row.name.c_str());
    std::printf("\n");
    for (const auto& [name, size] : sizes) {
        std::printf("%-24s %6d", name.c_str(), size);
        for (const Row& row : rows) std::printf(" %8.1f", 100.0 * row.by_class.at(name).nn);
        std::printf("\n");
    }
}

}  // namespace

void run_eval_models(const EvalOptions& options, CommandState& state) {
    const core::Result<Collection> collection = load_for_eval(options.database);
    if (!collection) return fail(state, collection.error());
    const Stopwatch watch;
    std::vector<std::string> classes;
    std::map<std::string, int> sizes;
    for (const CollectionModel& model : collection->models()) {
        classes.push_back(model.record.class_name);
        ++sizes[model.record.class_name];
    }
    const ModelDistances distances = all_distances(collection->models(), options.jobs);
    const std::vector<Row> rows{
        test("parts", distances.parts, classes), test("fused", distances.fused, classes),
        test("reranked", core::reranked_distances(distances.fused, classes.size(), options.jobs), classes)};
    if (options.json) return print_object(rows, sizes, classes.size(), watch.ms());
    print_table(rows, sizes, classes.size(), watch.ms());
}

}  // namespace app
