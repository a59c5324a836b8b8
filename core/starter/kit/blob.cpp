#include "core/starter/kit/blob.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace core::starter {
namespace {

/// Values of the field at the corners of a regular grid; far from the surface only the sign and "far" are kept.
struct Grid {
    Vec3 origin;
    double cell = 1.0;
    int nx = 0, ny = 0, nz = 0;
    std::vector<float> value;

    [[nodiscard]] std::size_t at(int x, int y, int z) const {
        return (static_cast<std::size_t>(z) * static_cast<std::size_t>(ny) + static_cast<std::size_t>(y)) *
                   static_cast<std::size_t>(nx) +
               static_cast<std::size_t>(x);
    }
    [[nodiscard]] Vec3 place(int x, int y, int z) const { return origin + Vec3{x * cell, y * cell, z * cell}; }
};

/// Where the surface crosses the cell's edges, averaged; false if it does not.
bool crossing_mean(const Grid& grid, int x, int y, int z, Vec3& mean) {
    static constexpr std::array<std::array<int, 2>, 12> kEdges{
        {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};
    std::array<double, 8> v{};
    int below = 0;
    for (int c = 0; c < 8; ++c) {
        v[static_cast<std::size_t>(c)] = grid.value[grid.at(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))];
        below += v[static_cast<std::size_t>(c)] < 0.0;
    }
    if (below == 0 || below == 8) return false;
    Vec3 sum;
    int count = 0;
    for (const auto& e : kEdges) {
        const double a = v[static_cast<std::size_t>(e[0])], b = v[static_cast<std::size_t>(e[1])];
        if ((a < 0.0) == (b < 0.0)) continue;
        const double t = a / (a - b);
        const auto corner = [](int c) {
            return Vec3{static_cast<double>(c & 1), static_cast<double>(c >> 1 & 1), static_cast<double>(c >> 2)};
        };
        sum = sum + corner(e[0]) * (1.0 - t) + corner(e[1]) * t;
        ++count;
    }
    mean = grid.place(x, y, z) + sum * (grid.cell / count);
    return true;
}

/// Two triangles for every grid edge that the surface crosses, between the four cells around it.
void add_quads(const Grid& grid, const std::vector<std::uint32_t>& cell_vertex, TriangleMesh& mesh) {
    for (int z = 1; z + 1 < grid.nz; ++z)
        for (int y = 1; y + 1 < grid.ny; ++y)
            for (int x = 1; x + 1 < grid.nx; ++x) {
                const bool in = grid.value[grid.at(x, y, z)] < 0.0F;
                const auto quad = [&](int dx, int dy, int dz, std::size_t a, std::size_t b, std::size_t c,
                                      std::size_t d) {
                    const bool other = grid.value[grid.at(x + dx, y + dy, z + dz)] < 0.0F;
                    if (in == other) return;
                    std::array<std::uint32_t, 4> q{cell_vertex[a], cell_vertex[b], cell_vertex[c], cell_vertex[d]};
                    if (!in) std::swap(q[1], q[3]);
                    mesh.triangles.push_back({q[0], q[1], q[2]});
                    mesh.triangles.push_back({q[0], q[2], q[3]});
                };
                quad(1, 0, 0, grid.at(x, y - 1, z - 1), grid.at(x, y, z - 1), grid.at(x, y, z), grid.at(x, y - 1, z));
                quad(0, 1, 0, grid.at(x - 1, y, z - 1), grid.at(x - 1, y, z), grid.at(x, y, z), grid.at(x, y, z - 1));
                quad(0, 0, 1, grid.at(x - 1, y - 1, z), grid.at(x, y - 1, z), grid.at(x, y, z), grid.at(x - 1, y, z));
            }
}

}  // namespace

Blob& Blob::limb(Vec3 a, Vec3 b, double ra, double rb, Rgb colour) {
    primitives_.push_back({.is_egg = false, .a = a, .b = b, .ra = ra, .rb = rb, .colour = colour, .blend = blend_});
    return *this;
}

Blob& Blob::chain(const std::vector<Station>& stations, Rgb colour) {
    for (std::size_t i = 0; i + 1 < stations.size(); ++i)
        limb(stations[i].at, stations[i + 1].at, stations[i].r, stations[i + 1].r, colour);
    return *this;
}

Blob& Blob::egg(Vec3 centre, Vec3 radii, Rgb colour, double tilt_degrees) {
    const double tilt = tilt_degrees * std::numbers::pi / 180.0;
    primitives_.push_back({.is_egg = true,
                           .a = centre,
                           .b = radii,
                           .cosine = std::cos(tilt),
                           .sine = std::sin(tilt),
                           .colour = colour,
                           .blend = blend_});
    return *this;
}

Blob& Blob::limb_pair(Vec3 a, Vec3 b, double ra, double rb, Rgb colour) {
    return limb(a, b, ra, rb, colour).limb({a.x, a.y, -a.z}, {b.x, b.y, -b.z}, ra, rb, colour);
}

Blob& Blob::egg_pair(Vec3 centre, Vec3 radii, Rgb colour, double tilt_degrees) {
    return egg(centre, radii, colour, tilt_degrees).egg({centre.x, centre.y, -centre.z}, radii, colour, tilt_degrees);
}

double Blob::distance_to(const Primitive& s, Vec3 p) {
    if (s.is_egg) {
        const Vec3 q = p - s.a;
        const Vec3 local{s.cosine * q.x + s.sine * q.y, s.cosine * q.y - s.sine * q.x, q.z};
        const Vec3 u{local.x / s.b.x, local.y / s.b.y, local.z / s.b.z};
        const Vec3 w{u.x / s.b.x, u.y / s.b.y, u.z / s.b.z};
        const double k0 = length(u), k1 = length(w);
        return k1 > 1e-9 ? k0 * (k0 - 1.0) / k1 : -std::min({s.b.x, s.b.y, s.b.z});
    }
    const Vec3 along = s.b - s.a;
    const double square = dot(along, along);
    const double t = square > 0.0 ? std::clamp(dot(p - s.a, along) / square, 0.0, 1.0) : 0.0;
    return length(p - s.a - along * t) - (s.ra + (s.rb - s.ra) * t);
}

double Blob::field(Vec3 p) const {
    double d = std::numeric_limits<double>::max();
    for (const Primitive& s : primitives_) {
        const double e = distance_to(s, p);
        const double h = std::max(s.blend - std::abs(d - e), 0.0) / s.blend;
        d = std::min(d, e) - h * h * s.blend * 0.25;
    }
    return d;
}

Vec3 Blob::gradient(Vec3 p, double step) const {
    return normalised({field(p + Vec3{step, 0, 0}) - field(p - Vec3{step, 0, 0}),
                       field(p + Vec3{0, step, 0}) - field(p - Vec3{0, step, 0}),
                       field(p + Vec3{0, 0, step}) - field(p - Vec3{0, 0, step})});
}

Rgb Blob::colour_at(Vec3 p, double softness) const {
    double nearest = std::numeric_limits<double>::max();
    for (const Primitive& s : primitives_) nearest = std::min(nearest, distance_to(s, p));
    double weight = 0.0, r = 0.0, g = 0.0, b = 0.0;
    for (const Primitive& s : primitives_) {
        const double w = std::max(0.0, 1.0 - (distance_to(s, p) - nearest) / softness);
        weight += w;
        r += w * s.colour.r;
        g += w * s.colour.g;
        b += w * s.colour.b;
    }
    const auto channel = [weight](double sum) { return static_cast<std::uint8_t>(std::lround(sum / weight)); };
    return {channel(r), channel(g), channel(b)};
}

double Blob::longest_blend() const {
    double longest = 0.0;
    for (const Primitive& s : primitives_) longest = std::max(longest, s.blend);
    return longest;
}

Blob Blob::nearby(Vec3 place, double radius) const {
    Blob near(blend_);
    const double most = field(place) + 2.0 * radius + longest_blend();
    for (const Primitive& s : primitives_)
        if (distance_to(s, place) <= most) near.primitives_.push_back(s);
    return near;
}

TriangleMesh Blob::mesh(int cells) const {
    const double expected = 4.0 * static_cast<double>(meshed(cells / 2).triangles.size());
    if (expected <= kMostTriangles) return meshed(cells);
    return meshed(static_cast<int>(cells * std::sqrt(kMostTriangles / expected)));
}

TriangleMesh Blob::meshed(int cells) const {
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    const auto cover = [&](Vec3 c, double r) {
        low = {std::min(low.x, c.x - r), std::min(low.y, c.y - r), std::min(low.z, c.z - r)};
        high = {std::max(high.x, c.x + r), std::max(high.y, c.y + r), std::max(high.z, c.z + r)};
    };
    for (const Primitive& s : primitives_) {
        cover(s.a, s.is_egg ? std::max({s.b.x, s.b.y, s.b.z}) : s.ra);
        if (!s.is_egg) cover(s.b, s.rb);
    }
    Grid grid;
    grid.cell = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / cells;
    const double margin = 3.0 * grid.cell;
    grid.origin = low - Vec3{margin, margin, margin};
    const auto count = [&](double from, double to) {
        return (static_cast<int>((to - from + 2.0 * margin) / grid.cell) + 2 + 3) / 4 * 4;
    };
    grid.nx = count(low.x, high.x);
    grid.ny = count(low.y, high.y);
    grid.nz = count(low.z, high.z);
    const double reach = longest_blend();
    const std::size_t blocks_x = static_cast<std::size_t>(grid.nx / 4),
                      blocks_y = static_cast<std::size_t>(grid.ny / 4);
    std::vector<Blob> near(grid.at(grid.nx - 1, grid.ny - 1, grid.nz - 1) / 64 + 1, Blob(blend_));
    const auto block = [&](int x, int y, int z) -> Blob& {
        const auto bx = static_cast<std::size_t>(x / 4), by = static_cast<std::size_t>(y / 4);
        return near[(static_cast<std::size_t>(z / 4) * blocks_y + by) * blocks_x + bx];
    };
    grid.value.resize(grid.at(grid.nx - 1, grid.ny - 1, grid.nz - 1) + 1);
    for (int z = 0; z < grid.nz; z += 4)
        for (int y = 0; y < grid.ny; y += 4)
            for (int x = 0; x < grid.nx; x += 4) {
                const Vec3 centre = grid.place(x, y, z) + Vec3{1.5, 1.5, 1.5} * grid.cell;
                const double middle = field(centre);
                const bool far = std::abs(middle) > 5.0 * grid.cell + reach;  // a block's half diagonal is 2.6 cells
                Blob& local = block(x, y, z);
                if (!far) local = nearby(centre, 4.0 * grid.cell);
                for (int k = 0; k < 64; ++k) {
                    const int i = x + (k & 3), j = y + (k >> 2 & 3), l = z + (k >> 4);
                    grid.value[grid.at(i, j, l)] = static_cast<float>(far ? middle : local.field(grid.place(i, j, l)));
                }
            }
    TriangleMesh mesh;
    std::vector<std::uint32_t> cell_vertex(grid.value.size(), 0);
    for (int z = 0; z + 1 < grid.nz; ++z)
        for (int y = 0; y + 1 < grid.ny; ++y)
            for (int x = 0; x + 1 < grid.nx; ++x) {
                Vec3 p;
                if (!crossing_mean(grid, x, y, z, p)) continue;
                const Blob& local = block(x, y, z);
                const double off = std::clamp(local.field(p), -0.5 * grid.cell, 0.5 * grid.cell);
                p = p - local.gradient(p, 0.3 * grid.cell) * off;
                cell_vertex[grid.at(x, y, z)] = static_cast<std::uint32_t>(mesh.vertices.size());
                mesh.vertices.push_back(p);
                mesh.colours.push_back(local.colour_at(p, 0.9 * grid.cell));
            }
    add_quads(grid, cell_vertex, mesh);
    return mesh;
}

}  // namespace core::starter
