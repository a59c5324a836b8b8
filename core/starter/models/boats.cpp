// Sailboats, ships, canoes, submarines and hot air balloons.

#include <algorithm>
#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

struct Hull {
    double length = 1.4, height = 0.28, width = 0.4;
    double bow = 0.22, stern = 0.06;  ///< how far the deck reaches beyond the keel
    double sheer = 0.08;              ///< how much the bow stands above the middle
    Rgb side = kRed, stripe = kWhite;
};

/// A hull with its deck near y = 0: full in the middle, sharp at the bow (+x), narrow at the keel.
TriangleMesh hull(const Hull& h) {
    const double l = h.length / 2;
    std::vector<Point> outline;
    for (int k = 0; k <= 16; ++k) {
        const double t = k / 16.0;
        outline.push_back(
            {-l - h.stern + (2 * l + h.stern + h.bow) * t, h.sheer * std::pow(std::abs(2 * t - 0.8), 2.0)});
    }
    for (int k = 16; k >= 0; --k) {
        const double t = k / 16.0;
        outline.push_back({-l + 2 * l * t * 0.92, -h.height * (1.0 - 0.25 * std::pow(t, 6.0))});
    }
    const TriangleMesh plate = slab(outline, h.width, 0.02, h.side);
    return painted(bent(plate,
                        [&](Vec3 p) {
                            const double t = std::clamp((p.x + l + h.stern) / (2 * l + h.stern + h.bow), 0.0, 1.0);
                            const double beam = std::max(0.04, std::min(1.0, 1.25 * std::pow(1.0 - t, 0.55)) *
                                                                   (0.72 + 0.28 * std::min(1.0, t * 4.0)));
                            const double depth = std::clamp(-p.y / h.height, 0.0, 1.0);
                            return Vec3{p.x, p.y, p.z * beam * (1.0 - 0.55 * depth * depth)};
                        }),
                   [&](Vec3 p, Rgb c) { return p.y > -h.height * 0.22 ? h.stripe : c; });
}

TriangleMesh sail(const std::vector<Point>& outline, double belly, Rgb cloth) {
    double low = 1e9, high = -1e9;
    for (const Point p : outline) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    return bent(slab(outline, 0.025, 0.008, cloth), [=](Vec3 p) {
        return Vec3{p.x, p.y, p.z + belly * std::sin(3.14159265 * (p.y - low) / (high - low)) * 0.3};
    });
}

std::vector<Point> subdivided(const std::vector<Point>& ring, int pieces) {
    std::vector<Point> out;
    for (std::size_t i = 0; i < ring.size(); ++i)
        for (int k = 0; k < pieces; ++k)
            out.push_back(ring[i] + (ring[(i + 1) % ring.size()] - ring[i]) * (static_cast<double>(k) / pieces));
    return out;
}

void add_sailboats(Models& models) {
    const auto sloop = [](const Hull& h, double mast, double boom, double jib, Rgb main_cloth, Rgb jib_cloth,
                          bool cabin) {
        Assembly a;
        a.add(hull(h))
            .add(rod({0.05, -0.02, 0}, {0.05, mast, 0}, 0.024, kWalnut))
            .add(rod({0.05, 0.15, 0}, {0.05 - boom, 0.13, 0}, 0.018, kWalnut));
        a.add(sail(subdivided({{0.02, 0.18}, {0.02, mast - 0.05}, {-boom * 0.45, mast * 0.5}, {-boom + 0.03, 0.17}}, 6),
                   0.1, main_cloth));
        if (jib > 0) a.add(sail(subdivided({{0.1, 0.12}, {0.09, mast * 0.85}, {0.1 + jib, 0.1}}, 6), 0.1, jib_cloth));
        a.add(slab({{0.05, mast}, {0.05, mast + 0.12}, {-0.15, mast + 0.06}}, 0.02, 0.005, kCoral));
        if (cabin)
            a.add(box({-0.1, 0.05, 0}, {0.5, 0.12, h.width * 0.55}, 0.04, kWhite))
                .pair(ball({-0.2, 0.06, h.width * 0.275}, {0.04, 0.03, 0.015}, kGlass, 8))
                .pair(ball({0.0, 0.06, h.width * 0.275}, {0.04, 0.03, 0.015}, kGlass, 8));
        return facing_front(a.mesh());
    };
    add_model(models, "sailboat", "Sailboat", sloop({}, 1.35, 0.65, 0.55, kWhite, kCream, false));
    add_model(models, "sailboat", "Yacht",
              sloop({.length = 1.7, .height = 0.24, .width = 0.42, .bow = 0.35, .side = kNavy}, 1.8, 0.75, 0.75, kWhite,
                    kWhite, true));
    add_model(models, "sailboat", "Dinghy",
              sloop({.length = 1.0, .height = 0.2, .width = 0.36, .bow = 0.12, .side = kMustard, .stripe = kHoney}, 1.3,
                    0.55, 0.0, kCoral, kCoral, false));
    const auto ship = [](const Hull& h, int masts, Rgb cloth) {
        Assembly a;
        a.add(hull(h))
            .add(box({-h.length * 0.42, 0.12, 0}, {h.length * 0.22, 0.2, h.width * 0.7}, 0.03, h.side))
            .add(rod({h.length * 0.5, 0.05, 0}, {h.length * 0.82, 0.26, 0}, 0.022, kWalnut));
        for (int k = 0; k < masts; ++k) {
            const double x = h.length * (masts == 1 ? 0.03 : -0.28 + 0.54 * k / (masts - 1.0)),
                         height = 1.25 - 0.12 * std::abs(k - (masts - 1) / 2.0);
            a.add(rod({x, -0.02, 0}, {x, height, 0}, 0.026, kWalnut))
                .add(slab({{x, height}, {x, height + 0.12}, {x - 0.2, height + 0.06}}, 0.02, 0.005, kRed));
            for (int s = 0; s < 2; ++s) {
                const double low = 0.16 + 0.5 * s, high = low + 0.42,
                             w = h.length * (masts == 1 ? 0.36 : 0.42 / masts) * (1.0 - 0.2 * s);
                a.add(moved(sail(subdivided({{-w, low}, {-w * 0.8, high}, {w * 0.8, high}, {w, low}}, 5), 0.3, cloth),
                            {x, 0, 0.03}));
                a.add(rod({x - w * 0.9, high, 0.0}, {x + w * 0.9, high, 0.0}, 0.014, kCocoa));
            }
        }
        return facing_front(a.mesh());
    };
    add_model(models, "sailboat", "Two-master",
              ship({.length = 1.7,
                    .height = 0.34,
                    .width = 0.5,
                    .bow = 0.3,
                    .stern = 0.14,
                    .sheer = 0.16,
                    .side = kWalnut,
                    .stripe = kHoney},
                   2, kCream));
    add_model(models, "sailboat", "Viking ship",
              ship({.length = 1.5,
                    .height = 0.3,
                    .width = 0.42,
                    .bow = 0.34,
                    .stern = 0.3,
                    .sheer = 0.42,
                    .side = kChestnut,
                    .stripe = kMustard},
                   1, kBrick));
}

void add_other_boats(Models& models) {
    const auto liner = [](double length, int decks, int funnels, Rgb side, Rgb funnel) {
        Assembly a;
        a.add(hull(
            {.length = length, .height = 0.34, .width = 0.44, .bow = 0.34, .stern = 0.1, .sheer = 0.08, .side = side}));
        for (int k = 0; k < decks; ++k) {
            const double l = length * (0.78 - 0.13 * k), y = 0.08 + 0.15 * k;
            a.add(box({-0.06, y, 0}, {l, 0.15, 0.34 - 0.05 * k}, 0.03, kWhite));
            const int windows = static_cast<int>(l / 0.13);
            for (int w = 0; w < windows; ++w)
                a.pair(ball({-0.06 - l / 2 + (w + 0.5) * l / windows, y + 0.01, 0.17 - 0.025 * k},
                            {0.032, 0.032, 0.012}, kNavy, 6));
        }
        for (int k = 0; k < funnels; ++k) {
            const double x = length * 0.18 * (k - (funnels - 1) / 2.0) - 0.1, y = 0.1 + 0.15 * decks;
            a.add(painted(
                tube({{{x, y - 0.1, 0}, 0.075}, {{x - 0.03, y + 0.1, 0}, 0.075}, {{x - 0.06, y + 0.3, 0}, 0.07}},
                     funnel, {.sides = 18, .cap = Cap::Flat}),
                [&](Vec3 p, Rgb c) { return p.y > y + 0.22 ? kInk : c; }));
        }
        return facing_front(a.mesh());
    };
    add_model(models, "cruise ship", "Cruise ship", liner(2.2, 3, 2, kNavy, kCoral));
    add_model(models, "cruise ship", "Ocean liner", liner(2.6, 2, 4, kInk, kHoney));
    add_model(models, "cruise ship", "Ferry", liner(1.6, 3, 1, kTeal, kMustard));
    const auto canoe = [](double length, double rise, double width, Rgb colour, int paddles) {
        Assembly a;
        std::vector<Station> line;
        for (int k = 0; k <= 12; ++k) {
            const double u = k / 6.0 - 1.0, full = 1.0 - std::pow(std::abs(u), 2.4);
            line.push_back(
                {{u * length / 2, rise * std::pow(std::abs(u), 3.0), 0}, 0.05 + 0.1 * full, 0.02 + width * full});
        }
        a.add(tube(line, colour, {.sides = 24, .steps = 3}));
        a.add(bent(ball({0, 0.1, 0}, {length * 0.4, 0.07, width * 0.72}, darker(colour, 0.4), 14), [&](Vec3 p) {
            return Vec3{p.x, p.y + rise * std::pow(std::abs(2 * p.x / length), 3.0), p.z};
        }));
        for (int k = 0; k < paddles; ++k) {
            const double x = -0.15 + 0.5 * k;
            a.add(rod({x, 0.55, -0.05}, {x + 0.22, -0.28, 0.3}, 0.018, kHoney))
                .add(ball({x + 0.25, -0.38, 0.34}, {0.06, 0.15, 0.02}, kHoney, 8));
        }
        return facing_front(a.mesh());
    };
    add_model(models, "canoe", "Canoe", canoe(1.9, 0.26, 0.26, kRed, 1));
    add_model(models, "canoe", "Birch canoe", canoe(1.7, 0.4, 0.3, kSand, 2));
    add_model(models, "canoe", "Kayak", canoe(2.2, 0.08, 0.22, kTeal, 1));
    const auto submarine = [](double length, double r, double tower, Rgb colour, int ports) {
        Assembly a;
        a.add(tube({{{-length / 2, 0, 0}, r * 0.25},
                    {{-length * 0.35, 0, 0}, r * 0.75},
                    {{-length * 0.1, 0, 0}, r},
                    {{length * 0.3, 0, 0}, r},
                    {{length * 0.44, 0, 0}, r * 0.75}},
                   colour, {.sides = 26}));
        a.add(tube({{{0.08, r * 0.7, 0}, 0.2, 0.12}, {{0.06, r + tower, 0}, 0.17, 0.1}}, colour,
                   {.sides = 20, .cap = Cap::Flat}))
            .add(tube({{{0.08, r + tower - 0.03, 0}, 0.025},
                       {{0.08, r + tower + 0.2, 0}, 0.025},
                       {{0.11, r + tower + 0.26, 0}, 0.027},
                       {{0.2, r + tower + 0.26, 0}, 0.03}},
                      kBrass, {.steps = 8}));
        for (int k = 0; k < ports; ++k) {
            const double x = length * (0.3 - 0.46 * k / std::max(1, ports - 1));
            a.pair(ring({x, 0.06, r * 0.97}, {0, 0, 1}, 0.07, 0.018, kBrass, 24))
                .pair(ball({x, 0.06, r * 0.95}, {0.065, 0.065, 0.03}, kGlass, 10));
        }
        a.add(moved(slab({{0.0, 0.0}, {-0.12, 0.26}, {-0.26, 0.26}, {-0.2, 0.0}}, 0.05, 0.015, darker(colour)),
                    {-length * 0.36, r * 0.5, 0}))
            .add(moved(
                mirrored_x(turned_z(
                    slab({{0.0, 0.0}, {-0.12, 0.26}, {-0.26, 0.26}, {-0.2, 0.0}}, 0.05, 0.015, darker(colour)), 180)),
                {-length * 0.36, -r * 0.5, 0}));
        for (int k = 0; k < 3; ++k)
            a.add(moved(turned_x(ball({0, 0.11, 0}, {0.02, 0.11, 0.05}, kBrass, 8), 120.0 * k),
                        {-length / 2 - 0.07, 0, 0}));
        a.add(rod({-length / 2 - 0.1, 0, 0}, {-length / 2, 0, 0}, 0.03, kBrass));
        return facing_front(a.mesh());
    };
    add_model(models, "submarine", "Yellow submarine", submarine(1.5, 0.32, 0.24, kMustard, 3));
    add_model(models, "submarine", "Long submarine", submarine(2.2, 0.24, 0.3, kSlate, 4));
    add_model(models, "submarine", "Little submarine", submarine(1.1, 0.36, 0.18, kTeal, 2));
    const auto balloon = [](double width, double height, double gap, int panels, Rgb one, Rgb two) {
        Assembly a;
        a.add(painted(lathe_smooth({{0.13, gap},
                                    {width * 0.5, gap + height * 0.24},
                                    {width, gap + height * 0.64},
                                    {width * 0.72, gap + height * 0.92},
                                    {0, gap + height}},
                                   one, 48, 10),
                      [&](Vec3 p, Rgb) {
                          const int panel = static_cast<int>(
                              std::floor((std::atan2(p.z, p.x) / 6.283185307179586 + 1.0 + 1e-6) * panels));
                          return panel % 2 == 0 ? one : two;
                      }));
        a.add(box({0, -0.02, 0}, {0.3, 0.24, 0.3}, 0.05, kTan))
            .add(box({0, 0.1, 0}, {0.34, 0.05, 0.34}, 0.022, kWalnut))
            .add(box({0, -0.1, 0}, {0.31, 0.03, 0.31}, 0.012, kWalnut));
        for (const double x : {-1.0, 1.0})
            a.pair(rod({x * 0.14, 0.1, 0.14}, {x * 0.1, gap + 0.03, 0.1}, 0.012, kCocoa));
        return a.mesh();
    };
    add_model(models, "hot air balloon", "Hot air balloon", balloon(0.55, 1.15, 0.32, 12, kCoral, kCream));
    add_model(models, "hot air balloon", "Round balloon", balloon(0.66, 1.0, 0.26, 8, kTeal, kMustard));
    add_model(models, "hot air balloon", "Tall balloon", balloon(0.46, 1.4, 0.4, 16, kPlum, kPink));
}

}  // namespace

void add_boats(Models& models) {
    add_sailboats(models);
    add_other_boats(models);
}

}  // namespace core::starter
