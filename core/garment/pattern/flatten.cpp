#include "core/garment/pattern/flatten.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace core {
namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Triplet = Eigen::Triplet<double>;
using Vector = Eigen::VectorXd;
using Solver = Eigen::SimplicialLDLT<Matrix, Eigen::Lower>;

constexpr double kTooThin = 1e-9;  // area of a triangle against its longest edge, squared

Unexpected bad(std::string what) {
    return unexpected(ErrorCode::BadMesh, std::move(what));
}

/// A corner triangle of a quad, laid in its own plane: the first corner at the origin, the second on the x axis.
struct CornerTriangle {
    std::array<std::uint32_t, 3> vertex{};
    std::array<Point, 3> flat{};
    std::array<double, 3> cotangent{};  ///< of the angle at each corner
    double area = 0.0;
    std::size_t quad = 0;
};

/// Four triangles for each quad, one at each corner, so that no diagonal is preferred; together they cover it twice.
Result<std::vector<CornerTriangle>> corner_triangles(const QuadMesh& mesh) {
    std::vector<CornerTriangle> out;
    out.reserve(4 * mesh.quads.size());
    for (std::size_t i = 0; i < mesh.quads.size(); ++i) {
        const Quad& q = mesh.quads[i];
        double quad_area = 0.0;
        for (std::size_t k = 0; k < 4; ++k) {
            CornerTriangle t;
            t.quad = i;
            t.vertex = {q[k], q[(k + 1) % 4], q[(k + 3) % 4]};
            const Vec3 o = mesh.vertices[t.vertex[0]], a = mesh.vertices[t.vertex[1]] - o,
                       b = mesh.vertices[t.vertex[2]] - o;
            const double along = length(a), size = std::max(along, length(b));
            const double twice = length(cross(a, b));
            quad_area += 0.25 * twice;
            if (!(size > 0.0) || twice < kTooThin * size * size) continue;  // its neighbours say enough
            const Vec3 x = a * (1.0 / along);
            t.flat = {Point{}, Point{along, 0.0}, Point{dot(b, x), twice / along}};
            t.area = 0.5 * twice;
            for (std::size_t c = 0; c < 3; ++c) {
                const Point u = t.flat[(c + 1) % 3] - t.flat[c], w = t.flat[(c + 2) % 3] - t.flat[c];
                t.cotangent[c] = dot(u, w) / twice;
            }
            out.push_back(t);
        }
        if (!(quad_area > 0.0)) return bad("The piece of cloth has a quad without area.");
    }
    return out;
}

/// Stretches of the linear map from a triangle laid in its plane to where its corners lie now.
std::array<double, 2> principal_stretches(const CornerTriangle& t, const std::vector<Point>& at) {
    const Point a = at[t.vertex[1]] - at[t.vertex[0]], b = at[t.vertex[2]] - at[t.vertex[0]];
    const Point x = a * (1.0 / t.flat[1].x);
    const Point y = (b - x * t.flat[2].x) * (1.0 / t.flat[2].y);
    const double sum = 0.5 * (dot(x, x) + dot(y, y)), turn = cross(x, y);
    const double root = std::sqrt(std::max(0.0, sum * sum - turn * turn));
    return {std::sqrt(sum + root), std::sqrt(std::max(0.0, sum - root)) * (turn < 0.0 ? -1.0 : 1.0)};
}

class Flattener {
  public:
    Flattener(const QuadMesh& mesh, std::vector<CornerTriangle> triangles, std::vector<std::uint32_t> border)
        : mesh_(mesh), triangles_(std::move(triangles)), border_(std::move(border)) {}

    Result<void> run(const FlattenOptions& options) {
        if (!start_conformal()) return bad("The piece of cloth cannot be laid flat.");
        make_rigid(options.rounds);
        for (int round = 0; round < options.length_rounds; ++round)
            if (!keep_lengths(options.border_weight)) break;
        for (const Point p : at_)
            if (!std::isfinite(p.x) || !std::isfinite(p.y)) return bad("The piece of cloth cannot be laid flat.");
        return {};
    }

    [[nodiscard]] std::vector<Point>& places() { return at_; }
    [[nodiscard]] const std::vector<CornerTriangle>& triangles() const { return triangles_; }

  private:
    [[nodiscard]] Eigen::Index count() const { return static_cast<Eigen::Index>(mesh_.vertices.size()); }

    /// Least squares conformal map with the two border vertices that are farthest apart held.
    bool start_conformal() {
        const auto [first, second] = far_pair();
        const Vec3 from = mesh_.vertices[first], to = mesh_.vertices[second];
        at_.assign(mesh_.vertices.size(), {});
        at_[second] = {length(to - from), 0.0};
        // unknown numbers: 2 a vertex; held ones have none
        std::vector<Eigen::Index> number(mesh_.vertices.size(), -1);
        Eigen::Index next = 0;
        for (std::size_t v = 0; v < number.size(); ++v)
            if (v != first && v != second) number[v] = next++;
        std::vector<Triplet> rows;
        Vector right = Vector::Zero(2 * static_cast<Eigen::Index>(triangles_.size()));
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            const CornerTriangle& t = triangles_[i];
            const auto row = 2 * static_cast<Eigen::Index>(i);
            const double scale = 1.0 / std::sqrt(2.0 * t.area);
            for (std::size_t c = 0; c < 3; ++c) {
                const Point w = (t.flat[(c + 2) % 3] - t.flat[(c + 1) % 3]) * scale;
                const std::uint32_t v = t.vertex[c];
                if (number[v] < 0) {
                    right[row] -= w.x * at_[v].x - w.y * at_[v].y;
                    right[row + 1] -= w.y * at_[v].x + w.x * at_[v].y;
                    continue;
                }
                const Eigen::Index column = 2 * number[v];
                rows.emplace_back(row, column, w.x);
                rows.emplace_back(row, column + 1, -w.y);
                rows.emplace_back(row + 1, column, w.y);
                rows.emplace_back(row + 1, column + 1, w.x);
            }
        }
        Matrix a(right.size(), 2 * next);
        a.setFromTriplets(rows.begin(), rows.end());
        const Matrix normal = a.transpose() * a;
        const Solver solver(normal);
        if (solver.info() != Eigen::Success) return false;
        const Vector x = solver.solve(a.transpose() * right);
        for (std::size_t v = 0; v < number.size(); ++v)
            if (number[v] >= 0) at_[v] = {x[2 * number[v]], x[2 * number[v] + 1]};
        rescale();
        return true;
    }

    /// The two border vertices that are far apart: farthest from the first, and farthest from that.
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> far_pair() const {
        const auto farthest = [&](std::uint32_t from) {
            return *std::max_element(border_.begin(), border_.end(), [&](std::uint32_t a, std::uint32_t b) {
                return length(mesh_.vertices[a] - mesh_.vertices[from]) <
                       length(mesh_.vertices[b] - mesh_.vertices[from]);
            });
        };
        const std::uint32_t first = farthest(border_.front());
        return {first, farthest(first)};
    }

    /// To the area in space.
    void rescale() {
        double flat = 0.0, space = 0.0;
        for (const CornerTriangle& t : triangles_) {
            flat += 0.5 * cross(at_[t.vertex[1]] - at_[t.vertex[0]], at_[t.vertex[2]] - at_[t.vertex[0]]);
            space += t.area;
        }
        if (!(flat > 0.0)) return;
        const double factor = std::sqrt(space / flat);
        for (Point& p : at_) p = p * factor;
    }

    /// Local step: the rotation nearest to each triangle's map. Global step: the places that fit the turned triangles
    /// best, by one matrix for all rounds.
    void make_rigid(int rounds) {
        std::vector<Triplet> entries;
        for (const CornerTriangle& t : triangles_)
            for (std::size_t c = 0; c < 3; ++c) {
                const auto i = static_cast<int>(t.vertex[(c + 1) % 3]), j = static_cast<int>(t.vertex[(c + 2) % 3]);
                entries.emplace_back(i, i, t.cotangent[c]);
                entries.emplace_back(j, j, t.cotangent[c]);
                entries.emplace_back(std::max(i, j), std::min(i, j), -t.cotangent[c]);
            }
        entries.emplace_back(0, 0, 1.0);  // holds the first vertex: the system has no place of its own
        Matrix laplacian(count(), count());
        laplacian.setFromTriplets(entries.begin(), entries.end());
        const Solver solver(laplacian);
        if (solver.info() != Eigen::Success) return;
        Eigen::MatrixX2d right(count(), 2), x(count(), 2);
        for (int round = 0; round < rounds; ++round) {
            right.setZero();
            right.row(0) << at_[0].x, at_[0].y;
            for (const CornerTriangle& t : triangles_) add_turned(t, right);
            x = solver.solve(right);
            double moved = 0.0, size = 0.0;
            for (std::size_t v = 0; v < at_.size(); ++v) {
                const Point to{x(static_cast<Eigen::Index>(v), 0), x(static_cast<Eigen::Index>(v), 1)};
                moved = std::max(moved, distance(at_[v], to));
                size = std::max(size, length(to - at_[0]));
                at_[v] = to;
            }
            if (moved < 1e-6 * size) break;
        }
    }

    void add_turned(const CornerTriangle& t, Eigen::MatrixX2d& right) const {
        double c = 0.0, s = 0.0;  // of the angle that turns the triangle in its plane to where it lies
        for (std::size_t k = 0; k < 3; ++k) {
            const Point was = t.flat[(k + 2) % 3] - t.flat[(k + 1) % 3];
            const Point is = at_[t.vertex[(k + 2) % 3]] - at_[t.vertex[(k + 1) % 3]];
            c += t.cotangent[k] * dot(was, is);
            s += t.cotangent[k] * cross(was, is);
        }
        const double size = std::hypot(c, s);
        if (size <= 0.0) c = 1.0, s = 0.0;
        if (size > 0.0) c /= size, s /= size;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point e = (t.flat[(k + 1) % 3] - t.flat[(k + 2) % 3]) * t.cotangent[k];
            const Point turned{c * e.x - s * e.y, s * e.x + c * e.y};
            const auto i = static_cast<Eigen::Index>(t.vertex[(k + 1) % 3]),
                       j = static_cast<Eigen::Index>(t.vertex[(k + 2) % 3]);
            right(i, 0) += turned.x, right(i, 1) += turned.y;
            right(j, 0) -= turned.x, right(j, 1) -= turned.y;
        }
    }

    struct Length {
        std::uint32_t a, b;
        double rest, weight;
    };

    void list_lengths(double border_weight) {
        std::vector<std::array<std::uint32_t, 3>> pairs;  // a, b, 0 for an edge, 1 for a diagonal
        for (const Quad& q : mesh_.quads) {
            for (std::size_t k = 0; k < 4; ++k)
                pairs.push_back({std::min(q[k], q[(k + 1) % 4]), std::max(q[k], q[(k + 1) % 4]), 0});
            pairs.push_back({q[0], q[2], 1});
            pairs.push_back({q[1], q[3], 1});
        }
        std::sort(pairs.begin(), pairs.end());
        for (std::size_t i = 0; i < pairs.size();) {
            std::size_t end = i + 1;
            while (end < pairs.size() && pairs[end] == pairs[i]) ++end;
            const auto [a, b, diagonal] = pairs[i];
            const bool border = diagonal == 0 && end - i == 1;
            lengths_.push_back(
                {a, b, std::max(length(mesh_.vertices[b] - mesh_.vertices[a]), 1e-9), border ? border_weight : 1.0});
            i = end;
        }
    }

    [[nodiscard]] double length_energy(const std::vector<Point>& at) const {
        double sum = 0.0;
        for (const Length& l : lengths_) {
            const double r = l.weight * (distance(at[l.a], at[l.b]) / l.rest - 1.0);
            sum += r * r;
        }
        return sum;
    }

    /// One Gauss-Newton step, damped until it lowers the energy; false when nothing more is to be gained.
    bool keep_lengths(double border_weight) {
        if (lengths_.empty()) list_lengths(border_weight);
        std::vector<Triplet> entries;
        entries.reserve(lengths_.size() * 10);
        Vector gradient = Vector::Zero(2 * count());
        for (const Length& l : lengths_) {
            const Point d = at_[l.b] - at_[l.a];
            const double now = std::max(length(d), 1e-12), w2 = l.weight * l.weight;
            const Point u = d * (1.0 / (now * l.rest));  // slope of the residual at b
            const double r = now / l.rest - 1.0;
            const auto i = static_cast<int>(2 * l.a), j = static_cast<int>(2 * l.b);
            gradient[i] -= w2 * r * u.x, gradient[i + 1] -= w2 * r * u.y;
            gradient[j] += w2 * r * u.x, gradient[j + 1] += w2 * r * u.y;
            const double xx = w2 * u.x * u.x, xy = w2 * u.x * u.y, yy = w2 * u.y * u.y;
            for (const int k : {i, j}) {
                entries.emplace_back(k, k, xx);
                entries.emplace_back(k + 1, k, xy);
                entries.emplace_back(k + 1, k + 1, yy);
            }
            const int low = std::min(i, j), high = std::max(i, j);
            entries.emplace_back(high, low, -xx);
            entries.emplace_back(high, low + 1, -xy);
            entries.emplace_back(high + 1, low, -xy);
            entries.emplace_back(high + 1, low + 1, -yy);
        }
        const double before = length_energy(at_);
        if (before < 1e-14 * static_cast<double>(lengths_.size())) return false;
        Matrix normal(2 * count(), 2 * count());
        normal.setFromTriplets(entries.begin(), entries.end());
        if (!analysed_) step_solver_.analyzePattern(normal), analysed_ = true;
        for (int attempt = 0; attempt < 6; ++attempt, damping_ *= 10.0) {
            Matrix damped = normal;
            for (Eigen::Index k = 0; k < damped.rows(); ++k) damped.coeffRef(k, k) *= 1.0 + damping_;
            step_solver_.factorize(damped);
            if (step_solver_.info() != Eigen::Success) continue;
            const Vector step = step_solver_.solve(gradient);
            std::vector<Point> next = at_;
            for (std::size_t v = 0; v < next.size(); ++v) {
                const auto k = 2 * static_cast<Eigen::Index>(v);
                next[v] = next[v] - Point{step[k], step[k + 1]};
            }
            const double after = length_energy(next);
            if (!(after < before)) continue;
            at_ = std::move(next);
            damping_ = std::max(damping_ * 0.2, 1e-8);
            return after < before * (1.0 - 1e-4);
        }
        return false;
    }

    const QuadMesh& mesh_;
    std::vector<CornerTriangle> triangles_;
    std::vector<std::uint32_t> border_;
    std::vector<Point> at_;
    std::vector<Length> lengths_;
    Solver step_solver_;
    bool analysed_ = false;
    double damping_ = 1e-4;
};

/// The direction in the plane in which height grows on the whole; where the piece lies level, that of its longest
/// extent.
Point up_direction(const QuadMesh& mesh, const std::vector<CornerTriangle>& triangles, const std::vector<Point>& at) {
    Point sum;
    double area = 0.0;
    for (const CornerTriangle& t : triangles) {
        const double ha = mesh.vertices[t.vertex[1]].y - mesh.vertices[t.vertex[0]].y,
                     hb = mesh.vertices[t.vertex[2]].y - mesh.vertices[t.vertex[0]].y;
        const Point a = at[t.vertex[1]] - at[t.vertex[0]], b = at[t.vertex[2]] - at[t.vertex[0]];
        const double twice = cross(a, b);
        if (std::abs(twice) < 1e-12) continue;
        const Point slope = Point{ha * b.y - hb * a.y, hb * a.x - ha * b.x} * (1.0 / twice);
        sum = sum + slope * t.area;
        area += t.area;
    }
    constexpr double kLevel = 0.2;
    if (length(sum) > kLevel * area) return sum * (1.0 / length(sum));
    Point middle;
    for (const Point p : at) middle = middle + p * (1.0 / static_cast<double>(at.size()));
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const Point p : at) {
        const Point d = p - middle;
        xx += d.x * d.x, xy += d.x * d.y, yy += d.y * d.y;
    }
    const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy);
    return {std::cos(angle), std::sin(angle)};
}

void turn_up(std::vector<Point>& at, Point up) {
    const Point right{up.y, -up.x};
    Point low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    for (Point& p : at) {
        p = {dot(p, right), dot(p, up)};
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    }
    for (Point& p : at) p = p - low;
}

}  // namespace

Result<std::vector<std::uint32_t>> disc_border(const QuadMesh& piece) {
    if (piece.quads.empty()) return bad("The piece of cloth has no quads.");
    struct Side {
        std::uint32_t low, high, from;
    };
    std::vector<Side> sides;
    std::vector<bool> used(piece.vertices.size(), false);
    for (const Quad& q : piece.quads)
        for (std::size_t k = 0; k < 4; ++k) {
            if (q[k] >= piece.vertices.size()) return bad("A quad of the piece names a vertex that does not exist.");
            used[q[k]] = true;
            const std::uint32_t a = q[k], b = q[(k + 1) % 4];
            sides.push_back({std::min(a, b), std::max(a, b), a});
        }
    if (std::find(used.begin(), used.end(), false) != used.end())
        return bad("The piece of cloth has a vertex that no quad uses.");
    std::sort(sides.begin(), sides.end(),
              [](const Side& x, const Side& y) { return std::pair(x.low, x.high) < std::pair(y.low, y.high); });
    constexpr std::uint32_t kNone = ~0U;
    std::vector<std::uint32_t> next(piece.vertices.size(), kNone);
    std::size_t edges = 0, open = 0;
    for (std::size_t i = 0; i < sides.size(); ++edges) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
        if (end - i > 2) return bad("The piece of cloth has an edge that more than two quads share.");
        if (end - i == 1) {
            const std::uint32_t from = sides[i].from, to = from == sides[i].low ? sides[i].high : sides[i].low;
            if (next[from] != kNone) return bad("The piece of cloth touches itself at a corner.");
            next[from] = to;
            ++open;
        }
        i = end;
    }
    const auto euler = static_cast<std::ptrdiff_t>(piece.vertices.size()) - static_cast<std::ptrdiff_t>(edges) +
                       static_cast<std::ptrdiff_t>(piece.quads.size());
    if (open == 0 || euler != 1) return bad("The piece of cloth is no single disc: it has a hole or several parts.");
    std::vector<std::uint32_t> border;
    const auto first = static_cast<std::uint32_t>(
        std::find_if(next.begin(), next.end(), [](std::uint32_t n) { return n != kNone; }) - next.begin());
    for (std::uint32_t at = first; border.empty() || at != first; at = next[at]) {
        if (at == kNone || border.size() > open) return bad("The border of the piece of cloth is torn.");
        border.push_back(at);
    }
    if (border.size() != open) return bad("The piece of cloth is no single disc: it has a hole or several parts.");
    return border;
}

namespace {

/// The strain that this much area has more of.
double exceeded_by(double area, std::vector<std::pair<double, double>> strain_and_area) {
    std::sort(strain_and_area.rbegin(), strain_and_area.rend());
    for (const auto& [strain, size] : strain_and_area) {
        area -= size;
        if (area <= 0.0) return strain;
    }
    return 0.0;
}

}  // namespace

Result<FlatPiece> flatten(const QuadMesh& piece, const FlattenOptions& options) {
    Result<std::vector<std::uint32_t>> border = disc_border(piece);
    if (!border) return unexpected(border.error());
    Result<std::vector<CornerTriangle>> triangles = corner_triangles(piece);
    if (!triangles) return unexpected(triangles.error());
    Flattener flattener(piece, std::move(*triangles), std::move(*border));
    if (const Result<void> done = flattener.run(options); !done) return unexpected(done.error());
    FlatPiece flat;
    flat.places = std::move(flattener.places());
    turn_up(flat.places, up_direction(piece, flattener.triangles(), flat.places));
    flat.strain.assign(piece.quads.size(), 0.0);
    double total = 0.0;
    std::vector<std::pair<double, double>> areas;  // strain, area
    for (const CornerTriangle& t : flattener.triangles()) {
        double strain = 0.0;
        for (const double stretch : principal_stretches(t, flat.places))
            strain = std::max(strain, std::abs(stretch - 1.0));
        flat.mean_strain += strain * t.area;
        areas.emplace_back(strain, t.area);
        total += t.area;
        flat.strain[t.quad] = std::max(flat.strain[t.quad], strain);
        flat.largest_strain = std::max(flat.largest_strain, strain);
    }
    if (total > 0.0) flat.mean_strain /= total;
    flat.high_strain = exceeded_by(0.01 * total, std::move(areas));
    return flat;
}

}  // namespace core
