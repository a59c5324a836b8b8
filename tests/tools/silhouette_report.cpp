// Draws recorded drawings sample by sample and asks, at every step or every Nth, whether the silhouette that grows with
// the pen is the one made in one go; then how much
// processor time a sample takes.
//
//     silhouette_report FOLDER [COUNT [EVERY [SEED]]] [--wide]
//
// FOLDER holds Quick-Draw files. COUNT drawings are chosen by SEED; EVERY 0 compares nothing and only measures.
// --wide looks at the wide reading of doubtful drawings (drawing_readings.hpp). Exit code 0 when all were the same.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "core/exchange/sketch_reader.hpp"
#include "core/silhouette/drawing_readings.hpp"
#include "support/chosen_drawings.hpp"

namespace {

bool same(const core::Result<core::Silhouette>& a, const core::Result<core::Silhouette>& b) {
    if (!a || !b) return !a && !b && a.error().code == b.error().code;
    return a->image.width == b->image.width && a->image.height == b->image.height &&
           a->image.pixels == b->image.pixels && a->raster.scale == b->raster.scale &&
           a->raster.offset == b->raster.offset;
}

/// Of this thread's own work, so that what else the machine does is left out.
double cpu_ms() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

struct Report {
    std::vector<double> follow_ms, plain_ms, rebuild_ms, give_ms;
    long compared = 0, wrong = 0;
};

void draw(const core::Drawing& whole, int every, const core::SilhouetteOptions& options, Report& report) {
    core::LiveSilhouette live(options);
    core::Drawing so_far;
    long step = 0;
    for (const core::Stroke& stroke : whole.strokes) {
        so_far.strokes.emplace_back();
        for (const core::PenSample& sample : stroke.samples) {
            so_far.strokes.back().samples.push_back(sample);
            const std::uint64_t before = live.rebuilds();
            const double start = cpu_ms();
            live.follow(so_far);
            const double ms = cpu_ms() - start;
            report.follow_ms.push_back(ms);
            (live.rebuilds() == before ? report.plain_ms : report.rebuild_ms).push_back(ms);
            const double give = cpu_ms();
            const auto s = live.silhouette();
            report.give_ms.push_back(cpu_ms() - give);
            if (every == 0 || step++ % every != 0) continue;
            ++report.compared;
            if (!same(s, core::find_silhouette(so_far, options))) ++report.wrong;
        }
    }
}

void print(const char* what, std::vector<double>& ms) {
    if (ms.empty()) return;
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) {
        return ms[static_cast<std::size_t>(share * static_cast<double>(ms.size() - 1))];
    };
    std::printf("%-28s %8zu  median %.3f  p95 %.3f  p99 %.3f  max %.3f ms\n", what, ms.size(), at(0.5), at(0.95),
                at(0.99), ms.back());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "silhouette_report FOLDER [COUNT [EVERY [SEED]]] [--wide]\n");
        return 2;
    }
    core::SilhouetteOptions options;
    if (std::string(argv[argc - 1]) == "--wide") {
        options = core::wide_reading(options);
        --argc;
    }
    const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
    Report report;
    long drawings = 0;
    for (const std::string& spec : support::chosen_drawings(argv[1], static_cast<std::size_t>(number(2, 200)),
                                                            static_cast<unsigned>(number(4, 1)))) {
        const auto sketch = core::read_sketch(spec);
        if (!sketch || !sketch->drawing) continue;
        const long wrong = report.wrong;
        draw(*sketch->drawing, number(3, 0), options, report);
        if (report.wrong != wrong) std::printf("%s: %ld steps differ\n", spec.c_str(), report.wrong - wrong);
        ++drawings;
    }
    std::printf("%ld drawings, %ld steps compared, %ld differ\n", drawings, report.compared, report.wrong);
    print("a sample", report.follow_ms);
    print("  of these without a rebuild", report.plain_ms);
    print("  of these with one", report.rebuild_ms);
    print("giving the silhouette", report.give_ms);
    return report.wrong == 0 ? 0 : 1;
}
