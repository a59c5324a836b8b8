#include "core/mesh/simplify.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/mesh/mesh_welder.hpp"

namespace core {
namespace {

constexpr int kFinestGrid = 1024;  // cells along the longest side

/// The sum of squared distances to planes, about a point: minimal where sum(n n^T) x = sum(n n^T p).
struct Planes {
    std::array<double, 6> a{};  // xx xy xz yy yz zz
    Vec3 b;
    Vec3 place_sum;
    double weight = 0.0;

    void add(Vec3 normal, Vec3 p, double w) {
        const double d = dot(normal, p);
        a[0] += normal.x * normal.x, a[1] += normal.x * normal.y, a[2] += normal.x * normal.z;
        a[3] += normal.y * normal.y, a[4] += normal.y * normal.z, a[5] += normal.z * normal.z;
        b = b + normal * d;
        place_sum = place_sum + p * w;
        weight += w;
    }

    /// The place nearest to all planes, drawn softly to the mean of the corners so that flat and round cells are
    /// settled too; the mean itself when the solution leaves the cell's neighbourhood.
    [[nodiscard]] Vec3 place(double cell) const {
        const Vec3 mean = place_sum * (1.0 / weight);
        const double soft = 1e-3 * (a[0] + a[3] + a[5]);
        if (!(soft > 0.0)) return mean;
        const Vec3 c0{a[0] + soft, a[1], a[2]}, c1{a[1], a[3] + soft, a[4]}, c2{a[2], a[4], a[5] + soft};
        const Vec3 rhs = b + mean * soft;
        const double det = dot(c0, cross(c1, c2));
        if (!(std::abs(det) > std::numeric_limits<double>::min())) return mean;
        const Vec3 x = Vec3{dot(rhs, cross(c1, c2)), dot(c0, cross(rhs, c2)), dot(c0, cross(c1, rhs))} * (1.0 / det);
        return length(x - mean) <= cell ? x : mean;
    }
};

using Cells = std::vector<std::uint32_t>;  // per vertex, numbered in the order of first use
using Faces = std::vector<std::uint32_t>;  // numbers of the faces that stay

class Grid {
  public:
    explicit Grid(const TriangleMesh& mesh) : mesh_(mesh), low_(mesh.vertices[mesh.triangles[0][0]]) {
        Vec3 high = low_;
        for (const auto& triangle : mesh.triangles) {
            for (const std::uint32_t i : triangle) {
                const Vec3 p = mesh.vertices[i];
                low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
                high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
            }
        }
        side_ = std::max({high.x - low_.x, high.y - low_.y, high.z - low_.z});
    }

    [[nodiscard]] double cell_size(int resolution) const { return side_ / resolution; }

    /// Per vertex its cell; vertices that no face uses share one.
    [[nodiscard]] Cells cells(int resolution) const {
        const double scale = side_ > 0.0 ? resolution / side_ : 0.0;
        const auto step = [&](double v) {
            return static_cast<std::uint64_t>(std::clamp(v * scale, 0.0, static_cast<double>(resolution)));
        };
        std::unordered_map<std::uint64_t, std::uint32_t> numbers;
        Cells cells(mesh_.vertices.size(), 0);
        for (const auto& triangle : mesh_.triangles) {
            for (const std::uint32_t i : triangle) {
                const Vec3 d = mesh_.vertices[i] - low_;
                const std::uint64_t key = step(d.x) << 42 | step(d.y) << 21 | step(d.z);
                cells[i] = numbers.try_emplace(key, static_cast<std::uint32_t>(numbers.size())).first->second;
            }
        }
        return cells;
    }

    /// The faces with corners in three cells, one for each three; nothing once there are more than `most`.
    [[nodiscard]] std::optional<Faces> faces(const Cells& cells, std::size_t most) const {
        std::unordered_set<std::uint64_t> seen;
        Faces kept;
        for (std::uint32_t f = 0; f < mesh_.triangles.size(); ++f) {
            std::array<std::uint64_t, 3> c{};
            for (std::size_t k = 0; k < 3; ++k) c[k] = cells[mesh_.triangles[f][k]];
            std::sort(c.begin(), c.end());
            if (c[0] == c[1] || c[1] == c[2]) continue;
            // The cells of a kept face are few, so that a mixed key meets another by chance next to never.
            const std::uint64_t key = ((c[0] * 0x9e3779b97f4a7c15ULL) ^ c[1]) * 0xbf58476d1ce4e5b9ULL + c[2];
            if (!seen.insert(key).second) continue;
            if (kept.size() == most) return std::nullopt;
            kept.push_back(f);
        }
        return kept;
    }

    [[nodiscard]] std::vector<Vec3> places(const Cells& cells, int resolution) const {
        std::vector<Planes> planes(1 + *std::max_element(cells.begin(), cells.end()));
        const double cell = cell_size(resolution);
        for (const auto& triangle : mesh_.triangles) {
            std::array<Vec3, 3> p;
            for (std::size_t k = 0; k < 3; ++k) p[k] = (mesh_.vertices[triangle[k]] - low_) * (1.0 / side_);
            const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);  // its length is the weight
            const double weight = length(normal) + 1e-12;
            for (std::size_t k = 0; k < 3; ++k) planes[cells[triangle[k]]].add(normal, p[k], weight);
        }
        std::vector<Vec3> places;
        places.reserve(planes.size());
        for (const Planes& of_cell : planes) {
            places.push_back(of_cell.weight > 0.0 ? of_cell.place(cell / side_) * side_ + low_ : low_);
        }
        return places;
    }

  private:
    const TriangleMesh& mesh_;
    Vec3 low_;
    double side_ = 0.0;
};

bool is_sound(const TriangleMesh& mesh) {
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t i : triangle) {
            if (i >= mesh.vertices.size() || !is_usable(mesh.vertices[i])) return false;
        }
    }
    return mesh.colours.empty() || mesh.colours.size() == mesh.vertices.size();
}

/// The finest grid that leaves at most `most` faces, by halving; a coarser grid leaves fewer but for rare exceptions.
int finest_resolution(const Grid& grid, std::size_t most) {
    int coarse = 1, fine = kFinestGrid + 1;
    while (fine - coarse > 1) {
        const int middle = (coarse + fine) / 2;
        (grid.faces(grid.cells(middle), most) ? coarse : fine) = middle;
    }
    return coarse;
}

}  // namespace

Result<TriangleMesh> simplified_mesh(const TriangleMesh& mesh, std::size_t most_triangles) {
    if (most_triangles < 4) {
        return unexpected(ErrorCode::BadArgument,
                          "a mesh cannot be simplified to fewer than 4 triangles; ask for more");
    }
    if (!is_sound(mesh)) {
        return unexpected(ErrorCode::BadMesh, "a face uses a vertex that is missing or not finite; export it again");
    }
    if (mesh.triangles.size() <= most_triangles) return mesh;
    const Grid grid(mesh);
    const int resolution = finest_resolution(grid, most_triangles);
    const Cells cells = grid.cells(resolution);
    const std::optional<Faces> faces = grid.faces(cells, most_triangles);
    MeshWelder welder;
    if (faces && !faces->empty()) {
        const std::vector<Vec3> places = grid.places(cells, resolution);
        const auto corner = [&](std::uint32_t i) {
            return MeshWelder::Corner{places[cells[i]], mesh.colours.empty() ? Rgb{} : mesh.colours[i]};
        };
        for (const std::uint32_t f : *faces) {
            const auto& [a, b, c] = mesh.triangles[f];
            welder.add(corner(a), corner(b), corner(c));
        }
    }
    if (welder.triangle_count() == 0) {
        return unexpected(ErrorCode::EmptyMesh,
                          "nothing of the mesh is left when it is simplified; allow more triangles");
    }
    return std::move(welder).finish();
}

}  // namespace core
