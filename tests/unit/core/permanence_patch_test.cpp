#include "core/garment/permanence_patch.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "core/garment/fill_topology.hpp"
#include "core/mesh/flow_loops.hpp"

using core::PermanencePatch;
using core::Quad;
using core::Vec3;

namespace {

/// (m + 1) x (n + 1) vertices; number() walks the boundary first, anti-clockwise from (0, 0), then the inside.
struct Grid {
    int m, n;
    core::RegionTopology topology;
    std::vector<Vec3> vertices;

    Grid(int m_edges, int n_edges)
        : m(m_edges), n(n_edges), topology(*core::fill_topology(std::array{m, n, m, n})), vertices(topology.vertices) {}

    [[nodiscard]] int border(int i, int j) const {
        return j == 0 ? i : i == m ? m + j : j == n ? 2 * m + n - i : (2 * m + 2 * n - j) % (2 * m + 2 * n);
    }
    [[nodiscard]] Vec3 at_border(int i, int j) const { return vertices[static_cast<std::size_t>(border(i, j))]; }

    /// Where vertex v sits in the grid, found by laying the grid out flat.
    [[nodiscard]] std::vector<Vec3> flat() const {
        std::vector<Vec3> places(vertices.size());
        for (int i = 0; i <= m; ++i)
            for (int j = 0; j <= n; ++j)
                if (i == 0 || j == 0 || i == m || j == n)
                    places[static_cast<std::size_t>(border(i, j))] = {static_cast<double>(i), static_cast<double>(j),
                                                                      0};
        PermanencePatch(topology.quads, topology.vertices, topology.boundary, 0.0).solve(places);
        return places;
    }
    [[nodiscard]] Vec3 coons(int i, int j) const {
        const double u = static_cast<double>(i) / m, v = static_cast<double>(j) / n;
        return at_border(i, 0) * (1 - v) + at_border(i, n) * v + at_border(0, j) * (1 - u) + at_border(m, j) * u -
               (at_border(0, 0) * ((1 - u) * (1 - v)) + at_border(m, 0) * (u * (1 - v)) + at_border(m, n) * (u * v) +
                at_border(0, n) * ((1 - u) * v));
    }
};

void shake_boundary(Grid& grid, unsigned seed) {
    std::mt19937 generator(seed);
    const auto number = [&] { return static_cast<double>(generator() % 2001) / 1000.0 - 1.0; };
    for (std::uint32_t i = 0; i < grid.topology.boundary; ++i) {
        const double x = number(), y = number();
        grid.vertices[i] = {x, y, number()};
    }
}

/// Height of the vertex (m / 2, j) when the vertex (m / 2, 0) of a flat square is lifted to 1.
double bump_height(double alpha, int j) {
    Grid grid(16, 16);
    const std::vector<Vec3> flat = grid.flat();
    grid.vertices = flat;
    grid.vertices[8].z = 1.0;
    PermanencePatch(grid.topology.quads, grid.topology.vertices, grid.topology.boundary, alpha).solve(grid.vertices);
    for (std::size_t v = 0; v < flat.size(); ++v)
        if (std::lround(flat[v].x) == 8 && std::lround(flat[v].y) == j) return grid.vertices[v].z;
    return std::numeric_limits<double>::quiet_NaN();
}

/// A ring of k quads around, `rings` of them one outside the other: its flow lines around close up.
std::vector<Quad> tube(std::uint32_t k, std::uint32_t rings) {
    std::vector<Quad> quads;
    for (std::uint32_t r = 0; r < rings; ++r)
        for (std::uint32_t i = 0; i < k; ++i)
            quads.push_back({r * k + i, r * k + (i + 1) % k, (r + 1) * k + (i + 1) % k, (r + 1) * k + i});
    return quads;
}

}  // namespace

TEST_CASE("alpha = -1/4 on a grid is the discrete Coons patch", "[permanence_patch]") {
    for (const auto& [m, n] : {std::pair{4, 4}, {7, 12}, {30, 21}}) {
        Grid grid(m, n);
        const std::vector<Vec3> flat = grid.flat();
        shake_boundary(grid, 5);
        PermanencePatch(grid.topology.quads, grid.topology.vertices, grid.topology.boundary, core::kCoonsAlpha)
            .solve(grid.vertices);
        double worst = 0.0;
        for (std::size_t v = grid.topology.boundary; v < flat.size(); ++v) {
            const int i = static_cast<int>(std::lround(flat[v].x)), j = static_cast<int>(std::lround(flat[v].y));
            worst = std::max(worst, core::length(grid.coons(i, j) - grid.vertices[v]));
        }
        CHECK(worst < 1e-10);
    }
}

TEST_CASE("every inner vertex satisfies the mask of its valence", "[permanence_patch]") {
    const auto topology = core::fill_topology(std::array{9, 7, 8, 6, 10});
    REQUIRE(topology);
    for (const double alpha : {0.0, -0.1, -0.25}) {
        std::vector<Vec3> v(topology->vertices);
        std::mt19937 generator(9);
        for (std::uint32_t i = 0; i < topology->boundary; ++i)
            v[i] = {static_cast<double>(generator() % 100), static_cast<double>(generator() % 100), 0.0};
        PermanencePatch(topology->quads, topology->vertices, topology->boundary, alpha).solve(v);
        std::vector<Vec3> beside(v.size()), across(v.size());
        std::vector<double> valence(v.size());
        for (const Quad& q : topology->quads)
            for (std::size_t k = 0; k < 4; ++k) {
                beside[q[k]] = beside[q[k]] + v[q[(k + 1) % 4]];  // each neighbour once: it leaves in one quad
                across[q[k]] = across[q[k]] + v[q[(k + 2) % 4]];
                valence[q[k]] += 1.0;
            }
        for (std::size_t i = topology->boundary; i < v.size(); ++i) {
            const double a = alpha * 4.0 / valence[i], b = 1.0 / valence[i] - a;
            CHECK(core::length(across[i] * a + beside[i] * b - v[i]) < 1e-9);
        }
    }
}

TEST_CASE("a bump on the boundary reaches further in as alpha falls", "[permanence_patch]") {
    for (const int depth : {4, 8}) {
        double before = bump_height(0.0, depth);
        CHECK(before > 0.0);
        for (const double alpha : {-0.05, -0.1, -0.15, -0.2, -0.25}) {
            const double here = bump_height(alpha, depth);
            CHECK(here > before);
            before = here;
        }
    }
    CHECK(bump_height(-0.25, 8) == Approx(0.5));
}

TEST_CASE("a change of alpha and a moved boundary give what a new patch gives", "[permanence_patch]") {
    Grid grid(10, 8);
    shake_boundary(grid, 1);
    PermanencePatch live(grid.topology.quads, grid.topology.vertices, grid.topology.boundary, -0.25);
    live.solve(grid.vertices);
    live.set_alpha(-0.1);
    grid.vertices[3].z += 2.0;
    live.solve(grid.vertices);
    std::vector<Vec3> fresh = grid.vertices;
    PermanencePatch(grid.topology.quads, grid.topology.vertices, grid.topology.boundary, -0.1).solve(fresh);
    CHECK(fresh == grid.vertices);
}

TEST_CASE("where a flow line closes up, alpha stays above -1/4", "[permanence_patch]") {
    // the outer ring is the boundary; the inner one, filled by a quad, would turn freely at -1/4
    std::vector<Quad> quads = tube(4, 3);
    quads.push_back({12, 13, 14, 15});
    CHECK(core::count_closed_flow_loops(quads) == 3);
    CHECK(core::count_closed_flow_loops(tube(5, 2)) == 2);
    CHECK(core::count_closed_flow_loops(core::fill_topology(std::array{8, 4, 4})->quads) == 0);
    PermanencePatch patch(quads, 16, 4, -0.25);
    CHECK(patch.alpha() == core::kClosedFlowAlpha);
    std::vector<Vec3> v(16);
    v[0] = {0, 0, 0}, v[1] = {1, 0, 0}, v[2] = {1, 1, 0}, v[3] = {0, 1, 0};
    patch.solve(v);
    for (const Vec3& p : v) CHECK((p.x > -1e-6 && p.x < 1.0 + 1e-6 && p.y > -1e-6 && p.y < 1.0 + 1e-6));
}

TEST_CASE("alpha out of range is clamped, and a mesh without inner vertices is left as it is", "[permanence_patch]") {
    PermanencePatch patch(std::vector<Quad>{{0, 1, 2, 3}}, 4, 4, -7.0);
    CHECK(patch.alpha() == core::kCoonsAlpha);
    patch.set_alpha(3.0);
    CHECK(patch.alpha() == 0.0);
    patch.set_alpha(std::numeric_limits<double>::quiet_NaN());
    CHECK(patch.alpha() == 0.0);
    std::vector<Vec3> v{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<Vec3> before = v;
    patch.solve(v);
    CHECK(v == before);
}
