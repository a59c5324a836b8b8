// Any ring of points as an outline: two bytes a coordinate, the first byte says how they are meant.

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "support/outline_promises.hpp"
#include "support/shapes.hpp"

namespace {

core::Polygon ring_of(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return {};
    const unsigned form = data[0];
    // Coarse grids make points meet and lines fall together, fine ones make nearly nothing of them.
    const double unit = form % 4 == 0 ? 1.0 : form % 4 == 1 ? 1e-7 : form % 4 == 2 ? 1e-3 : 1e5;
    const bool steps = (form & 4U) != 0;
    core::Polygon ring;
    core::Point at;
    for (std::size_t i = 1; i + 4 <= size && ring.size() < 2000; i += 4) {
        std::int16_t x = 0, y = 0;
        std::memcpy(&x, data + i, 2);
        std::memcpy(&y, data + i + 2, 2);
        core::Point p{x * unit, y * unit};
        if ((form & 8U) != 0 && x == INT16_MIN) p.x = std::numeric_limits<double>::quiet_NaN();
        if ((form & 8U) != 0 && x == INT16_MAX) p.x = std::numeric_limits<double>::infinity();
        at = steps ? at + p : p;
        ring.push_back(at);
    }
    return ring;
}

support::OutlinePromises make_promises() {
    const auto horse = core::read_outline(support::scaled(support::horse(), 10.0));
    if (!horse) std::abort();
    return support::OutlinePromises({core::comparable(*horse)});
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static support::OutlinePromises promises = make_promises();
    const core::Result<core::OutlineReadings> readings = core::read_outline(ring_of(data, size));
    if (readings && !promises.broken(*readings).empty()) std::abort();
    return 0;
}
