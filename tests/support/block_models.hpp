#pragma once
// Small models made of boxes, each number another shape, and their text as OFF: for tests that need many model files.

#include <array>
#include <cstdio>
#include <random>
#include <string>

#include "core/mesh/triangle_mesh.hpp"

namespace support {

inline void add_box(core::TriangleMesh& mesh, core::Vec3 low, core::Vec3 high) {
    constexpr std::array<std::array<std::uint32_t, 3>, 12> kFaces{{{0, 1, 3},
                                                                   {0, 3, 2},
                                                                   {4, 6, 7},
                                                                   {4, 7, 5},
                                                                   {0, 4, 5},
                                                                   {0, 5, 1},
                                                                   {2, 3, 7},
                                                                   {2, 7, 6},
                                                                   {0, 2, 6},
                                                                   {0, 6, 4},
                                                                   {1, 5, 7},
                                                                   {1, 7, 3}}};
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const double x : {low.x, high.x}) {
        for (const double y : {low.y, high.y}) {
            for (const double z : {low.z, high.z}) mesh.vertices.push_back({x, y, z});
        }
    }
    for (const auto& f : kFaces) mesh.triangles.push_back({first + f[0], first + f[1], first + f[2]});
}

/// A trunk with three to six arms whose places and lengths follow from n.
inline core::TriangleMesh block_model(int n) {
    std::mt19937 random(static_cast<unsigned>(n) + 1);
    const auto real = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random() >> 8) / (1 << 24);
    };
    core::TriangleMesh mesh;
    add_box(mesh, {-2, -0.5, -0.5}, {2, 0.5, 0.5});
    const unsigned arms = 3 + random() % 4;
    for (unsigned k = 0; k < arms; ++k) {
        const double x = -1.9 + 3.2 * k / (arms - 1), width = real(0.2, 0.4), reach = real(1.0, 3.0);
        const double sign = random() % 2 == 0 ? 1.0 : -1.0;
        const double z = real(-0.4, 0.1);
        add_box(mesh, {x, std::min(0.0, sign * reach), z}, {x + width, std::max(0.0, sign * reach), z + width});
    }
    return mesh;
}

inline std::string off_text(const core::TriangleMesh& mesh) {
    std::string text =
        "OFF\n" + std::to_string(mesh.vertices.size()) + " " + std::to_string(mesh.triangles.size()) + " 0\n";
    char line[100];
    for (const core::Vec3& v : mesh.vertices) {
        std::snprintf(line, sizeof line, "%.17g %.17g %.17g\n", v.x, v.y, v.z);
        text += line;
    }
    for (const auto& t : mesh.triangles) {
        std::snprintf(line, sizeof line, "3 %u %u %u\n", t[0], t[1], t[2]);
        text += line;
    }
    return text;
}

}  // namespace support
