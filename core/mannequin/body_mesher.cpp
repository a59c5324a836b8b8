#include "core/mannequin/body_mesher.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>

#include "core/mesh/surface_net.hpp"

namespace core {
namespace {

constexpr int kBlock = 4;
constexpr int kRelaxations = 3;

/// The field at the corners of a grid that x = 0 halves through the middle of cells. Blocks far from the surface get
/// one value. Only the side x > 0 is sampled.
FieldGrid sample_grid(const BodyShape& shape, double cell) {
    const Vec3 low = shape.low(), high = shape.high();
    const auto blocks = [&](double from, double to) {
        return (static_cast<int>(std::ceil((to - from) / cell)) + 4 + kBlock - 1) / kBlock * kBlock;
    };
    const int half = blocks(0.0, high.x);
    FieldGrid grid;
    grid.cell = cell;
    grid.nx = 2 * half;
    grid.ny = blocks(low.y, high.y);
    grid.nz = blocks(low.z, high.z);
    grid.origin = {(0.5 - half) * cell, low.y - 2.3 * cell, low.z - 1.7 * cell};
    grid.value.resize(static_cast<std::size_t>(grid.nx) * static_cast<std::size_t>(grid.ny) *
                      static_cast<std::size_t>(grid.nz));
    const double radius = 0.5 * std::sqrt(3.0) * (kBlock - 1) * cell;
    for (int z = 0; z < grid.nz; z += kBlock)
        for (int y = 0; y < grid.ny; y += kBlock)
            for (int x = half; x < grid.nx; x += kBlock) {
                const Vec3 corner = grid.place(x, y, z);
                const double inset = 0.5 * (kBlock - 1) * cell;
                const Vec3 centre = corner + Vec3{inset, inset, inset};
                const double middle = shape.sample(centre).distance;
                const bool far = std::abs(middle) > 2.0 * radius + 3.0;
                const BodyShape::Mask parts = far ? BodyShape::kAll : shape.near(centre, radius);
                for (int k = 0; k < kBlock * kBlock * kBlock; ++k) {
                    const int i = x + k % kBlock, j = y + k / kBlock % kBlock, l = z + k / (kBlock * kBlock);
                    const double value = far ? middle : shape.sample(grid.place(i, j, l), parts).distance;
                    grid.value[grid.index(i, j, l)] = grid.value[grid.index(grid.nx - 1 - i, j, l)] =
                        static_cast<float>(value);
                }
            }
    return grid;
}

/// Evens out the quads: every vertex goes half the way to the mean of its neighbours, along the surface.
void relax(const BodyShape& shape, const std::vector<BodyShape::Mask>& parts, QuadMesh& mesh) {
    std::vector<Vec3> sum(mesh.vertices.size());
    std::vector<double> count(mesh.vertices.size(), 0.0);
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            sum[q[k]] = sum[q[k]] + mesh.vertices[q[(k + 1) % 4]];
            count[q[k]] += 1.0;
        }
    for (std::size_t v = 0; v < sum.size(); ++v) {
        const Vec3 n = shape.sample(mesh.vertices[v], parts[v]).gradient;
        const Vec3 move = (sum[v] * (1.0 / count[v]) - mesh.vertices[v]) * 0.5;
        mesh.vertices[v] = mesh.vertices[v] + move - n * (dot(move, n) / std::max(dot(n, n), 1e-6));
    }
}

/// For each vertex the one mirrored at x = 0, itself for those in the middle.
std::vector<std::uint32_t> mirror_images(const QuadMesh& mesh) {
    std::vector<std::uint32_t> order(mesh.vertices.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto key = [&](std::uint32_t i) {
        const Vec3 p = mesh.vertices[i];
        return std::tuple(std::llround(p.y * 1e4), std::llround(p.z * 1e4), std::llround(std::abs(p.x) * 1e4),
                          p.x > 0.0);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    std::vector<std::uint32_t> image(order.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) image[i] = i;
    for (std::size_t i = 0; i + 1 < order.size(); ++i) {
        const Vec3 a = mesh.vertices[order[i]], b = mesh.vertices[order[i + 1]];
        if (std::abs(a.x) < 1e-3 || a.x * b.x >= 0.0 || length(Vec3{-a.x, a.y, a.z} - b) > 1e-3) continue;
        image[order[i]] = order[i + 1];
        image[order[i + 1]] = order[i];
        ++i;
    }
    return image;
}

void mirror(const std::vector<std::uint32_t>& image, QuadMesh& mesh) {
    for (std::uint32_t v = 0; v < image.size(); ++v) {
        const Vec3 p = mesh.vertices[v];
        if (image[v] == v) {
            if (std::abs(p.x) < 0.6) mesh.vertices[v].x = 0.0;
        } else if (p.x > 0.0) {
            mesh.vertices[image[v]] = {-p.x, p.y, p.z};
        }
    }
}

/// For each vertex the parts that matter where it may move to.
std::vector<BodyShape::Mask> nearby_parts(const BodyShape& shape, const QuadMesh& mesh) {
    std::vector<BodyShape::Mask> parts;
    parts.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) parts.push_back(shape.near(v, 1.5));
    return parts;
}

void settle(const BodyShape& shape, const std::vector<BodyShape::Mask>& parts, QuadMesh& mesh) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        Vec3& p = mesh.vertices[v];
        const bool middle = p.x == 0.0;
        for (int step = 0; step < 3; ++step) {
            const FieldSample s = shape.sample(p, parts[v]);
            if (std::abs(s.distance) < 1e-5) break;
            p = p - s.gradient * (std::clamp(s.distance, -1.0, 1.0) / std::max(dot(s.gradient, s.gradient), 0.25));
            if (middle) p.x = 0.0;
        }
        p.y = std::max(p.y, 0.0);
    }
}

}  // namespace

QuadMesh mesh_body(const BodyShape& shape, double cell_cm) {
    FieldGrid grid = sample_grid(shape, cell_cm);
    join_double_sheets(grid);
    QuadMesh mesh = surface_net(grid);
    const std::vector<std::uint32_t> image = mirror_images(mesh);
    const std::vector<BodyShape::Mask> parts = nearby_parts(shape, mesh);
    settle(shape, parts, mesh);
    for (int i = 0; i < kRelaxations; ++i) {
        relax(shape, parts, mesh);
        mirror(image, mesh);
    }
    settle(shape, parts, mesh);
    mirror(image, mesh);
    return mesh;
}

void settle_on(const BodyShape& shape, QuadMesh& mesh) {
    settle(shape, nearby_parts(shape, mesh), mesh);
}

}  // namespace core
