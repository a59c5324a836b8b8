#include "core/mesh/flow_loops.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace core {
namespace {

constexpr std::uint32_t kNone = ~0U;

/// For side k of quad q, at 4 q + k: the side of another quad on the same edge; kNone on a border. An edge with more
/// than two quads joins them in pairs.
std::vector<std::uint32_t> partners(std::span<const Quad> quads) {
    struct Side {
        std::uint32_t low, high, at;
    };
    std::vector<Side> sides;
    sides.reserve(quads.size() * 4);
    for (std::size_t q = 0; q < quads.size(); ++q)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t a = quads[q][k], b = quads[q][(k + 1) % 4];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(4 * q + k)});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return x.low != y.low ? x.low < y.low : x.high != y.high ? x.high < y.high : x.at < y.at;
    });
    std::vector<std::uint32_t> partner(sides.size(), kNone);
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        if (sides[i].low != sides[i + 1].low || sides[i].high != sides[i + 1].high) continue;
        partner[sides[i].at] = sides[i + 1].at;
        partner[sides[i + 1].at] = sides[i].at;
        ++i;
    }
    return partner;
}

std::uint32_t opposite(std::uint32_t side) {
    return side ^ 2U;  // sides k and k + 2 of the same quad
}

}  // namespace

int count_closed_flow_loops(std::span<const Quad> quads) {
    const std::vector<std::uint32_t> partner = partners(quads);
    std::vector<bool> seen(partner.size(), false);
    const auto walk = [&](std::uint32_t side) {  // marks the band that enters a quad through `side`
        while (side != kNone && !seen[side]) {
            seen[side] = seen[opposite(side)] = true;
            side = partner[opposite(side)];
        }
    };
    for (std::uint32_t side = 0; side < partner.size(); ++side)
        if (partner[side] == kNone) walk(side);
    int loops = 0;
    for (std::uint32_t side = 0; side < partner.size(); ++side) {
        if (seen[side]) continue;
        walk(side);
        ++loops;
    }
    return loops;
}

}  // namespace core
