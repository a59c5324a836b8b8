// Figures of permanence patches.
//
//     patch_figures              distance to the discrete Coons patch; how far a bump reaches in; times for 10,201
//     vertices patch_figures OUT.png      and a picture of three sides with bumps, alpha = 0, -0.125 and -0.25
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/exchange/png_writer.hpp"
#include "core/garment/region.hpp"
#include "support/mesh_picture.hpp"
#include "support/outlines.hpp"

namespace {

using core::Vec3;

/// A square of n x n quads, flat, n wide.
struct Square {
    int n;
    core::RegionTopology topology;
    std::vector<Vec3> flat;

    explicit Square(int edges) : n(edges), topology(*core::fill_topology(std::array{n, n, n, n})) {
        flat.resize(topology.vertices);
        for (int k = 0; k < 4 * n; ++k) {
            const double a = k % n;
            const std::array<Vec3, 4> places{Vec3{a, 0, 0}, Vec3{1.0 * n, a, 0}, Vec3{n - a, 1.0 * n, 0},
                                             Vec3{0, n - a, 0}};
            flat[static_cast<std::size_t>(k)] = places[static_cast<std::size_t>(k / n)];
        }
        patch(0.0).solve(flat);
    }
    [[nodiscard]] core::PermanencePatch patch(double alpha) const {
        return {topology.quads, topology.vertices, topology.boundary, alpha};
    }
    [[nodiscard]] Vec3 border(const std::vector<Vec3>& v, int k) const {
        return v[static_cast<std::size_t>(k % (4 * n))];
    }
};

double distance_to_coons(int n) {
    const Square square(n);
    std::vector<Vec3> v = square.flat;
    for (int k = 0; k < 4 * n; ++k) v[static_cast<std::size_t>(k)].z = n * std::sin(0.7 * k) + 0.01 * (k * 7919 % 101);
    square.patch(core::kCoonsAlpha).solve(v);
    double worst = 0.0;
    for (std::size_t k = square.topology.boundary; k < v.size(); ++k) {
        const int i = static_cast<int>(std::lround(square.flat[k].x)),
                  j = static_cast<int>(std::lround(square.flat[k].y));
        const double s = static_cast<double>(i) / n, t = static_cast<double>(j) / n;
        const Vec3 coons = square.border(v, i) * (1 - t) + square.border(v, 3 * n - i) * t +
                           square.border(v, 4 * n - j) * (1 - s) + square.border(v, n + j) * s -
                           (square.border(v, 0) * ((1 - s) * (1 - t)) + square.border(v, n) * (s * (1 - t)) +
                            square.border(v, 2 * n) * (s * t) + square.border(v, 3 * n) * ((1 - s) * t));
        worst = std::max(worst, core::length(coons - v[k]));
    }
    return worst / n;
}

void print_bumps() {
    const Square square(32);
    std::printf("alpha    height at 25 %%  50 %% of the depth, of a bump of height 1 on 7 vertices\n");
    for (int step = 0; step <= 10; ++step) {
        const double alpha = -0.025 * step;
        std::vector<Vec3> v = square.flat;
        for (int k = 13; k <= 19; ++k) v[static_cast<std::size_t>(k)].z = std::pow(std::cos((k - 16) * 0.3927), 2.0);
        square.patch(alpha).solve(v);
        std::array<double, 2> height{};
        for (std::size_t k = 0; k < v.size(); ++k)
            for (std::size_t d = 0; d < 2; ++d)
                if (std::lround(square.flat[k].x) == 16 && std::lround(square.flat[k].y) == (d == 0 ? 8 : 16))
                    height[d] = v[k].z;
        std::printf("%.3f    %.4f   %.4f\n", alpha, height[0], height[1]);
    }
}

template <typename Work>
double fastest_ms(const Work& work) {
    double ms = 1e300;
    for (int k = 0; k < 9; ++k) {
        const auto start = std::chrono::steady_clock::now();
        work();
        ms = std::min(ms, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    return ms;
}

void print_times() {
    const Square square(100);
    std::vector<Vec3> v = square.flat;
    core::PermanencePatch patch = square.patch(-0.25);
    double alpha = -0.25;
    const double alpha_ms = fastest_ms([&] {
        alpha = alpha < -0.2 ? -0.1 : -0.25;
        patch.set_alpha(alpha);
        patch.solve(v);
    });
    patch.set_alpha(core::kCoonsAlpha);
    const double drag_ms = fastest_ms([&] {
        v[50].z += 0.1;
        patch.solve(v);
    });
    std::printf("%u vertices: new alpha and solve %.2f ms, drag %.2f ms (fastest of 9)\n", square.topology.vertices,
                alpha_ms, drag_ms);
}

int write_picture(const char* path) {
    core::RegionOutline outline = support::circle_outline({48, 40, 40});
    for (std::size_t k = 1; k + 1 < outline.sides[0].size(); ++k)
        outline.sides[0][k].z = 0.12 * std::sin(static_cast<double>(k) / 48.0 * 3.14159265 * 10.0);
    std::vector<core::RgbaImage> pictures;
    for (const double alpha : {0.0, -0.125, -0.25}) {
        const core::FilledRegion filled = *core::fill_region(outline, alpha);
        pictures.push_back(support::draw_meshes({{&filled.mesh, {150, 175, 205}, true}}, {-60, 45, 600, 500}));
    }
    const auto written = core::write_png(path, support::side_by_side(pictures));
    if (!written) std::fprintf(stderr, "%s\n", written.error().sentence().c_str());
    return written ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    for (const int n : {8, 32, 100})
        std::printf("%d x %d quads, alpha = -1/4: within %.1e of the side's length of the discrete Coons patch\n", n, n,
                    distance_to_coons(n));
    print_bumps();
    print_times();
    return argc > 1 ? write_picture(argv[1]) : 0;
}
