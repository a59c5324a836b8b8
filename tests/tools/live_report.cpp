// How soon the kiosk knows what a drawing looks like: recorded drawings in their own time, the samples that came since
// the kiosk looked last are a batch, the newest batch searched as soon as the search before is done.
//
//     live_report INDEX FOLDER [COUNT [JOBS [EVERY [SEED]]]] [--quiet-cores N] [--look-ms MS]
//
// The kiosk looks for samples every 2 ms; with --look-ms 16.7 only once a frame, as where a frame waits for the screen.

// Time is that of the recording; a search takes as long as it takes here. So nothing waits for a hand, and every batch
// is searched that the kiosk would search; with EVERY N only each Nth of them, the others taking as long as the one
// before. With --quiet-cores N a search counts as long as it would take on N cores with nothing else to do: the
// processor time of silhouette and description, and that of the search shared evenly; JOBS has to be 1 for that. So
// figures can be had on a machine that others use. FOLDER holds Quick-Draw files; COUNT drawings are chosen by SEED.
// Prints for every batch the time from its last sample until a ranking was there that knew it, and the stages of the
// searches.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "core/exchange/sketch_reader.hpp"
#include "firmware_like_app/collection/sketch_searcher.hpp"
#include "support/chosen_drawings.hpp"

namespace {

constexpr double kLook_ms = 2;            // as Surface::next_frame
constexpr double kLongestLift_ms = 1500;  // as the kiosk's replays
constexpr int kBest = 10;                 // as the kiosk

/// Samples of one look: how much of the drawing is there then.
struct Batch {
    double last_ms = 0;  ///< when its last sample was read
    double seen_ms = 0;  ///< when the loop sees it
    std::size_t strokes = 0, samples = 0;
};

std::vector<Batch> batches_of(const core::Drawing& drawing, double look_ms) {
    std::vector<Batch> batches;
    double now = 0, before = 0;
    bool first = true;
    for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
        const std::vector<core::PenSample>& samples = drawing.strokes[i].samples;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const double at = static_cast<double>(samples[k].time_us) / 1000;
            now += first ? 0 : std::clamp(at - before, 0.0, kLongestLift_ms);
            before = at;
            first = false;
            const double seen = (std::floor(now / look_ms) + 1) * look_ms;
            if (batches.empty() || batches.back().seen_ms != seen) batches.emplace_back();
            batches.back() = {now, seen, i + 1, k + 1};
        }
    }
    return batches;
}

core::Drawing part_of(const core::Drawing& whole, const Batch& batch) {
    core::Drawing part;
    part.strokes.assign(whole.strokes.begin(), whole.strokes.begin() + static_cast<std::ptrdiff_t>(batch.strokes));
    part.strokes.back().samples.resize(batch.samples);
    return part;
}

/// Processor time of this thread.
double cpu_ms() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

struct Times {
    std::vector<double> from_sample, from_seen, waited, silhouette, describe, search, whole;
    std::size_t batches = 0, searches = 0, measured = 0;
};

struct Settings {
    int every = 1, quiet_cores = 0;
    double look_ms = kLook_ms;
};

/// A search, and how long it took; with quiet cores its stages are scaled from the clock to processor time.
double search(app::SketchSearcher& searcher, const core::Drawing& drawing, bool unfinished, int quiet_cores,
              Times& times) {
    const auto clock = std::chrono::steady_clock::now();
    const double cpu = cpu_ms();
    app::SearchAnswer answer = unfinished ? searcher.search_unfinished(drawing, {}) : searcher.search(drawing, {});
    double took = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - clock).count();
    if (quiet_cores > 0) {
        const double scale = (cpu_ms() - cpu) / took;
        answer.silhouette_ms *= scale;
        answer.describe_ms *= scale;
        const double rest = took * scale - answer.silhouette_ms - answer.describe_ms;
        answer.search_ms = rest / quiet_cores;
        took = answer.silhouette_ms + answer.describe_ms + answer.search_ms;
    }
    ++times.measured;
    times.whole.push_back(took);
    times.silhouette.push_back(answer.silhouette_ms);
    times.describe.push_back(answer.describe_ms);
    times.search.push_back(answer.search_ms);
    return took;
}

void draw(const core::Drawing& drawing, app::SketchSearcher& searcher, const Settings& settings, Times& times) {
    const std::vector<Batch> batches = batches_of(drawing, settings.look_ms);
    times.batches += batches.size();
    double free_at = 0, took = 0;
    std::size_t next = 0;  // the first batch that no ranking knows
    for (int n = 0; next < batches.size(); ++n) {
        // the search takes the newest batch that is there when it is free
        const double start = std::max(free_at, batches[next].seen_ms);
        std::size_t newest = next;
        while (newest + 1 < batches.size() && batches[newest + 1].seen_ms <= start) ++newest;
        ++times.searches;
        if (n % settings.every == 0) {
            const Batch& batch = batches[newest];
            const bool unfinished = batch.samples < drawing.strokes[batch.strokes - 1].samples.size();
            took = search(searcher, part_of(drawing, batch), unfinished, settings.quiet_cores, times);
        }
        free_at = start + took;
        for (; next <= newest; ++next) {
            times.from_sample.push_back(free_at - batches[next].last_ms);
            times.from_seen.push_back(free_at - batches[next].seen_ms);
            times.waited.push_back(start - batches[next].seen_ms);
        }
    }
}

void print(const char* what, std::vector<double>& ms) {
    if (ms.empty()) return;
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) {
        return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
    };
    std::printf("%-34s p50 %6.1f  p95 %6.1f  p99 %6.1f  max %6.1f ms\n", what, at(0.5), at(0.95), at(0.99), ms.back());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr,
                     "live_report INDEX FOLDER [COUNT [JOBS [EVERY [SEED]]]] [--quiet-cores N] [--look-ms MS]\n");
        return 2;
    }
    Settings settings;
    for (; argc > 4 && std::string(argv[argc - 2]).starts_with("--"); argc -= 2) {
        if (std::string(argv[argc - 2]) == "--quiet-cores") settings.quiet_cores = std::atoi(argv[argc - 1]);
        if (std::string(argv[argc - 2]) == "--look-ms") settings.look_ms = std::max(std::atof(argv[argc - 1]), 0.1);
    }
    const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    auto searcher = app::SketchSearcher::open(argv[1], number(4, 2), kBest);
    if (!searcher) {
        std::fprintf(stderr, "%s\n", searcher.error().sentence().c_str());
        return 1;
    }
    settings.every = std::max(number(5, 1), 1);
    Times times;
    std::size_t drawings = 0;
    for (const std::string& spec : support::chosen_drawings(argv[2], static_cast<std::size_t>(number(3, 200)),
                                                            static_cast<unsigned>(number(6, 1)))) {
        const auto sketch = core::read_sketch(spec);
        if (!sketch || !sketch->drawing) continue;
        draw(*sketch->drawing, **searcher, settings, times);
        ++drawings;
    }
    std::printf("%zu drawings, %zu batches, %zu searches, %zu of them measured\n", drawings, times.batches,
                times.searches, times.measured);
    print("last sample -> ranking", times.from_sample);
    print("seen by the kiosk -> ranking", times.from_seen);
    print("  waited for the search before", times.waited);
    print("  silhouette", times.silhouette);
    print("  description", times.describe);
    print("  search", times.search);
    print("  one search as a whole", times.whole);
    return 0;
}
