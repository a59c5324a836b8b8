// What a search takes, for many drawings one after the other:
//
//     search_bench INDEX DRAWINGS [COUNT [JOBS [BEST [SEED]]]]
//
// DRAWINGS is a folder of Quick-Draw files or a list (lines `path<TAB>class`), of which COUNT (60) are chosen by SEED.
// Each is described and its BEST (10) nearest models of INDEX are looked for on JOBS threads (2), three times, of which
// the least counts. Prints median, 95th and 99th percentile and the most, in processor time of all threads, which is
// nearly the same whoever else uses the machine, and in real time, which is not; and which drawings took the most. 60
// drawings take about 15 s; how far it has come stands on the error output.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/exchange/list_file.hpp"
#include "firmware_like_app/collection/collection.hpp"
#include "firmware_like_app/collection/sketch_description.hpp"
#include "firmware_like_app/collection/stopwatch.hpp"
#include "support/chosen_drawings.hpp"

namespace {

constexpr int kTimes = 3;  // the least counts

[[noreturn]] void give_up(const core::Error& error) {
    std::fprintf(stderr, "search_bench: %s\n", error.sentence().c_str());
    std::exit(1);
}

double cpu_ms() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

std::vector<std::string> drawings_of(const std::string& source, std::size_t count, unsigned seed) {
    if (std::filesystem::is_directory(source)) return support::chosen_drawings(source, count, seed);
    const auto list = core::read_list_file(source, std::nullopt);
    if (!list) give_up(list.error());
    std::vector<std::string> paths;
    for (const core::LabelledFile& file : list->files) paths.push_back(file.path);
    std::shuffle(paths.begin(), paths.end(), std::mt19937(seed));
    paths.resize(std::min(paths.size(), count));
    return paths;
}

void print(const char* what, std::vector<double> ms) {
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) {
        return ms[std::min(ms.size() - 1, static_cast<std::size_t>(share * static_cast<double>(ms.size())))];
    };
    std::printf("%-10s median %6.1f   p95 %6.1f   p99 %6.1f   most %6.1f ms\n", what, at(0.5), at(0.95), at(0.99),
                ms.back());
}

struct Taken {
    double ms = 0.0;  ///< of processor
    std::string path;
    std::size_t readings = 0, parts = 0;  ///< of all readings
};

void print_slowest(std::vector<Taken> all) {
    constexpr std::size_t kShown = 3;
    std::stable_sort(all.begin(), all.end(), [](const Taken& a, const Taken& b) { return a.ms > b.ms; });
    all.resize(std::min(all.size(), kShown));
    for (const Taken& t : all) {
        std::printf("%6.1f ms: %zu readings with %zu parts, %s\n", t.ms, t.readings, t.parts, t.path.c_str());
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fprintf(stderr, "search_bench INDEX DRAWINGS [COUNT [JOBS [BEST [SEED]]]]\n");
        return 2;
    }
    const auto number = [&](int i, int otherwise) { return argc > i ? std::max(1, std::atoi(argv[i])) : otherwise; };
    const int jobs = number(4, 2);
    const auto best = static_cast<std::size_t>(number(5, 10));
    const auto collection = app::Collection::load(argv[1]);
    if (!collection) give_up(collection.error());
    const std::vector<std::string> paths =
        drawings_of(argv[2], static_cast<std::size_t>(number(3, 60)), static_cast<unsigned>(number(6, 1)));
    std::vector<double> cpu, real;
    std::vector<Taken> taken;
    for (std::size_t k = 0; k < paths.size(); ++k) {
        if (k % 10 == 0) std::fprintf(stderr, "drawing %zu of %zu\n", k, paths.size());
        const auto drawing = app::describe_file_readings(paths[k]);
        if (!drawing) continue;
        const std::vector<core::ComparableShape> query = app::comparable(*drawing);
        double least_cpu = 1e9, least_real = 1e9;
        for (int time = 0; time < kTimes; ++time) {
            const double before = cpu_ms();
            const app::Stopwatch watch;
            (void)collection->nearest(query, best, jobs);
            least_real = std::min(least_real, watch.ms());
            least_cpu = std::min(least_cpu, cpu_ms() - before);
        }
        real.push_back(least_real);
        cpu.push_back(least_cpu);
        taken.push_back({least_cpu, paths[k], drawing->size(), 0});
        for (const app::SketchDescription& reading : *drawing) {
            taken.back().parts += reading.shape.descriptor.parts.size();
        }
    }
    if (cpu.empty()) {
        std::fprintf(stderr, "search_bench: none of the drawings can be read\n");
        return 1;
    }
    std::printf("%zu drawings, %zu models, the first %zu, %d threads\n", cpu.size(), collection->models().size(), best,
                jobs);
    print("processor", cpu);
    print("real", real);
    print_slowest(std::move(taken));
    return 0;
}
