// Sailboats and hot air balloons: what the wind carries.

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
    add_model(
        models, "sailboat", "Toy boat",
        sloop({.length = 1.5, .height = 0.42, .width = 0.4, .bow = 0.16, .stern = 0.16, .sheer = 0.04, .side = kTeal},
              1.1, 0.5, 0.0, kStraw, kStraw, false));
    add_model(models, "sailboat", "Fishing boat",
              sloop({.length = 1.7,
                     .height = 0.4,
                     .width = 0.42,
                     .bow = 0.26,
                     .stern = 0.12,
                     .sheer = 0.12,
                     .side = kBrick,
                     .stripe = kCream},
                    0.95, 0.5, 0.4, kCream, kCream, false));
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

void add_balloons(Models& models) {
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
        a.add(box({0, -0.02, 0}, {0.36, 0.28, 0.36}, 0.05, kTan))
            .add(box({0, 0.1, 0}, {0.4, 0.05, 0.4}, 0.022, kWalnut))
            .add(box({0, -0.1, 0}, {0.37, 0.03, 0.37}, 0.012, kWalnut));
        for (const double x : {-1.0, 1.0})
            a.pair(rod({x * 0.17, 0.1, 0.17}, {x * 0.12, gap + 0.03, 0.1}, 0.014, kCocoa));
        return scaled(a.mesh(), {1.0, 1.0, 0.75});
    };
    add_model(models, "hot air balloon", "Hot air balloon", balloon(0.55, 1.15, 0.32, 12, kCoral, kCream));
    add_model(models, "hot air balloon", "Round balloon", balloon(0.66, 1.0, 0.26, 8, kTeal, kMustard));
    add_model(models, "hot air balloon", "Tall balloon", balloon(0.46, 1.4, 0.4, 16, kPlum, kPink));
    add_model(models, "hot air balloon", "Small balloon", balloon(0.5, 0.92, 0.2, 8, kLeaf, kStraw));
    add_model(models, "hot air balloon", "Great balloon", balloon(0.72, 1.3, 0.3, 16, kNavy, kSky));
}

}  // namespace

void add_sailboats_and_balloons(Models& models) {
    add_sailboats(models);
    add_balloons(models);
}

}  // namespace core::starter
