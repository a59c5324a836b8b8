// Makes mannequins of all sizes and of random bodies and prints how far they are from what was asked.
//
//     mannequin_survey [COUNT]     200 random bodies; exit code 1 when one misses a girth by 0.2 cm, a height by 0.3
//     cm, is
//                                  not closed or passes through itself
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "core/mannequin/mannequin.hpp"
#include "core/mesh/crossings.hpp"
#include "support/random_body.hpp"

namespace {

struct Worst {
    double girth_cm = 0.0, height_cm = 0.0, ms = 0.0;
    int open = 0, crossing = 0, refused = 0;
};

void add(const std::string& name, const core::BodyMeasures& measures, Worst& worst) {
    const std::clock_t start = std::clock();
    const core::Result<core::Mannequin> body = core::make_mannequin(measures);
    const double ms = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    if (!body) {
        std::printf("%s: %s\n", name.c_str(), body.error().sentence().c_str());
        ++worst.refused;
        return;
    }
    const auto check = [&](const std::vector<core::ReachedMeasure>& list, double limit, double& most) {
        for (const core::ReachedMeasure& m : list) {
            const double off = std::abs(m.reached_cm - m.asked_cm);
            most = std::max(most, off);
            if (off > limit)
                std::printf("%s: %s asked %.1f, reached %.2f\n", name.c_str(), m.name.c_str(), m.asked_cm,
                            m.reached_cm);
        }
    };
    check(body->girths, 0.2, worst.girth_cm);
    check(body->heights, 0.3, worst.height_cm);
    const std::size_t crossings = core::self_crossings(body->mesh).size();
    if (crossings > 0) std::printf("%s: %zu pairs of quads cross\n", name.c_str(), crossings);
    worst.crossing += crossings > 0;
    worst.open += !body->closed;
    worst.ms = std::max(worst.ms, ms);
}

void report(const char* what, const Worst& worst) {
    std::printf(
        "%s: girths within %.3f cm, heights within %.3f cm, %d open, %d crossing, %d refused, longest %.0f ms of "
        "processor time\n",
        what, worst.girth_cm, worst.height_cm, worst.open, worst.crossing, worst.refused, worst.ms);
}

bool good(const Worst& w) {
    return w.girth_cm <= 0.2 && w.height_cm <= 0.3 && w.open == 0 && w.crossing == 0 && w.refused == 0;
}

}  // namespace

int main(int argc, char** argv) {
    Worst sizes, random;
    for (const char* size : {"36", "37", "38", "39", "40", "41", "42", "43", "44", "m"})
        add(std::string("size ") + size, *core::measures_of_size(size), sizes);
    report("sizes", sizes);
    const int count = argc > 1 ? std::atoi(argv[1]) : 200;
    for (int i = 0; i < count; ++i)
        add("body " + std::to_string(i), support::random_body(static_cast<unsigned>(i)), random);
    report("random bodies", random);
    return good(sizes) && good(random) ? 0 : 1;
}
