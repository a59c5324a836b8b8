// Stars, moons and teeth. They face +z.

#include <cmath>
#include <numbers>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/blob.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

/// A star whose faces rise from its rim to the middle; every facet has its own corners, so that its edges are sharp.
TriangleMesh star(int tips, double inner, double thickness, Rgb colour, Rgb edge, double stretch = 1.0) {
    constexpr double kRim = 0.04;
    const std::vector<Point> outline = star_outline({0, 0}, tips, 0.6, 0.6 * inner, 90);
    TriangleMesh mesh;
    const auto facet = [&](Vec3 a, Vec3 b, Vec3 c, Rgb shade) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
        mesh.colours.insert(mesh.colours.end(), 3, shade);
        mesh.triangles.push_back({first, first + 1, first + 2});
    };
    constexpr int kRings = 4;  // the facets in bands, so that the mesh has even triangles
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point p = outline[i], q = outline[(i + 1) % outline.size()];
        const Rgb shade = i % 2 == 0 ? colour : lighter(colour, 0.2);
        const auto at = [&](Point corner, double t, double face) {
            return Vec3{corner.x * (1.0 - t), corner.y * (1.0 - t), face * (kRim + (thickness - kRim) * t)};
        };
        for (int k = 0; k < kRings; ++k) {
            const double from = static_cast<double>(k) / kRings, to = (k + 1.0) / kRings;
            facet(at(p, from, 1), at(q, from, 1), at(q, to, 1), shade);
            if (k + 1 < kRings) facet(at(p, from, 1), at(q, to, 1), at(p, to, 1), shade);
            facet(at(q, from, -1), at(p, from, -1), at(q, to, -1), shade);
            if (k + 1 < kRings) facet(at(p, from, -1), at(p, to, -1), at(q, to, -1), shade);
        }
        facet(at(p, 0, -1), at(q, 0, -1), at(q, 0, 1), edge);
        facet(at(p, 0, -1), at(q, 0, 1), at(p, 0, 1), edge);
    }
    return scaled(mesh, {1.0, stretch, 1.0});
}

void add_stars(Models& models) {
    add_model(models, "star", "Gold star", star(5, 0.42, 0.2, kMustard, kHoney));
    add_model(models, "star", "Pointed star", star(5, 0.33, 0.16, kStraw, kMustard));
    add_model(models, "star", "Fat star", star(5, 0.55, 0.24, kCoral, kBrick, 1.06));
    add_model(models, "star", "Six-pointed star", star(6, 0.55, 0.18, kSky, kBlue));
    add_model(models, "star", "Wide star", star(5, 0.4, 0.18, kLilac, kPlum, 0.78));
}

/// The part of a disc that a second disc, moved aside by `offset`, leaves: a crescent open to +x.
TriangleMesh crescent(double offset, double inner, double thickness, Rgb colour) {
    const double reach = (1.0 + offset * offset - inner * inner) / (2.0 * offset), tip = std::acos(reach);
    const double inner_tip = std::atan2(std::sin(tip), reach - offset);
    std::vector<Point> outline;
    constexpr int kSteps = 30;
    constexpr double kBlunt = 0.09;  // radians of either arc left out, so that the tips have room for their bevel
    for (int k = 0; k <= kSteps; ++k) {
        const double angle = (tip + kBlunt) + (kTurn - 2.0 * (tip + kBlunt)) * k / kSteps;
        outline.push_back({0.6 * std::cos(angle), 0.6 * std::sin(angle)});
    }
    for (int k = kSteps; k >= 0; --k) {
        const double angle = (inner_tip + kBlunt) + (kTurn - 2.0 * (inner_tip + kBlunt)) * k / kSteps;
        outline.push_back({0.6 * (offset + inner * std::cos(angle)), 0.6 * inner * std::sin(angle)});
    }
    return slab(outline, thickness, 0.015, colour);
}

TriangleMesh full_moon(double flatness, Rgb colour) {
    Assembly a;
    a.add(ball({0, 0, 0}, {0.6, 0.6, 0.6 * flatness}, colour, 20));
    const auto crater = [&](double x, double y, double r) {
        const double z = 0.6 * flatness * std::sqrt(std::max(0.0, 1.0 - (x * x + y * y) / 0.36));
        for (const double face : {1.0, -1.0})
            a.add(ring({x, y, face * z * 0.97}, {0, 0, 1}, r, 0.022, darker(colour, 0.15), 20))
                .add(ball({x, y, face * z * 0.97}, {r * 0.95, r * 0.95, 0.02}, darker(colour, 0.25), 8));
    };
    crater(-0.18, 0.2, 0.11);
    crater(0.22, 0.12, 0.08);
    crater(0.05, -0.22, 0.13);
    crater(-0.3, -0.12, 0.06);
    return a.mesh();
}

void add_moons(Models& models) {
    add_model(models, "moon", "Crescent moon", crescent(0.4, 0.86, 0.2, kStraw));
    add_model(models, "moon", "Thin crescent", turned_z(crescent(0.3, 0.92, 0.16, kCream), 20));
    add_model(models, "moon", "Waxing moon", turned_z(crescent(0.62, 0.84, 0.22, kMustard), 180));
    add_model(models, "moon", "Sickle moon", turned_z(crescent(0.5, 0.74, 0.2, kSteel), 12));
    add_model(models, "moon", "Full moon", full_moon(0.6, kStone));
}

struct Tooth {
    double width = 0.34, crown = 0.34, root = 0.5, spread = 0.2, dent = 0.06;
    int roots = 2;
    Rgb enamel = kWhite;
};

TriangleMesh tooth(const Tooth& t) {
    Blob b(0.07);
    for (const double side : {1.0, -1.0}) {
        b.egg({side * t.width * 0.48, 0, 0}, {t.width * 0.56, t.crown, 0.26}, t.enamel);
        b.limb({side * t.width * 0.55, -t.crown * 0.4, 0},
               {side * (t.width * 0.4 + t.spread), -t.crown * 0.5 - t.root, 0}, 0.19, 0.07,
               mixed(t.enamel, kIvory, 0.5));
    }
    if (t.roots > 2)
        b.limb({0, -t.crown * 0.4, 0}, {0, -t.crown * 0.5 - t.root * 0.9, 0}, 0.13, 0.06, mixed(t.enamel, kIvory, 0.5));
    b.egg({0, -t.dent, 0}, {t.width * 0.6, t.crown * 0.9, 0.25}, t.enamel);
    return b.mesh(36);
}

void add_teeth(Models& models) {
    add_model(models, "tooth", "Tooth", tooth({}));
    add_model(models, "tooth", "Molar", tooth({.width = 0.44, .crown = 0.32, .root = 0.36, .spread = 0.14}));
    add_model(models, "tooth", "Milk tooth",
              tooth({.width = 0.3, .crown = 0.3, .root = 0.32, .spread = 0.06, .enamel = kCream}));
    add_model(models, "tooth", "Long-rooted tooth",
              tooth({.width = 0.34, .crown = 0.32, .root = 0.8, .spread = 0.1, .enamel = kIvory}));
    add_model(models, "tooth", "Splayed tooth",
              tooth({.width = 0.36, .crown = 0.36, .root = 0.5, .spread = 0.34, .dent = 0.12, .enamel = kWhite}));
}

}  // namespace

void add_keepsakes(Models& models) {
    add_stars(models);
    add_moons(models);
    add_teeth(models);
}

}  // namespace core::starter
