#include "core/mesh/surface_net.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace core {
namespace {

/// Corner c of a cell: x is its lowest bit, then y, then z.
std::size_t corner_index(const FieldGrid& grid, int x, int y, int z, unsigned c) {
    return grid.index(x + static_cast<int>(c & 1U), y + static_cast<int>(c >> 1 & 1U), z + static_cast<int>(c >> 2));
}

/// Calls visit(x, y, z, inside) for each cell that the surface crosses, with the set of its inside corners.
template <typename Visit>
void for_crossed_cells(const FieldGrid& grid, const Visit& visit) {
    for (int z = 0; z + 1 < grid.nz; ++z)
        for (int y = 0; y + 1 < grid.ny; ++y) {
            const std::array<const float*, 4> rows{
                &grid.value[grid.index(0, y, z)], &grid.value[grid.index(0, y + 1, z)],
                &grid.value[grid.index(0, y, z + 1)], &grid.value[grid.index(0, y + 1, z + 1)]};
            const auto column = [&](int x) {  // as if at the lower x of a cell
                unsigned set = 0;
                for (unsigned k = 0; k < 4; ++k) set |= static_cast<unsigned>(rows[k][x] < 0.0F) << (2 * k);
                return set;
            };
            unsigned before = column(0);
            for (int x = 0; x + 1 < grid.nx; ++x) {
                const unsigned after = column(x + 1), inside = before | after << 1;
                before = after;
                if (inside != 0 && inside != 255) visit(x, y, z, inside);
            }
        }
}

/// The mean of the places where the cell's edges cross the surface, of which there are some.
Vec3 crossing_mean(const FieldGrid& grid, int x, int y, int z) {
    static constexpr std::array<std::array<std::size_t, 2>, 12> kEdges{
        {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    std::array<double, 8> v{};
    for (unsigned c = 0; c < 8; ++c) v[c] = static_cast<double>(grid.value[corner_index(grid, x, y, z, c)]);
    const auto corner = [](std::size_t c) {
        return Vec3{static_cast<double>(c & 1), static_cast<double>(c >> 1 & 1), static_cast<double>(c >> 2)};
    };
    Vec3 sum;
    int count = 0;
    for (const auto& [a, b] : kEdges) {
        if ((v[a] < 0.0) == (v[b] < 0.0)) continue;
        const double t = v[a] / (v[a] - v[b]);
        sum = sum + corner(a) * (1.0 - t) + corner(b) * t;
        ++count;
    }
    return grid.place(x, y, z) + sum * (grid.cell / count);
}

/// For each of the 256 sets of inside corners: whether the surface passes the cell in one sheet. The inside and the
/// outside corners hang together along edges, and no face has its inside corners at opposite ends only (there four
/// quads would meet in an edge).
std::array<bool, 256> one_sheet_table() {
    const auto connected = [](unsigned set) {
        if (set == 0) return true;
        unsigned reached = set & (~set + 1U);
        for (int round = 0; round < 8; ++round)
            for (unsigned c = 0; c < 8; ++c)
                if ((reached >> c & 1U) != 0)
                    for (const unsigned step : {1U, 2U, 4U}) reached |= 1U << (c ^ step) & set;
        return reached == set;
    };
    std::array<bool, 256> table{};
    for (unsigned set = 0; set < 256; ++set) {
        bool good = connected(set) && connected(~set & 255U);
        for (unsigned c = 0; c < 8; ++c)
            for (const auto& [u, v] : {std::array{1U, 2U}, std::array{2U, 4U}, std::array{4U, 1U}}) {
                const bool here = set >> c & 1U, diagonal = set >> (c ^ u ^ v) & 1U;
                const bool beside = set >> (c ^ u) & 1U, other = set >> (c ^ v) & 1U;
                good = good && !(here == diagonal && beside == other && here != beside);
            }
        table[set] = good;
    }
    return table;
}

/// A directed edge of a quad, for sorting.
struct Side {
    std::uint32_t low, high;
    bool forward;
};

}  // namespace

void join_double_sheets(FieldGrid& grid) {
    static const std::array<bool, 256> kOneSheet = one_sheet_table();
    constexpr float kBarelyInside = -1e-6F;
    for (bool changed = true; changed;) {
        changed = false;
        for_crossed_cells(grid, [&](int x, int y, int z, unsigned inside) {
            if (kOneSheet[inside]) return;
            float least = std::numeric_limits<float>::max();
            for (unsigned c = 0; c < 8; ++c) {
                const float value = grid.value[corner_index(grid, x, y, z, c)];
                if (value >= 0.0F) least = std::min(least, value);
            }
            for (unsigned c = 0; c < 8; ++c) {  // equal ones together: a symmetric field stays so
                float& value = grid.value[corner_index(grid, x, y, z, c)];
                if (value == least) value = kBarelyInside;
            }
            changed = true;
        });
    }
}

QuadMesh surface_net(const FieldGrid& grid) {
    QuadMesh mesh;
    std::vector<std::uint32_t> vertex_of(grid.value.size(), 0);
    for_crossed_cells(grid, [&](int x, int y, int z, unsigned /*inside*/) {
        vertex_of[grid.index(x, y, z)] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(crossing_mean(grid, x, y, z));
    });
    for (int z = 1; z + 1 < grid.nz; ++z)
        for (int y = 1; y + 1 < grid.ny; ++y)
            for (int x = 1; x + 1 < grid.nx; ++x) {
                const bool inside = grid.value[grid.index(x, y, z)] < 0.0F;
                const auto cross_edge = [&](std::size_t other, std::size_t a, std::size_t b, std::size_t c,
                                            std::size_t d) {
                    if (inside == (grid.value[other] < 0.0F)) return;
                    Quad quad{vertex_of[a], vertex_of[b], vertex_of[c], vertex_of[d]};
                    if (!inside) std::swap(quad[1], quad[3]);
                    mesh.quads.push_back(quad);
                };
                const auto at = [&](int i, int j, int k) { return grid.index(x + i, y + j, z + k); };
                cross_edge(at(1, 0, 0), at(0, -1, -1), at(0, 0, -1), at(0, 0, 0), at(0, -1, 0));
                cross_edge(at(0, 1, 0), at(-1, 0, -1), at(-1, 0, 0), at(0, 0, 0), at(0, 0, -1));
                cross_edge(at(0, 0, 1), at(-1, -1, 0), at(0, -1, 0), at(0, 0, 0), at(-1, 0, 0));
            }
    return mesh;
}

bool is_closed_manifold(const QuadMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(4 * mesh.quads.size());
    std::vector<std::uint32_t> around(mesh.vertices.size(), 0);
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t a = q[k], b = q[(k + 1) % 4];
            if (a == b || std::max(a, b) >= mesh.vertices.size()) return false;
            sides.push_back({std::min(a, b), std::max(a, b), a < b});
            ++around[a];
        }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.low, x.high, x.forward) < std::tie(y.low, y.high, y.forward);
    });
    if (sides.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        const Side &x = sides[i], &y = sides[i + 1];
        if (x.low != y.low || x.high != y.high || x.forward == y.forward) return false;
        if (i + 2 < sides.size() && sides[i + 2].low == x.low && sides[i + 2].high == x.high) return false;
    }
    // One fan a vertex: following the quads from any one of them comes back after all of them.
    std::vector<std::vector<std::array<std::uint32_t, 2>>> fans(mesh.vertices.size());  // {next, previous} corner
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) fans[q[k]].push_back({q[(k + 1) % 4], q[(k + 3) % 4]});
    for (const auto& fan : fans) {
        if (fan.empty()) return false;
        std::size_t steps = 0;
        std::uint32_t edge = fan[0][0];
        do {
            const auto next = std::find_if(fan.begin(), fan.end(), [&](const auto& f) { return f[0] == edge; });
            if (next == fan.end()) return false;
            edge = (*next)[1];
        } while (++steps < fan.size() && edge != fan[0][0]);
        if (steps != fan.size()) return false;
    }
    return true;
}

}  // namespace core
