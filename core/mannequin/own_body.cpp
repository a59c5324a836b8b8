#include "core/mannequin/own_body.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/mesh/distance_grid.hpp"
#include "core/mesh/mesh_welder.hpp"
#include "core/mesh/plane_section.hpp"

namespace core {
namespace {

QuadMesh as_quads(const TriangleMesh& mesh) {
    QuadMesh quads{mesh.vertices, {}};
    for (const auto& t : mesh.triangles) quads.quads.push_back({t[0], t[1], t[2], t[2]});
    return quads;
}

struct Box {
    Vec3 low, high;
};
Box box_of(const std::vector<Vec3>& points) {
    Box box{points.front(), points.front()};
    for (const Vec3& p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    return box;
}

TriangleMesh without_colours(const TriangleMesh& mesh) {
    MeshWelder welder;
    for (const auto& t : mesh.triangles) welder.add(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
    return std::move(welder).finish();
}

double volume(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles)
        sum += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]]));
    return sum;
}

/// Level cut at a share of the height: for each piece its middle and the length of a tape around it. Pieces much
/// smaller than the largest, as eyes in a head, are left out.
struct CutPiece {
    Point middle;
    double girth = 0.0;
};
std::vector<CutPiece> level_cut(const QuadMesh& mesh, const Box& box, double share) {
    const double y = box.low.y + share * (box.high.y - box.low.y);
    std::vector<CutPiece> pieces;
    for (std::vector<Point>& points : plane_section(mesh, {{0, y, 0}, {1, 0, 0}, {0, 0, -1}})) {
        CutPiece piece;
        for (const Point p : points) piece.middle = piece.middle + p * (1.0 / static_cast<double>(points.size()));
        piece.girth = hull_length(std::move(points));
        pieces.push_back(piece);
    }
    double largest = 0.0;
    for (const CutPiece& piece : pieces) largest = std::max(largest, piece.girth);
    std::erase_if(pieces, [&](const CutPiece& piece) { return piece.girth < 0.4 * largest; });
    return pieces;
}

/// From one leg's middle to the other's, if the mesh stands on two legs and has a head.
std::optional<Point> legs_apart(const QuadMesh& mesh) {
    const Box box = box_of(mesh.vertices);
    const std::vector<CutPiece> legs = level_cut(mesh, box, 0.13), head = level_cut(mesh, box, 0.94);
    if (legs.size() != 2 || head.size() != 1) return std::nullopt;
    const double ratio = legs[0].girth / std::max(legs[1].girth, 1e-9);
    const double height = box.high.y - box.low.y;
    if (ratio < 0.7 || ratio > 1.43 || legs[0].girth < 0.05 * height || legs[0].girth > 0.6 * height)
        return std::nullopt;
    return legs[1].middle - legs[0].middle;
}

using Turn = std::array<Vec3, 3>;  // where x, y and z of the turned mesh are read from

Vec3 turned(Vec3 p, const Turn& turn) {
    return {dot(p, turn[0]), dot(p, turn[1]), dot(p, turn[2])};
}

/// +1 when the toes point to +z. The cut above the ankle says where the leg is.
double toes(const QuadMesh& mesh) {
    const Box box = box_of(mesh.vertices);
    const double height = box.high.y - box.low.y;
    double ankle = 0.0, low = 1e300, high = -1e300;
    const std::vector<CutPiece> legs = level_cut(mesh, box, 0.09);
    for (const CutPiece& leg : legs) ankle -= leg.middle.y / static_cast<double>(legs.size());
    for (const Vec3& v : mesh.vertices)
        if (v.y < box.low.y + 0.03 * height) low = std::min(low, v.z), high = std::max(high, v.z);
    return high - ankle >= ankle - low ? 1.0 : -1.0;
}

double to_centimetres(double height) {
    for (const double unit : {100.0, 1.0, 0.1, 2.54, 30.48})
        if (height * unit >= 120.0 && height * unit <= 215.0) return unit;
    return 170.0 / height;
}

}  // namespace

Result<TriangleMesh> stand_body(const TriangleMesh& mesh) {
    TriangleMesh body = without_colours(mesh);
    if (body.empty()) return unexpected(ErrorCode::EmptyMesh, "The body has no faces.");
    if (!is_closed(body))
        return unexpected(ErrorCode::BadMesh, "The body is not closed: close its holes, or give another one.");
    if (volume(body) < 0.0)
        for (auto& t : body.triangles) std::swap(t[1], t[2]);
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    for (const Turn& turn : {Turn{x, y, z}, Turn{x, z, y * -1.0}, Turn{y, x * 1.0, z * -1.0},
                             Turn{x, y * -1.0, z * -1.0}, Turn{x, z * -1.0, y}, Turn{y, x * -1.0, z}}) {
        QuadMesh upright = as_quads(body);
        for (Vec3& v : upright.vertices) v = turned(v, turn);
        const std::optional<Point> legs = legs_apart(upright);
        if (!legs) continue;
        // plane coordinates are (x, -z): turn about y so that the legs lie along x
        const double angle = std::atan2(legs->y, legs->x), c = std::cos(angle), s = std::sin(angle);
        for (Vec3& v : upright.vertices) v = {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
        const double front = toes(upright);
        for (Vec3& v : upright.vertices) v.x *= front, v.z *= front;
        const Box box = box_of(upright.vertices);
        const double unit = to_centimetres(box.high.y - box.low.y);
        const Vec3 foot{0.5 * (box.low.x + box.high.x), box.low.y, 0.5 * (box.low.z + box.high.z)};
        for (Vec3& v : upright.vertices) v = (v - foot) * unit;
        body.vertices = std::move(upright.vertices);
        return body;
    }
    return unexpected(ErrorCode::BadMesh,
                      "No side of the body shows two legs apart and a head: stand it upright, legs apart.");
}

}  // namespace core
