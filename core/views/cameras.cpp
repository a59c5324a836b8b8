#include "core/views/cameras.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace core {
namespace {

using Quad = std::array<std::size_t, 4>;

struct QuadMesh {
    std::vector<Vec3> vertices;
    std::vector<Quad> faces;
};

QuadMesh cube() {
    QuadMesh mesh;
    for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
            for (const double z : {-1.0, 1.0}) mesh.vertices.push_back({x, y, z});
        }
    }
    mesh.faces = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
    return mesh;
}

Vec3 centroid(const QuadMesh& mesh, const Quad& face) {
    Vec3 sum;
    for (const std::size_t v : face) sum = sum + mesh.vertices[v];
    return sum * 0.25;
}

/// What an edge of a closed mesh gathers in a Catmull-Clark step.
struct Edge {
    Vec3 sum_of_face_points;
    std::size_t new_vertex = 0;
};
using Edges = std::map<std::pair<std::size_t, std::size_t>, Edge>;

std::pair<std::size_t, std::size_t> edge_key(std::size_t a, std::size_t b) {
    return a < b ? std::pair{a, b} : std::pair{b, a};
}

/// Edges of the cube by the axis they run along, then by their first vertex: the order of the new vertices.
std::vector<std::pair<std::size_t, std::size_t>> ordered_keys(const QuadMesh& mesh, const Edges& edges) {
    std::vector<std::pair<std::size_t, std::size_t>> keys;
    const auto along = [&mesh](const auto& key) {
        const Vec3 d = mesh.vertices[key.second] - mesh.vertices[key.first];
        return d.x != 0.0 ? 0 : d.y != 0.0 ? 1 : 2;
    };
    for (int axis = 0; axis < 3; ++axis) {
        for (const auto& [key, edge] : edges) {
            if (along(key) == axis) keys.push_back(key);
        }
    }
    return keys;
}

/// One Catmull-Clark step on a closed mesh in which every vertex has three faces (E. Catmull, J. Clark, 1978).
/// New vertices: the moved old ones, the face points, the edge points. New faces: one a corner of an old face.
QuadMesh subdivided(const QuadMesh& mesh) {
    constexpr double kValence = 3.0;
    QuadMesh fine;
    const std::size_t old_count = mesh.vertices.size();
    std::vector<Vec3> face_sum(old_count), edge_sum(old_count);
    Edges edges;
    fine.vertices.resize(old_count);
    for (const Quad& face : mesh.faces) {
        const Vec3 face_point = centroid(mesh, face);
        fine.vertices.push_back(face_point);
        for (std::size_t k = 0; k < 4; ++k) {
            face_sum[face[k]] = face_sum[face[k]] + face_point;
            Edge& edge = edges[edge_key(face[k], face[(k + 1) % 4])];
            edge.sum_of_face_points = edge.sum_of_face_points + face_point;
        }
    }
    for (const auto& key : ordered_keys(mesh, edges)) {
        const Vec3 ends = mesh.vertices[key.first] + mesh.vertices[key.second];
        for (const std::size_t end : {key.first, key.second}) edge_sum[end] = edge_sum[end] + ends * 0.5;
        edges[key].new_vertex = fine.vertices.size();
        fine.vertices.push_back((ends + edges[key].sum_of_face_points) * 0.25);
    }
    for (std::size_t v = 0; v < old_count; ++v) {
        const Vec3 faces_mean = face_sum[v] * (1.0 / kValence), edges_mean = edge_sum[v] * (1.0 / kValence);
        fine.vertices[v] = (faces_mean + edges_mean * 2.0 + mesh.vertices[v] * (kValence - 3.0)) * (1.0 / kValence);
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
        const Quad& face = mesh.faces[f];
        for (std::size_t k = 0; k < 4; ++k) {
            fine.faces.push_back({face[k], edges[edge_key(face[k], face[(k + 1) % 4])].new_vertex, old_count + f,
                                  edges[edge_key(face[(k + 3) % 4], face[k])].new_vertex});
        }
    }
    return fine;
}

std::array<Camera, kCameraCount> make_cameras() {
    const QuadMesh fine = subdivided(cube());
    std::array<Camera, kCameraCount> made;
    std::size_t next = 0;
    for (const Vec3& v : fine.vertices) made[next++] = camera_from(v);
    for (const Quad& face : fine.faces) made[next++] = camera_from(centroid(fine, face));
    return made;
}

std::array<int, kCameraCount> make_opposites() {
    std::array<int, kCameraCount> opposite{};
    for (int a = 0; a < kCameraCount; ++a) {
        for (int b = 0; b < kCameraCount; ++b) {
            const Vec3 sum =
                cameras()[static_cast<std::size_t>(a)].direction + cameras()[static_cast<std::size_t>(b)].direction;
            if (length(sum) < 1e-9) opposite[static_cast<std::size_t>(a)] = b;
        }
    }
    return opposite;
}

bool represents(const Camera& camera) {
    constexpr double kLevel = 1e-9;
    const Vec3 d = camera.direction;
    if (std::abs(d.y) > kLevel) return d.y > 0.0;
    if (std::abs(d.z) > kLevel) return d.z > 0.0;
    return d.x > 0.0;
}

std::array<int, kCameraPairs> make_representatives() {
    std::array<int, kCameraPairs> chosen{};
    std::size_t next = 0;
    for (int c = 0; c < kCameraCount; ++c) {
        if (represents(cameras()[static_cast<std::size_t>(c)])) chosen.at(next++) = c;
    }
    return chosen;
}

}  // namespace

Camera camera_from(Vec3 direction) {
    const Vec3 d = normalised(direction);
    const Vec3 seen_y = Vec3{0.0, 1.0, 0.0} - d * d.y;
    constexpr double kPole = 1e-6;
    if (length(seen_y) < kPole) return {d, normalised(Vec3{0.0, 0.0, -1.0} + d * d.z)};
    return {d, normalised(seen_y)};
}

const std::array<Camera, kCameraCount>& cameras() {
    static const std::array<Camera, kCameraCount> all = make_cameras();
    return all;
}

int opposite_camera(int camera) {
    static const std::array<int, kCameraCount> opposites = make_opposites();
    return opposites.at(static_cast<std::size_t>(camera));
}

const std::array<int, kCameraPairs>& representative_cameras() {
    static const std::array<int, kCameraPairs> chosen = make_representatives();
    return chosen;
}

int representative_of(int camera) {
    return represents(cameras().at(static_cast<std::size_t>(camera))) ? camera : opposite_camera(camera);
}

}  // namespace core
