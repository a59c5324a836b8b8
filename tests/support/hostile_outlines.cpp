#include "support/hostile_outlines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <utility>

#include "support/shapes.hpp"

namespace support {

namespace {

using core::BinaryImage;
using core::Point;
using core::Polygon;

/// Numbers that every machine draws alike, which the distributions of the standard library do not promise.
class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double share() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
    double between(double low, double high) { return low + (high - low) * share(); }
    int whole(int low, int high) { return low + static_cast<int>(share() * (high - low + 1)); }

  private:
    std::mt19937_64 engine_;
};

Polygon in_circle(int n, const std::function<double(int)>& radius) {
    Polygon ring = disc(n, 1.0);
    for (int i = 0; i < n; ++i) ring[static_cast<std::size_t>(i)] = ring[static_cast<std::size_t>(i)] * radius(i);
    return ring;
}

Polygon random_star(Dice& dice) {
    return in_circle(dice.whole(3, 300), [&](int) { return dice.between(0.02, 40.0); });
}

/// Points anywhere: edges cross each other many times over.
Polygon scribble(Dice& dice) {
    Polygon ring;
    for (int n = dice.whole(3, 200); n > 0; --n) ring.push_back({dice.between(0, 90), dice.between(0, 90)});
    return ring;
}

/// Midpoints are moved again and again.
Polygon coastline(Dice& dice) {
    Polygon ring = rectangle(100, 80);
    double reach = dice.between(5, 40);
    for (int round = 0; round < dice.whole(4, 9); ++round, reach *= 0.55) {
        Polygon finer;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            finer.push_back(ring[i]);
            finer.push_back(midpoint(ring[i], ring[(i + 1) % ring.size()]) +
                            Point{dice.between(-reach, reach), dice.between(-reach, reach)});
        }
        ring = std::move(finer);
    }
    return ring;
}

Polygon band_of_spiral(Dice& dice) {
    const double turns = dice.between(1, 30), gap = dice.between(1.1, 3.0), width = dice.between(0.1, 1.0);
    Polygon outer, inner;
    for (double t = 0.0; t <= turns * 6.28; t += 0.1) {
        const Point along{std::cos(t), std::sin(t)};
        outer.push_back(along * (3.0 + gap * t));
        inner.push_back(along * (3.0 - width + gap * t));
    }
    outer.insert(outer.end(), inner.rbegin(), inner.rend());
    return outer;
}

Polygon hairy_disc(Dice& dice) {
    const int hairs = dice.whole(1, 200);
    return in_circle(6 * hairs, [&](int i) { return i % 6 == 0 ? dice.between(10.0, 60.0) : 10.0; });
}

Polygon needle(Dice& dice) {
    return rectangle(dice.between(50, 5000), dice.between(1e-6, 2.0));
}

/// Every point twice or more, some runs going back and forth.
Polygon stuttering(Dice& dice) {
    Polygon ring;
    for (const Point p : coastline(dice)) {
        for (int n = dice.whole(1, 4); n > 0; --n) ring.push_back(p);
        if (dice.share() < 0.1 && ring.size() > 6) ring.push_back(ring[ring.size() - 6]);
    }
    return ring;
}

/// Two loops that meet in one point, one of them turning the other way.
Polygon figure_of_eight(Dice& dice) {
    Polygon ring;
    const int n = dice.whole(8, 120);
    const double share = dice.between(0.1, 1.0);
    for (int i = 0; i < n; ++i) {
        const double t = 2.0 * std::numbers::pi * i / n;
        ring.push_back({40.0 * std::sin(t), 20.0 * share * std::sin(2.0 * t)});
    }
    return ring;
}

Polygon of_size(Dice& dice, double size) {
    Polygon ring = dice.share() < 0.5 ? horse() : random_star(dice);
    for (Point& p : ring) p = p * size;
    return ring;
}

Polygon far_away(Dice& dice) {
    return moved(horse(), {dice.between(-1e9, 1e9), dice.between(-1e9, 1e9)});
}

Polygon with_one_bad_number(Dice& dice) {
    constexpr std::array kBad{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity(), 1e300, -1e300};
    Polygon ring = random_star(dice);
    Point& p = ring[static_cast<std::size_t>(dice.whole(0, static_cast<int>(ring.size()) - 1))];
    (dice.share() < 0.5 ? p.x : p.y) = kBad[static_cast<std::size_t>(dice.whole(0, 4))];
    return ring;
}

Polygon few_points(Dice& dice) {
    Polygon ring;
    for (int n = dice.whole(0, 4); n > 0; --n) ring.push_back({dice.between(-9, 9), dice.between(-9, 9)});
    return ring;
}

Polygon all_on_a_line(Dice& dice) {
    Polygon ring;
    const Point along{dice.between(-3, 3), dice.between(-3, 3)};
    for (int n = dice.whole(3, 90); n > 0; --n) ring.push_back(along * dice.between(-10, 10));
    return ring;
}

/// Exactly even: every choice between equals is open.
Polygon symmetric(Dice& dice) {
    switch (dice.whole(0, 4)) {
        case 0:
            return star(dice.whole(2, 90), dice.between(5, 50), dice.between(0.1, 5));
        case 1:
            return cross(dice.between(2, 50), dice.between(0.05, 2));
        case 2:
            return disc(dice.whole(3, 400), dice.between(0.5, 200));
        case 3:
            return comb(dice.whole(1, 200), dice.between(0.5, 300));
        default:
            return rectangle(dice.between(1, 9), dice.between(1, 9));
    }
}

Polygon backwards(Dice& dice) {
    Polygon ring = dice.share() < 0.5 ? hand() : coastline(dice);
    std::reverse(ring.begin(), ring.end());
    return ring;
}

/// Corners that are nearly none, thin gaps that are nearly closed.
Polygon near_misses(Dice& dice) {
    const double gap = std::pow(10.0, dice.between(-12, 0));
    Polygon ring{{0, 0}, {40, 0}, {40, 30}, {20 + gap, 30}, {20, gap}, {20 - gap, 30}, {0, 30}};
    for (Point& p : ring) p = p + Point{dice.between(-gap, gap), dice.between(-gap, gap)};
    return ring;
}

// ---- pictures

BinaryImage noise(Dice& dice) {
    BinaryImage image(dice.whole(1, 90), dice.whole(1, 90));
    const double ink = dice.share();
    for (auto& pixel : image.pixels) pixel = dice.share() < ink ? 1 : 0;
    return image;
}

void draw_line(BinaryImage& image, Point from, Point to, double radius) {
    const int steps = 2 + static_cast<int>(2.0 * distance(from, to));
    for (int i = 0; i <= steps; ++i) {
        const Point p = from + (to - from) * (static_cast<double>(i) / steps);
        for (int y = static_cast<int>(p.y - radius); y <= static_cast<int>(p.y + radius); ++y) {
            for (int x = static_cast<int>(p.x - radius); x <= static_cast<int>(p.x + radius); ++x) {
                if (x >= 0 && y >= 0 && x < image.width && y < image.height) image.at(x, y) = 1;
            }
        }
    }
}

BinaryImage lines(Dice& dice, double radius) {
    BinaryImage image(dice.whole(8, 300), dice.whole(8, 300));
    const auto anywhere = [&] { return Point{dice.between(0, image.width), dice.between(0, image.height)}; };
    Point from = anywhere();
    for (int n = dice.whole(1, 25); n > 0; --n) {
        const Point to = anywhere();
        draw_line(image, from, to, radius);
        if (dice.share() < 0.9) from = to;
    }
    return image;
}

BinaryImage checkers(Dice& dice) {
    BinaryImage image(dice.whole(2, 120), dice.whole(2, 120));
    const int cell = dice.whole(1, 9);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) image.at(x, y) = (x / cell + y / cell) % 2 == 0 ? 1 : 0;
    }
    return image;
}

BinaryImage full(Dice& dice) {
    BinaryImage image(dice.whole(1, 400), dice.whole(1, 400));
    std::fill(image.pixels.begin(), image.pixels.end(), std::uint8_t{1});
    return image;
}

BinaryImage crumbs(Dice& dice) {
    BinaryImage image(dice.whole(20, 200), dice.whole(20, 200));
    for (int n = dice.whole(1, 30); n > 0; --n) {
        const Point p{dice.between(0, image.width), dice.between(0, image.height)};
        draw_line(image, p, p, dice.between(0, 12));
    }
    return image;
}

using RingKind = std::pair<const char*, Polygon (*)(Dice&)>;
using ImageKind = std::pair<const char*, BinaryImage (*)(Dice&)>;

constexpr std::array<RingKind, 18> kRings{{
    {"random star", random_star},
    {"scribble", scribble},
    {"coastline", coastline},
    {"spiral", band_of_spiral},
    {"hairy disc", hairy_disc},
    {"needle", needle},
    {"stuttering", stuttering},
    {"figure of eight", figure_of_eight},
    {"tiny", [](Dice& d) { return of_size(d, 1e-9); }},
    {"huge", [](Dice& d) { return of_size(d, 1e9); }},
    {"far away", far_away},
    {"one bad number", with_one_bad_number},
    {"few points", few_points},
    {"on a line", all_on_a_line},
    {"symmetric", symmetric},
    {"backwards", backwards},
    {"near misses", near_misses},
    {"coastline again", coastline},
}};
constexpr std::array<ImageKind, 6> kImages{{
    {"noise", noise},
    {"hairlines", [](Dice& d) { return lines(d, 0.0); }},
    {"thick lines", [](Dice& d) { return lines(d, 4.0); }},
    {"checkers", checkers},
    {"full page", full},
    {"crumbs", crumbs},
}};
static_assert(kRings.size() + kImages.size() == kHostileKinds);

}  // namespace

HostileOutline hostile_outline(unsigned number) {
    Dice dice(number);
    const std::size_t kind = number % kHostileKinds;
    if (kind < kRings.size()) return {kRings[kind].first, kRings[kind].second(dice), {}};
    const ImageKind& image = kImages[kind - kRings.size()];
    return {image.first, {}, image.second(dice)};
}

}  // namespace support
