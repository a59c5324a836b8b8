#include "core/starter/kit/assembly.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace core::starter {
namespace {

TriangleMesh flipped(TriangleMesh mesh) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

struct Turn {
    double c, s;
    explicit Turn(double degrees)
        : c(std::cos(degrees * std::numbers::pi / 180.0)), s(std::sin(degrees * std::numbers::pi / 180.0)) {}
};

}  // namespace

void join(TriangleMesh& into, const TriangleMesh& part) {
    const auto offset = static_cast<std::uint32_t>(into.vertices.size());
    into.vertices.insert(into.vertices.end(), part.vertices.begin(), part.vertices.end());
    into.colours.insert(into.colours.end(), part.colours.begin(), part.colours.end());
    for (const auto& t : part.triangles) into.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

TriangleMesh bent(TriangleMesh mesh, const std::function<Vec3(Vec3)>& place) {
    for (Vec3& v : mesh.vertices) v = place(v);
    return mesh;
}

TriangleMesh moved(TriangleMesh mesh, Vec3 by) {
    for (Vec3& v : mesh.vertices) v = v + by;
    return mesh;
}

TriangleMesh scaled(TriangleMesh mesh, Vec3 f) {
    for (Vec3& v : mesh.vertices) v = {v.x * f.x, v.y * f.y, v.z * f.z};
    return mesh;
}

TriangleMesh turned_x(TriangleMesh mesh, double degrees) {
    const Turn r(degrees);
    for (Vec3& v : mesh.vertices) v = {v.x, r.c * v.y - r.s * v.z, r.s * v.y + r.c * v.z};
    return mesh;
}

TriangleMesh turned_y(TriangleMesh mesh, double degrees) {
    const Turn r(degrees);
    for (Vec3& v : mesh.vertices) v = {r.c * v.x + r.s * v.z, v.y, -r.s * v.x + r.c * v.z};
    return mesh;
}

TriangleMesh turned_z(TriangleMesh mesh, double degrees) {
    const Turn r(degrees);
    for (Vec3& v : mesh.vertices) v = {r.c * v.x - r.s * v.y, r.s * v.x + r.c * v.y, v.z};
    return mesh;
}

TriangleMesh mirrored_z(TriangleMesh mesh) {
    for (Vec3& v : mesh.vertices) v.z = -v.z;
    return flipped(std::move(mesh));
}

TriangleMesh mirrored_x(TriangleMesh mesh) {
    for (Vec3& v : mesh.vertices) v.x = -v.x;
    return flipped(std::move(mesh));
}

TriangleMesh facing_front(TriangleMesh mesh) {
    for (Vec3& v : mesh.vertices) v = {-v.z, v.y, v.x};
    return mesh;
}

TriangleMesh narrow(TriangleMesh side_view, double share) {
    return scaled(facing_front(std::move(side_view)), {share, 1.0, 1.0});
}

TriangleMesh painted(TriangleMesh mesh, const std::function<Rgb(Vec3, Rgb)>& colour) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) mesh.colours[i] = colour(mesh.vertices[i], mesh.colours[i]);
    return mesh;
}

}  // namespace core::starter
