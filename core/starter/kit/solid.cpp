#include "core/starter/kit/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace core::starter {
namespace {

constexpr double kPi = std::numbers::pi;

double signed_area(const std::vector<Point>& ring) {
    double twice = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
    return 0.5 * twice;
}

bool inside(Point p, Point a, Point b, Point c) {
    return cross(b - a, p - a) >= 0.0 && cross(c - b, p - b) >= 0.0 && cross(a - c, p - c) >= 0.0;
}

/// Ear clipping of an anti-clockwise ring; quadratic to cubic, for outlines of at most a few hundred points.
std::vector<std::array<std::uint32_t, 3>> ears(const std::vector<Point>& ring) {
    std::vector<std::uint32_t> left(ring.size());
    for (std::uint32_t i = 0; i < left.size(); ++i) left[i] = i;
    std::vector<std::array<std::uint32_t, 3>> out;
    const auto is_ear = [&](std::size_t i) {
        const auto n = left.size();
        const std::uint32_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
        if (cross(ring[b] - ring[a], ring[c] - ring[b]) <= 0.0) return false;
        return std::none_of(left.begin(), left.end(), [&](std::uint32_t k) {
            return k != a && k != b && k != c && inside(ring[k], ring[a], ring[b], ring[c]);
        });
    };
    std::size_t cursor = 0;
    while (left.size() > 3) {
        std::size_t tries = 0;
        while (tries < left.size() && !is_ear((cursor + tries) % left.size())) ++tries;
        const std::size_t i = (cursor + (tries == left.size() ? 0 : tries)) % left.size();  // no ear: a flat corner
        const auto n = left.size();
        out.push_back({left[(i + n - 1) % n], left[i], left[(i + 1) % n]});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
        cursor = i + 1;  // go round instead of making a fan of slivers
    }
    out.push_back({left[0], left[1], left[2]});
    return out;
}

std::vector<Point> inset(const std::vector<Point>& ring, double by) {
    std::vector<Point> out;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point before = ring[i] - ring[(i + n - 1) % n], after = ring[(i + 1) % n] - ring[i];
        const Point na = Point{-before.y, before.x} * (1.0 / std::max(length(before), 1e-12));
        const Point nb = Point{-after.y, after.x} * (1.0 / std::max(length(after), 1e-12));
        const Point sum = na + nb;
        const double scale = 2.0 / std::max(dot(sum, sum), 0.8);  // mitre, limited at sharp tips
        out.push_back(ring[i] + sum * (by * scale));
    }
    return out;
}

/// Where the outline turns by more than about 40 degrees.
std::vector<bool> sharp_corners(const std::vector<Point>& ring) {
    std::vector<bool> out;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point before = ring[i] - ring[(i + n - 1) % n], after = ring[(i + 1) % n] - ring[i];
        out.push_back(dot(before, after) < 0.76 * length(before) * length(after));
    }
    return out;
}

}  // namespace

TriangleMesh box(Vec3 centre, Vec3 size, double round, Rgb colour) {
    constexpr int kHalf = 2;  // pieces from an edge's middle to a face's middle
    const Vec3 core{std::max(size.x / 2 - round, 0.0), std::max(size.y / 2 - round, 0.0),
                    std::max(size.z / 2 - round, 0.0)};
    std::vector<std::pair<double, double>> marks;  // (position on the unit cube's face, side of the middle)
    for (int k = -kHalf; k <= 0; ++k) marks.push_back({std::tan(kPi / 4 * k / kHalf), -1.0});
    for (int k = 0; k <= kHalf; ++k) marks.push_back({std::tan(kPi / 4 * k / kHalf), 1.0});
    TriangleMesh mesh;
    std::map<std::array<long, 3>, std::uint32_t> known;
    const auto vertex = [&](Vec3 direction, Vec3 side) {
        const Vec3 d = normalised(direction);
        const Vec3 p{side.x * core.x + d.x * round, side.y * core.y + d.y * round, side.z * core.z + d.z * round};
        const std::array<long, 3> key{std::lround(p.x * 1e7), std::lround(p.y * 1e7), std::lround(p.z * 1e7)};
        const auto [it, fresh] = known.try_emplace(key, static_cast<std::uint32_t>(mesh.vertices.size()));
        if (fresh) {
            mesh.vertices.push_back(centre + p);
            mesh.colours.push_back(colour);
        }
        return it->second;
    };
    const auto face = [&](auto&& place) {
        for (std::size_t i = 0; i + 1 < marks.size(); ++i)
            for (std::size_t j = 0; j + 1 < marks.size(); ++j) {
                const std::uint32_t a = place(marks[i], marks[j]), b = place(marks[i + 1], marks[j]),
                                    c = place(marks[i + 1], marks[j + 1]), d = place(marks[i], marks[j + 1]);
                if (a != b && b != c && a != c) mesh.triangles.push_back({a, b, c});
                if (a != c && c != d && a != d) mesh.triangles.push_back({a, c, d});
            }
    };
    using Mark = std::pair<double, double>;
    for (const double s : {1.0, -1.0}) {  // u and v swap with the sign, so that faces stay outward
        face([&](Mark u, Mark v) {
            if (s < 0) std::swap(u, v);
            return vertex({s, u.first, v.first}, {s, u.second, v.second});
        });
        face([&](Mark u, Mark v) {
            if (s < 0) std::swap(u, v);
            return vertex({v.first, s, u.first}, {v.second, s, u.second});
        });
        face([&](Mark u, Mark v) {
            if (s < 0) std::swap(u, v);
            return vertex({u.first, v.first, s}, {u.second, v.second, s});
        });
    }
    return mesh;
}

TriangleMesh box_between(Vec3 low, Vec3 high, double round, Rgb colour) {
    return box((low + high) * 0.5, high - low, round, colour);
}

TriangleMesh slab(std::vector<Point> outline, double thickness, double bevel, Rgb colour) {
    if (signed_area(outline) < 0.0) std::reverse(outline.begin(), outline.end());
    const std::vector<Point> small = inset(outline, bevel);
    const auto n = static_cast<std::uint32_t>(outline.size());
    const double half = thickness / 2;
    TriangleMesh mesh;
    const auto layer = [&](const std::vector<Point>& ring, double z) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Point p : ring) {
            mesh.vertices.push_back({p.x, p.y, z});
            mesh.colours.push_back(colour);
        }
        return first;
    };
    const std::uint32_t back = layer(small, -half), front = layer(small, half);
    for (const auto& t : ears(outline)) {
        mesh.triangles.push_back({front + t[0], front + t[1], front + t[2]});
        mesh.triangles.push_back({back + t[0], back + t[2], back + t[1]});
    }
    // The rim: a vertex for the edge that comes and one for the edge that leaves, so that sharp corners stay sharp.
    const std::vector<bool> sharp = sharp_corners(outline);
    std::vector<std::array<std::uint32_t, 2>> last;
    const auto rim = [&](const std::vector<Point>& ring, double z) {
        std::vector<std::array<std::uint32_t, 2>> here;
        for (std::uint32_t i = 0; i < n; ++i) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (int copy = 0; copy < (sharp[i] ? 2 : 1); ++copy) {
                mesh.vertices.push_back({ring[i].x, ring[i].y, z});
                mesh.colours.push_back(colour);
            }
            here.push_back({first, first + (sharp[i] ? 1U : 0U)});
        }
        for (std::uint32_t i = 0; i < n && !last.empty(); ++i) {
            const std::uint32_t j = (i + 1) % n;
            mesh.triangles.push_back({last[i][1], last[j][0], here[j][0]});
            mesh.triangles.push_back({last[i][1], here[j][0], here[i][1]});
        }
        last = here;
    };
    rim(small, -half);
    rim(outline, -half + bevel);
    rim(outline, half - bevel);
    rim(small, half);
    return mesh;
}

std::vector<Point> circle_outline(Point centre, double rx, double ry, int points) {
    std::vector<Point> out;
    for (int k = 0; k < points; ++k) {
        const double angle = 2.0 * kPi * k / points;
        out.push_back({centre.x + rx * std::cos(angle), centre.y + ry * std::sin(angle)});
    }
    return out;
}

std::vector<Point> rounded_rectangle(Point low, Point high, double round) {
    std::vector<Point> out;
    const std::array<Point, 4> corners{{{high.x - round, high.y - round},
                                        {low.x + round, high.y - round},
                                        {low.x + round, low.y + round},
                                        {high.x - round, low.y + round}}};
    constexpr int kSteps = 5;
    for (std::size_t c = 0; c < corners.size(); ++c)
        for (int k = 0; k <= kSteps; ++k) {
            const double angle = kPi / 2 * (static_cast<double>(c) + static_cast<double>(k) / kSteps);
            out.push_back(corners[c] + Point{round * std::cos(angle), round * std::sin(angle)});
        }
    return out;
}

std::vector<Point> star_outline(Point centre, int tips, double outer, double inner, double start_degrees) {
    std::vector<Point> out;
    for (int k = 0; k < 2 * tips; ++k) {
        const double angle = start_degrees * kPi / 180.0 + kPi * k / tips;
        const double r = k % 2 == 0 ? outer : inner;
        out.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
    return out;
}

}  // namespace core::starter
