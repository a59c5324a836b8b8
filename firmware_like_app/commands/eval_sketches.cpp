// croquis eval sketches: drawings of a list query a collection.

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "core/rerank/query_rerank.hpp"
#include "firmware_like_app/collection/likeness_lists.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/eval_lists.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "firmware_like_app/commands/progress_bar.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

/// Of the index, or measured now where it has none.
core::NearestLists likeness_of(const Collection& collection, int jobs) {
    if (collection.likeness()) return *collection.likeness();
    ProgressBar bar("models compared");
    return measured_likeness(collection.models(), jobs,
                             [&](std::size_t done, std::size_t total) { bar.show(done, total); });
}

/// One way to rank: its metrics, drawing by drawing.
struct Row {
    std::string name;
    std::vector<core::RetrievalMetrics> metrics;
};

class SketchTest {
  public:
    SketchTest(const DescribedSketches& queries, const Collection& collection, int jobs)
        : queries_(queries),
          collection_(collection),
          jobs_(jobs),
          reranker_(core::neighbour_graph(likeness_of(collection, jobs)), jobs) {
        for (const CollectionModel& m : collection.models()) ++class_size_[m.record.class_name];
    }

    /// Drawings of these classes count as finding nothing.
    [[nodiscard]] std::set<std::string> classes_without_models() const {
        std::set<std::string> lacking;
        for (const std::string& name : queries_.classes) {
            if (class_size_.count(name) == 0) lacking.insert(name);
        }
        return lacking;
    }

    std::vector<Row> run() const {
        std::vector<Row> rows{{"parts", {}}, {"fused", {}}, {"reranked", {}}};
        ProgressBar bar("drawings ranked");
        for (std::size_t q = 0; q < queries_.sketches.size(); ++q) {
            const BothRankings ranked = collection_.rank_both_ways(queries_.sketches[q], jobs_);
            rows[0].metrics.push_back(metrics_of(q, ranked.by_parts));
            rows[1].metrics.push_back(metrics_of(q, ranked.fused));
            rows[2].metrics.push_back(metrics_of(q, reranked(reranker_, ranked.fused)));
            bar.show(q + 1, queries_.sketches.size());
        }
        return rows;
    }

    /// How long the kiosk's search takes: the first ten alone.
    [[nodiscard]] std::vector<double> times_ms() const {
        constexpr std::size_t kCards = 10;
        std::vector<double> ms;
        ProgressBar bar("drawings timed");
        for (const std::vector<core::ComparableShape>& query : queries_.sketches) {
            const Stopwatch watch;
            (void)collection_.nearest(query, kCards, jobs_);
            ms.push_back(watch.ms());
            bar.show(ms.size(), queries_.sketches.size());
        }
        return ms;
    }

  private:
    [[nodiscard]] core::RetrievalMetrics metrics_of(std::size_t query, const std::vector<RankedModel>& ranked) const {
        const std::string& wanted = queries_.classes[query];
        std::vector<char> relevant;
        relevant.reserve(ranked.size());
        for (const RankedModel& r : ranked) {
            relevant.push_back(collection_.models()[r.model].record.class_name == wanted ? 1 : 0);
        }
        const auto size = class_size_.find(wanted);
        return core::metrics_of_ranking(relevant, size == class_size_.end() ? 0 : size->second);
    }

    const DescribedSketches& queries_;
    const Collection& collection_;
    int jobs_;
    std::map<std::string, int> class_size_;
    core::QueryReranker reranker_;
};

std::map<std::string, core::RetrievalMetrics> means_by_class(const DescribedSketches& queries, const Row& row) {
    std::map<std::string, std::vector<core::RetrievalMetrics>> by_class;
    for (std::size_t q = 0; q < queries.classes.size(); ++q) by_class[queries.classes[q]].push_back(row.metrics[q]);
    std::map<std::string, core::RetrievalMetrics> means;
    for (const auto& [name, all] : by_class) means[name] = core::mean_metrics(all);
    return means;
}

/// Every class counts alike; one may be left out.
core::RetrievalMetrics mean_over_classes(const std::map<std::string, core::RetrievalMetrics>& classes,
                                         const std::string& without) {
    std::vector<core::RetrievalMetrics> counted;
    for (const auto& [name, mean] : classes) {
        if (name != without) counted.push_back(mean);
    }
    return core::mean_metrics(counted);
}

/// The class with most models: its drawings find it by chance more often than others theirs.
std::string largest_class(const Collection& collection) {
    std::map<std::string, int> sizes;
    for (const CollectionModel& m : collection.models()) ++sizes[m.record.class_name];
    const auto largest =
        std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return largest == sizes.end() ? std::string() : largest->first;
}

double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

struct Report {
    const DescribedSketches& queries;
    const Collection& collection;
    std::vector<Row> rows;
    std::vector<double> ms;
};

void print_object(const Report& report) {
    const std::string without = largest_class(report.collection);
    ordered_json rows, classes, others;
    for (const Row& row : report.rows) {
        rows[row.name] = to_json(core::mean_metrics(row.metrics));
        const auto by_class = means_by_class(report.queries, row);
        for (const auto& [name, mean] : by_class) classes[name][row.name] = to_json(mean);
        others[row.name] = to_json(mean_over_classes(by_class, without));
    }
    const ordered_json out{{"queries", report.queries.sketches.size()},
                           {"models", report.collection.models().size()},
                           {"rows", rows},
                           {"by_class", classes},
                           {"mean_over_classes_without", {{"class", without}, {"rows", others}}},
                           {"ms_per_query",
                            {{"median", percentile(report.ms, 0.5)},
                             {"p95", percentile(report.ms, 0.95)},
                             {"p99", percentile(report.ms, 0.99)},
                             {"max", percentile(report.ms, 1.0)}}}};
    print_json(out);
}

void print_table(const Report& report) {
    std::printf("%zu sketches, %zu models; the first ten take %.1f ms (median), %.1f ms (p95), %.1f ms (p99)\n",
                report.queries.sketches.size(), report.collection.models().size(), percentile(report.ms, 0.5),
                percentile(report.ms, 0.95), percentile(report.ms, 0.99));
    const std::string without = largest_class(report.collection);
    std::map<std::string, std::map<std::string, core::RetrievalMetrics>> by_class;
    for (const Row& row : report.rows) {
        print_metrics(row.name, core::mean_metrics(row.metrics));
        by_class[row.name] = means_by_class(report.queries, row);
    }
    std::printf("mean over classes without %s\n", without.c_str());
    for (const Row& row : report.rows) print_metrics(row.name, mean_over_classes(by_class[row.name], without));
    if (report.rows.empty()) return;
    for (const auto& [name, mean] : by_class[report.rows.front().name]) {
        for (const Row& row : report.rows) print_metrics("  " + name + ", " + row.name, by_class[row.name].at(name));
    }
}

}  // namespace

void run_eval_sketches(const EvalOptions& options, CommandState& state) {
    const core::Result<core::LabelledList> list = read_list(options);
    if (!list) return fail(state, list.error());
    const core::Result<Collection> collection = load_for_eval(options.database);
    if (!collection) return fail(state, collection.error());
    const DescribedSketches queries = describe_sketches(list->files, options.jobs);
    if (!queries.failures.empty()) state.exit_code = 1;
    const SketchTest test(queries, *collection, options.jobs);
    if (const std::set<std::string> lacking = test.classes_without_models(); !lacking.empty()) {
        std::fprintf(stderr, "croquis: %s: drawings of %zu classes, \"%s\" the first, can find no model of theirs\n",
                     options.database.c_str(), lacking.size(), lacking.begin()->c_str());
    }
    const Report report{queries, *collection, test.run(), test.times_ms()};
    if (options.json) return print_object(report);
    print_table(report);
}

}  // namespace app
