// Describes and compares random and hostile outlines (tests/support/hostile_outlines.hpp) and holds the results to
// what is promised for every outline.
//
//     hostile_outlines [COUNT] [FIRST]       20000 from 0
//
// Prints by kind how many were described and how many refused, and the longest time of one: processor time of
// describing both readings. Exit code 1 when a promise is broken or one took over 50 ms.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>

#include "core/silhouette/contour.hpp"
#include "support/hostile_outlines.hpp"
#include "support/outline_promises.hpp"
#include "support/shapes.hpp"

namespace {

constexpr double kMostMs = 50.0;

double processor_ms() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

core::Result<core::OutlineReadings> described(const support::HostileOutline& outline) {
    if (outline.image.width == 0) return core::read_outline(outline.ring);
    const core::Result<core::Polygon> ring = core::largest_contour(outline.image);
    if (!ring) return core::unexpected(ring.error());
    return core::read_outline(*ring);
}

struct Kind {
    int described = 0, refused = 0;
    double most_ms = 0.0;
    unsigned slowest = 0;
};

std::vector<core::ComparableShape> everyday_shapes() {
    std::vector<core::ComparableShape> shapes;
    for (const core::Polygon& ring : {support::horse(), support::hand(), support::disc(60, 20)}) {
        const core::Result<core::OutlineReadings> readings = core::read_outline(support::scaled(ring, 10.0));
        if (readings) shapes.push_back(core::comparable(*readings));
    }
    return shapes;
}

}  // namespace

int main(int argc, char** argv) {
    const auto number = [&](int i, unsigned otherwise) {
        return argc > i ? static_cast<unsigned>(std::strtoul(argv[i], nullptr, 10)) : otherwise;
    };
    const unsigned count = number(1, 20'000), first = number(2, 0);
    support::OutlinePromises promises(everyday_shapes());
    std::map<std::string, Kind> kinds;
    int faults = 0, slow = 0;
    for (unsigned n = first; n < first + count; ++n) {
        const support::HostileOutline outline = support::hostile_outline(n);
        Kind& kind = kinds[outline.kind];
        const double start = processor_ms();
        const core::Result<core::OutlineReadings> readings = described(outline);
        const double ms = processor_ms() - start;
        if (ms > kind.most_ms) kind.most_ms = ms, kind.slowest = n;
        slow += ms > kMostMs ? 1 : 0;
        ++(readings ? kind.described : kind.refused);
        if (!readings) continue;
        if (const std::string why = promises.broken(*readings); !why.empty()) {
            std::printf("outline %u (%s): %s\n", n, outline.kind.c_str(), why.c_str());
            ++faults;
        }
    }
    std::printf("%-18s %9s %8s %9s\n", "kind", "described", "refused", "most, ms");
    for (const auto& [name, kind] : kinds) {
        std::printf("%-18s %9d %8d %9.2f (number %u)\n", name.c_str(), kind.described, kind.refused, kind.most_ms,
                    kind.slowest);
    }
    std::printf("%u outlines: %d break a promise, %d took over %.0f ms\n", count, faults, slow, kMostMs);
    return faults == 0 && slow == 0 ? 0 : 1;
}
