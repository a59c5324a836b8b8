// croquis eval shapes: every shape of a list queries the others.

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <map>
#include <random>

#include "core/rerank/set_rerank.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "firmware_like_app/commands/eval_lists.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "firmware_like_app/commands/progress_bar.hpp"

namespace app {

namespace {

using nlohmann::ordered_json;

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
    const auto fill = [&](Square& square, const char* what, const auto& distance) {
        square.resize(n * n);
        ProgressBar bar(what);
        std::atomic<std::size_t> done{0};
        const Stopwatch watch;
        core::parallel_for(n, jobs, [&](std::size_t i, int worker) {
            core::FusedMatcher& matcher = matchers[static_cast<std::size_t>(worker)];
            for (std::size_t j = 0; j < n; ++j) {
                square[order[i] * n + order[j]] = static_cast<float>(distance(matcher, i, j));
            }
            ++done;
            if (worker == 0) bar.show(done, n);
        });
        const double ms = watch.ms();
        bar.show(n, n);
        return ms * 1000.0 * jobs / static_cast<double>(n * n);
    };
    ReadingDistances out;
    Square contour;
    out.parts_us = fill(out.parts, "compared by parts", [&](core::FusedMatcher& matcher, std::size_t i, std::size_t j) {
        return matcher.parts().distance(shapes[i].parts, shapes[j].parts);
    });
    const double contour_us =
        fill(contour, "compared by contours", [&](core::FusedMatcher& matcher, std::size_t i, std::size_t j) {
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
            json[name] = {{"hits_by_rank", test.hits_by_rank},
                          {"total", test.total},
                          {"bullseye", test.bullseye},
                          {"ties", test.ties}};
        }
        const ordered_json out{{"queries", n},
                               {"rows", json},
                               {"us_per_pair", {{"parts", distances.parts_us}, {"fused", distances.fused_us}}},
                               {"ms_per_query", ms_per_query}};
        print_json(out);
        return;
    }
    std::printf("%zu shapes; a pair takes %.1f us by parts, %.1f us fused\n", n, distances.parts_us,
                distances.fused_us);
    for (const auto& [name, test] : rows) {
        std::printf("%-9s %6.2f %% of the class in the nearest %d, bull's-eye %6.2f %%; hits by rank:", name,
                    100.0 * test.total, ranks, 100.0 * test.bullseye);
        for (const int hits : test.hits_by_rank) std::printf(" %d", hits);
        if (test.ties > 0) std::printf("; %d queries with ties, ordered by place in the list", test.ties);
        std::printf("\n");
    }
}

}  // namespace

void run_eval_shapes(const EvalOptions& options, CommandState& state) {
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
    const int others = static_cast<int>(n) - 1;
    const int ranks = std::min(others, options.ranks > 0 ? options.ranks : largest_class(classes) - 1);
    print_tests({{"parts", core::shape_test(distances.parts, classes, ranks)},
                 {"fused", core::shape_test(distances.fused, classes, ranks)},
                 {"reranked", core::shape_test(reranked, classes, ranks)}},
                n, ranks, distances, ms_per_query, options.json);
}

}  // namespace app
