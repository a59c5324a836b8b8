#include "core/mesh/distance_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include "core/mesh/nearest_on_triangle.hpp"

namespace core {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

struct HalfEdge {
    std::uint32_t low, high;
    bool forward;
    std::uint32_t triangle, corner;  // the edge from `corner` to the next
};

std::vector<HalfEdge> sorted_edges(const TriangleMesh& mesh) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), a < b, t, k});
        }
    std::sort(edges.begin(), edges.end(), [](const HalfEdge& x, const HalfEdge& y) {
        return std::tie(x.low, x.high, x.forward, x.triangle) < std::tie(y.low, y.high, y.forward, y.triangle);
    });
    return edges;
}

/// Normals of faces, edges and vertices by which a point is told to be inside or outside, whichever of these is nearest
/// (J. A. Bærentzen, H. Aanæs, Signed distance computation using the angle weighted pseudonormal, 2005).
struct Pseudonormals {
    std::vector<Vec3> face, vertex;
    std::vector<std::array<Vec3, 3>> edge;  // of each triangle, from its corner k on
    std::vector<std::array<bool, 3>> border_edge;
    std::vector<bool> border_vertex;

    explicit Pseudonormals(const TriangleMesh& mesh)
        : vertex(mesh.vertices.size()),
          edge(mesh.triangles.size()),
          border_edge(mesh.triangles.size()),
          border_vertex(mesh.vertices.size(), false) {
        for (const Triangle& t : mesh.triangles) {
            const std::array<Vec3, 3> p{mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
            const Vec3 n = normalised(cross(p[1] - p[0], p[2] - p[0]));
            face.push_back(n);
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 u = normalised(p[(k + 1) % 3] - p[k]), v = normalised(p[(k + 2) % 3] - p[k]);
                vertex[t[k]] = vertex[t[k]] + n * std::acos(std::clamp(dot(u, v), -1.0, 1.0));
            }
        }
        const std::vector<HalfEdge> edges = sorted_edges(mesh);
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t end = i;
            Vec3 sum;
            for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end)
                sum = sum + face[edges[end].triangle];
            for (std::size_t k = i; k < end; ++k) {
                edge[edges[k].triangle][edges[k].corner] = sum;
                border_edge[edges[k].triangle][edges[k].corner] = end - i == 1;
            }
            if (end - i == 1) border_vertex[edges[i].low] = border_vertex[edges[i].high] = true;
            i = end;
        }
    }
};

/// The solution of |grad u| = 1 at a node from the smaller neighbour along each axis (Zhao 2005).
double eikonal(double a, double b, double c, double h) {
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    double u = a + h;
    if (u <= b) return u;
    u = 0.5 * (a + b + std::sqrt(2.0 * h * h - (a - b) * (a - b)));
    if (u <= c) return u;
    const double sum = a + b + c;
    return (sum + std::sqrt(std::max(0.0, sum * sum - 3.0 * (a * a + b * b + c * c - h * h)))) / 3.0;
}

std::pair<Vec3, Vec3> bounds(const std::vector<Vec3>& points) {
    Vec3 low = points.front(), high = points.front();
    for (const Vec3& p : points) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return {low, high};
}

constexpr float kUnknown = std::numeric_limits<float>::max();

}  // namespace

DistanceGrid::DistanceGrid(Vec3 low, Vec3 high, double cell) : low_(low), cell_(cell) {
    const auto count = [cell](double from, double to) { return static_cast<int>(std::ceil((to - from) / cell)) + 2; };
    nx_ = count(low.x, high.x), ny_ = count(low.y, high.y), nz_ = count(low.z, high.z);
    value_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_),
                  kUnknown);
}

Result<DistanceGrid> DistanceGrid::of_body(const TriangleMesh& mesh, const DistanceGridOptions& options) {
    if (mesh.empty() || !is_closed(mesh))
        return unexpected(ErrorCode::BadMesh, "The body is not closed: close its holes, or give another one.");
    const auto [low, high] = bounds(mesh.vertices);
    const Vec3 margin{options.margin, options.margin, options.margin};
    DistanceGrid grid(low - margin, high + margin, options.cell);
    grid.measure_band(mesh, 1.5 * options.cell, false);
    grid.sweep();
    return grid;
}

DistanceGrid DistanceGrid::of_sheet(const QuadMesh& mesh, const DistanceGridOptions& options) {
    const auto [low, high] = mesh.vertices.empty() ? std::pair<Vec3, Vec3>{} : bounds(mesh.vertices);
    const Vec3 margin{options.reach, options.reach, options.reach};
    DistanceGrid grid(low - margin, high + margin, options.cell);
    grid.sheet_ = true;
    grid.measure_band(triangles_of(mesh), options.reach, true);
    return grid;
}

void DistanceGrid::measure_band(const TriangleMesh& mesh, double band, bool sheet) {
    const Pseudonormals normals(mesh);
    std::vector<std::uint32_t> nearest(value_.size(), 0);
    const auto node = [&](double at, double from, int count) {
        return std::clamp(static_cast<int>(std::floor((at - from) / cell_)), 0, count - 1);
    };
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& tri = mesh.triangles[t];
        const Vec3 a = mesh.vertices[tri[0]], b = mesh.vertices[tri[1]], c = mesh.vertices[tri[2]];
        const auto [low, high] = bounds({a, b, c});
        for (int z = node(low.z - band, low_.z, nz_); z <= node(high.z + band, low_.z, nz_); ++z)
            for (int y = node(low.y - band, low_.y, ny_); y <= node(high.y + band, low_.y, ny_); ++y)
                for (int x = node(low.x - band, low_.x, nx_); x <= node(high.x + band, low_.x, nx_); ++x) {
                    const Vec3 p = place(x, y, z);
                    const double plane = dot(p - a, normals.face[t]);
                    float& value = value_[index(x, y, z)];
                    if (std::abs(plane) > std::min(band, static_cast<double>(value))) continue;
                    const auto d = static_cast<float>(length(nearest_on_triangle(p, a, b, c).point - p));
                    if (d > static_cast<float>(band) || d >= value) continue;
                    value = d;
                    nearest[index(x, y, z)] = t;
                }
    }
    for (int z = 0; z < nz_; ++z)
        for (int y = 0; y < ny_; ++y)
            for (int x = 0; x < nx_; ++x) {
                float& value = value_[index(x, y, z)];
                if (value == kUnknown) continue;
                const std::uint32_t t = nearest[index(x, y, z)];
                const Triangle& tri = mesh.triangles[t];
                const Vec3 p = place(x, y, z);
                const NearestOnTriangle at =
                    nearest_on_triangle(p, mesh.vertices[tri[0]], mesh.vertices[tri[1]], mesh.vertices[tri[2]]);
                const auto k = static_cast<std::size_t>(at.feature % 3);
                const Vec3 n = at.feature == 6   ? normals.face[t]
                               : at.feature >= 3 ? normals.edge[t][k]
                                                 : normals.vertex[tri[k]];
                const bool border = sheet && at.feature != 6 &&
                                    (at.feature >= 3 ? normals.border_edge[t][k] : normals.border_vertex[tri[k]]);
                if (!border && dot(p - at.point, n) < 0.0) value = -value;
            }
}

void DistanceGrid::sweep() {
    std::vector<bool> fixed(value_.size());
    for (std::size_t i = 0; i < value_.size(); ++i) fixed[i] = value_[i] != kUnknown;
    const std::array<std::ptrdiff_t, 3> strides{1, nx_, static_cast<std::ptrdiff_t>(nx_) * ny_};
    const auto update = [&](int x, int y, int z) {
        const std::size_t i = index(x, y, z);
        if (fixed[i]) return;
        const std::array<int, 3> at{x, y, z}, count{nx_, ny_, nz_};
        std::array<double, 3> near{};
        double least = static_cast<double>(kUnknown);
        bool inside = false;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            near[axis] = static_cast<double>(kUnknown);
            for (const int step : {-1, 1}) {
                if (at[axis] + step < 0 || at[axis] + step >= count[axis]) continue;
                const auto value = static_cast<double>(value_[i + static_cast<std::size_t>(step * strides[axis])]);
                near[axis] = std::min(near[axis], std::abs(value));
                if (std::abs(value) < least) least = std::abs(value), inside = value < 0.0;
            }
        }
        if (least >= static_cast<double>(kUnknown)) return;
        const double u = eikonal(near[0], near[1], near[2], cell_);
        if (u < std::abs(static_cast<double>(value_[i]))) value_[i] = static_cast<float>(inside ? -u : u);
    };
    for (int pass = 0; pass < 8; ++pass)
        for (int k = 0; k < nz_; ++k)
            for (int j = 0; j < ny_; ++j)
                for (int i = 0; i < nx_; ++i)
                    update((pass & 1) != 0 ? nx_ - 1 - i : i, (pass & 2) != 0 ? ny_ - 1 - j : j,
                           (pass & 4) != 0 ? nz_ - 1 - k : k);
}

double DistanceGrid::distance(Vec3 p) const {
    const Vec3 q = (p - low_) * (1.0 / cell_);
    const auto clamped = [](double v, int n) { return std::clamp(v, 0.0, n - 1.0 - 1e-9); };
    const Vec3 in{clamped(q.x, nx_), clamped(q.y, ny_), clamped(q.z, nz_)};
    const double beyond = length(q - in) * cell_;
    if (sheet_ && beyond > 0.0) return kFar;
    const int x = static_cast<int>(in.x), y = static_cast<int>(in.y), z = static_cast<int>(in.z);
    const double u = in.x - x, v = in.y - y, w = in.z - z;
    double sum = 0.0;
    for (int c = 0; c < 8; ++c) {
        const float corner = value_[index(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))];
        if (corner == kUnknown) return kFar;
        sum += static_cast<double>(corner) * ((c & 1) != 0 ? u : 1.0 - u) * ((c >> 1 & 1) != 0 ? v : 1.0 - v) *
               ((c >> 2) != 0 ? w : 1.0 - w);
    }
    return sum + beyond;
}

FieldSample DistanceGrid::sample(Vec3 p) const {
    const double d = distance(p);
    if (d >= kFar) return {kFar, {}};
    const double h = 0.5 * cell_;
    const auto slope = [&](Vec3 step) {
        const double after = distance(p + step), before = distance(p - step);
        return after < kFar && before < kFar ? after - before : 0.0;
    };
    return {d, normalised({slope({h, 0, 0}), slope({0, h, 0}), slope({0, 0, h})})};
}

FieldSample DistanceGrid::quick_sample(Vec3 p) const {
    const Vec3 q = (p - low_) * (1.0 / cell_);
    const bool inside = q.x >= 0.0 && q.y >= 0.0 && q.z >= 0.0 && q.x < nx_ - 1.0 && q.y < ny_ - 1.0 && q.z < nz_ - 1.0;
    if (!inside) return sample(p);
    const int x = static_cast<int>(q.x), y = static_cast<int>(q.y), z = static_cast<int>(q.z);
    const double u = q.x - x, v = q.y - y, w = q.z - z;
    std::array<double, 8> c{};
    for (int k = 0; k < 8; ++k) {
        const float corner = value_[index(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))];
        if (corner == kUnknown) return {kFar, {}};
        c[static_cast<std::size_t>(k)] = static_cast<double>(corner);
    }
    const auto mix = [](double a, double b, double t) { return a + (b - a) * t; };
    const double along_00 = mix(c[0], c[1], u), along_10 = mix(c[2], c[3], u), along_01 = mix(c[4], c[5], u),
                 along_11 = mix(c[6], c[7], u);
    const double front = mix(along_00, along_10, v), back = mix(along_01, along_11, v);
    const Vec3 slope{mix(mix(c[1] - c[0], c[3] - c[2], v), mix(c[5] - c[4], c[7] - c[6], v), w),
                     mix(along_10 - along_00, along_11 - along_01, w), back - front};
    return {mix(front, back, w), normalised(slope)};
}

TriangleMesh triangles_of(const QuadMesh& mesh) {
    TriangleMesh out;
    out.vertices = mesh.vertices;
    for (const Quad& q : mesh.quads) {
        out.triangles.push_back({q[0], q[1], q[2]});
        out.triangles.push_back({q[0], q[2], q[3]});
    }
    return out;
}

bool is_closed(const TriangleMesh& mesh) {
    for (const Triangle& t : mesh.triangles)
        if (std::max({t[0], t[1], t[2]}) >= mesh.vertices.size() || t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
            return false;
    const std::vector<HalfEdge> edges = sorted_edges(mesh);
    if (edges.empty() || edges.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < edges.size(); i += 2) {
        const HalfEdge &x = edges[i], &y = edges[i + 1];
        if (x.low != y.low || x.high != y.high || x.forward == y.forward) return false;
        if (i + 2 < edges.size() && edges[i + 2].low == x.low && edges[i + 2].high == x.high) return false;
    }
    return true;
}

}  // namespace core
