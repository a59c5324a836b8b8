#include "core/mesh/normalise.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/mesh/mesh_welder.hpp"

namespace core {
namespace {

struct Box {
    Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
    Vec3 high = low * -1.0;

    void include(Vec3 p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    [[nodiscard]] double longest_side() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};

}  // namespace

Result<TriangleMesh> normalised_mesh(TriangleMesh mesh) {
    if (mesh.empty()) return unexpected(ErrorCode::EmptyMesh, "the mesh has no faces; choose a model with a surface");
    Box box;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t i : triangle) {
            if (i >= mesh.vertices.size() || !is_usable(mesh.vertices[i])) {
                return unexpected(ErrorCode::BadMesh,
                                  "a face uses a vertex that is missing or not finite; export again");
            }
            box.include(mesh.vertices[i]);
        }
    }
    const double side = box.longest_side();
    if (!(side >= std::numeric_limits<double>::min())) {
        return unexpected(ErrorCode::BadMesh, "all faces lie in one point; choose a model with some size");
    }
    // The longest side becomes 1 first, so that no square under- or overflows whatever the unit.
    const Vec3 centre = box.low + (box.high - box.low) * 0.5;
    for (Vec3& p : mesh.vertices) p = {(p.x - centre.x) / side, (p.y - centre.y) / side, (p.z - centre.z) / side};
    double farthest = 0.0;
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t i : triangle) farthest = std::max(farthest, length(mesh.vertices[i]));
    }
    for (Vec3& p : mesh.vertices) p = p * (1.0 / farthest);
    return mesh;
}

}  // namespace core
