#include "core/starter/kit/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace core::starter {
namespace {

constexpr double kPi = std::numbers::pi;

double catmull(double a, double b, double c, double d, double t) {
    return 0.5 * (2.0 * b + (c - a) * t + (2.0 * a - 5.0 * b + 4.0 * c - d) * t * t +
                  (3.0 * b - a - 3.0 * c + d) * t * t * t);
}

Station resolved(Station s) {
    if (s.side < 0.0) s.side = s.r;
    return s;
}

std::vector<Station> resampled(const std::vector<Station>& in, const TubeOptions& options) {
    std::vector<Station> out;
    if (options.straight || in.size() == 2) {
        for (const Station& s : in) out.push_back(resolved(s));
        return out;
    }
    const auto at = [&](std::ptrdiff_t i) {
        return resolved(in[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, std::ssize(in) - 1))]);
    };
    for (std::ptrdiff_t i = 0; i + 1 < std::ssize(in); ++i) {
        const Station a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
        const double low_r = std::min(b.r, c.r), low_side = std::min(b.side, c.side);
        for (int k = 0; k < options.steps; ++k) {
            const double t = static_cast<double>(k) / options.steps;
            out.push_back({{catmull(a.at.x, b.at.x, c.at.x, d.at.x, t), catmull(a.at.y, b.at.y, c.at.y, d.at.y, t),
                            catmull(a.at.z, b.at.z, c.at.z, d.at.z, t)},
                           std::max(low_r, catmull(a.r, b.r, c.r, d.r, t)),
                           std::max(low_side, catmull(a.side, b.side, c.side, d.side, t))});
        }
    }
    out.push_back(at(std::ssize(in) - 1));
    return out;
}

/// The two directions across the line at one place.
struct Frame {
    Vec3 up, side;
};

Frame frame_for(Vec3 tangent, const Frame* before) {
    Vec3 side = before ? before->side : Vec3{0.0, 0.0, 1.0};
    if (!before && std::abs(tangent.z) > 0.9) side = {1.0, 0.0, 0.0};
    side = normalised(side - tangent * dot(side, tangent));
    return {normalised(cross(side, tangent)), side};
}

Vec3 tangent_at(const std::vector<Station>& line, std::size_t i) {
    const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, line.size() - 1);
    return normalised(line[b].at - line[a].at);
}

/// Grows a mesh ring by ring.
class Skin {
  public:
    Skin(int sides, Rgb colour) : sides_(sides), colour_(colour) {}

    std::uint32_t vertex(Vec3 p) {
        mesh.vertices.push_back(p);
        mesh.colours.push_back(colour_);
        return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    }
    std::uint32_t ring_of(Vec3 centre, const Frame& f, double r, double side) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (int k = 0; k < sides_; ++k) {
            const double angle = 2.0 * kPi * k / sides_;
            vertex(centre + f.up * (r * std::cos(angle)) + f.side * (side * std::sin(angle)));
        }
        return first;
    }
    void bridge(std::uint32_t a, std::uint32_t b) {
        for (int k = 0; k < sides_; ++k) {
            const auto i = static_cast<std::uint32_t>(k), j = static_cast<std::uint32_t>((k + 1) % sides_);
            mesh.triangles.push_back({a + i, b + j, b + i});
            mesh.triangles.push_back({a + i, a + j, b + j});
        }
    }
    void fan(std::uint32_t ring, std::uint32_t tip, bool at_end) {
        for (int k = 0; k < sides_; ++k) {
            const auto i = ring + static_cast<std::uint32_t>(k),
                       j = ring + static_cast<std::uint32_t>((k + 1) % sides_);
            if (at_end)
                mesh.triangles.push_back({i, j, tip});
            else
                mesh.triangles.push_back({j, i, tip});
        }
    }
    TriangleMesh mesh;

  private:
    int sides_;
    Rgb colour_;
};

void add_cap(Skin& skin, const Station& s, const Frame& f, Vec3 outward, std::uint32_t last, Cap cap, bool at_end) {
    if (cap == Cap::Flat) {
        const std::uint32_t lid = skin.ring_of(s.at, f, s.r, s.side);  // own vertices: a sharp edge
        skin.fan(lid, skin.vertex(s.at), at_end);
        return;
    }
    constexpr int kRings = 4;
    const double reach = std::min(s.r, s.side);
    for (int k = 1; k < kRings; ++k) {
        const double angle = 0.5 * kPi * k / kRings;
        const std::uint32_t next = skin.ring_of(s.at + outward * (reach * std::sin(angle)), f, s.r * std::cos(angle),
                                                s.side * std::cos(angle));
        at_end ? skin.bridge(last, next) : skin.bridge(next, last);
        last = next;
    }
    skin.fan(last, skin.vertex(s.at + outward * reach), at_end);
}

}  // namespace

TriangleMesh tube(const std::vector<Station>& stations, Rgb colour, TubeOptions options) {
    const std::vector<Station> line = resampled(stations, options);
    Skin skin(options.sides, colour);
    std::uint32_t last = 0;
    Frame frame = frame_for(tangent_at(line, 0), nullptr);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3 tangent = tangent_at(line, i);
        if (i > 0) frame = frame_for(tangent, &frame);
        const std::uint32_t ring = skin.ring_of(line[i].at, frame, line[i].r, line[i].side);
        if (i == 0)
            add_cap(skin, line[i], frame, tangent * -1.0, ring, options.cap, false);
        else
            skin.bridge(last, ring);
        last = ring;
        if (i + 1 == line.size()) add_cap(skin, line[i], frame, tangent, ring, options.cap, true);
    }
    return skin.mesh;
}

TriangleMesh rod(Vec3 a, Vec3 b, double r, Rgb colour, Cap cap) {
    return cone(a, b, r, r, colour, cap);
}

TriangleMesh cone(Vec3 a, Vec3 b, double ra, double rb, Rgb colour, Cap cap) {
    return tube({{a, ra}, {b, rb}}, colour, {.sides = 16, .cap = cap, .straight = true});
}

TriangleMesh loop(const std::vector<Vec3>& points, double r, Rgb colour, int steps, int sides) {
    const auto n = points.size();
    std::vector<Vec3> line;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 a = points[(i + n - 1) % n], b = points[i], c = points[(i + 1) % n], d = points[(i + 2) % n];
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            line.push_back(
                {catmull(a.x, b.x, c.x, d.x, t), catmull(a.y, b.y, c.y, d.y, t), catmull(a.z, b.z, c.z, d.z, t)});
        }
    }
    Vec3 normal;  // of the loop's plane: a frame that needs no closing twist
    for (std::size_t i = 0; i < line.size(); ++i) normal = normal + cross(line[i], line[(i + 1) % line.size()]);
    normal = normalised(normal);
    Skin skin(sides, colour);
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec3 tangent = normalised(line[(i + 1) % line.size()] - line[(i + line.size() - 1) % line.size()]);
        skin.ring_of(line[i], {normalised(cross(normal, tangent)), normal}, r, r);
    }
    const auto s = static_cast<std::uint32_t>(sides);
    for (std::uint32_t i = 0; i < line.size(); ++i)
        skin.bridge(i * s, (i + 1) % static_cast<std::uint32_t>(line.size()) * s);
    return skin.mesh;
}

TriangleMesh ring(Vec3 centre, Vec3 axis, double radius, double r, Rgb colour, int around) {
    const Vec3 u = normalised(cross(std::abs(axis.y) < 0.9 ? Vec3{0.0, 1.0, 0.0} : Vec3{1.0, 0.0, 0.0}, axis));
    const Vec3 v = cross(axis, u);
    std::vector<Vec3> points;
    for (int k = 0; k < around; ++k) {
        const double angle = 2.0 * kPi * k / around;
        points.push_back(centre + u * (radius * std::cos(angle)) + v * (radius * std::sin(angle)));
    }
    return loop(points, r, colour, 1);
}

TriangleMesh lathe(const std::vector<Point>& profile, Rgb colour, int sides) {
    Skin skin(sides, colour);
    // Seen from +y the turn must be such that bridge() faces outward on a profile going up: up = +x, side = +z.
    const Frame frame{{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}};
    constexpr double kOnAxis = 1e-9, kSharpCosine = 0.75;
    const auto centre = [](Point p) { return Vec3{0.0, p.y, 0.0}; };
    std::vector<Point> line = profile;
    if (line.front().x > kOnAxis) line.insert(line.begin(), {0.0, line.front().y});
    if (line.back().x > kOnAxis) line.push_back({0.0, line.back().y});
    std::uint32_t last = 0;
    bool last_is_tip = true;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool tip = line[i].x <= kOnAxis;
        const auto make = [&] {
            return tip ? skin.vertex(centre(line[i])) : skin.ring_of(centre(line[i]), frame, line[i].x, line[i].x);
        };
        const std::uint32_t here = make();
        if (i > 0 && last_is_tip && !tip) skin.fan(here, last, false);
        if (i > 0 && !last_is_tip && tip) skin.fan(last, here, true);
        if (i > 0 && !last_is_tip && !tip) skin.bridge(last, here);
        last = here;
        last_is_tip = tip;
        if (!tip && i > 0 && i + 1 < line.size()) {
            const Point in = line[i] - line[i - 1], out = line[i + 1] - line[i];
            if (dot(in, out) < kSharpCosine * length(in) * length(out)) last = make();
        }
    }
    return skin.mesh;
}

TriangleMesh lathe_smooth(const std::vector<Point>& profile, Rgb colour, int sides, int steps) {
    std::vector<Point> line = spline(profile, steps);
    for (Point& p : line) p.x = std::max(p.x, 0.0);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) line[i].x = std::max(line[i].x, 1e-4);
    return lathe(line, colour, sides);
}

TriangleMesh ball(Vec3 centre, Vec3 radii, Rgb colour, int detail) {
    std::vector<Point> profile;
    for (int k = 0; k <= detail; ++k) {
        const double angle = kPi * (static_cast<double>(k) / detail - 0.5);
        profile.push_back({k == 0 || k == detail ? 0.0 : std::cos(angle), std::sin(angle)});
    }
    TriangleMesh mesh = lathe(profile, colour, 2 * detail);
    for (Vec3& v : mesh.vertices) v = centre + Vec3{v.x * radii.x, v.y * radii.y, v.z * radii.z};
    return mesh;
}

std::vector<Point> spline(const std::vector<Point>& points, int steps) {
    std::vector<Point> out;
    const auto n = std::ssize(points);
    const auto at = [&](std::ptrdiff_t i) {
        return points[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, n - 1))];
    };
    for (std::ptrdiff_t i = 0; i + 1 < n; ++i)
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            out.push_back({catmull(at(i - 1).x, at(i).x, at(i + 1).x, at(i + 2).x, t),
                           catmull(at(i - 1).y, at(i).y, at(i + 1).y, at(i + 2).y, t)});
        }
    out.push_back(points.back());
    return out;
}

std::vector<Point> closed_spline(const std::vector<Point>& points, int steps) {
    std::vector<Point> out;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Point a = points[(i + n - 1) % n], b = points[i], c = points[(i + 1) % n], d = points[(i + 2) % n];
        for (int k = 0; k < steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            out.push_back({catmull(a.x, b.x, c.x, d.x, t), catmull(a.y, b.y, c.y, d.y, t)});
        }
    }
    return out;
}

}  // namespace core::starter
