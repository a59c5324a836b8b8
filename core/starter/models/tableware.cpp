// Mugs, teapots, glasses, bottles, pans and cutlery.

#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// A turned vessel: the outer profile from the foot's axis to the rim, and a wall of the given thickness.
TriangleMesh vessel(const std::vector<Point>& outside, double wall, Rgb colour, int steps = 6) {
    std::vector<Point> profile = spline(outside, steps);
    const double floor = profile.front().y + wall;
    for (std::size_t i = profile.size(); i-- > 0;) {
        const Point p{profile[i].x - wall, std::max(profile[i].y, floor)};
        if (p.x <= 0.0) break;
        if (p.y > floor || i == 0) profile.push_back(p);
    }
    if (profile.back().y > floor) profile.push_back({profile.back().x * 0.9, floor});
    profile.insert(profile.begin(), {0.0, outside.front().y});
    return lathe(profile, colour, 36);
}

/// A handle in the xy plane between two points of a vessel's wall at +x.
TriangleMesh handle(double x_low, double y_low, double x_high, double y_high, double reach, double r, Rgb colour) {
    return tube({{{x_low - r, y_low, 0}, r},
                 {{x_low + reach * 0.7, y_low + (y_high - y_low) * 0.08, 0}, r},
                 {{std::max(x_low, x_high) + reach, (y_low + y_high) / 2 + 0.02, 0}, r * 1.05},
                 {{x_high + reach * 0.75, y_high, 0}, r},
                 {{x_high - r, y_high, 0}, r}},
                colour, {.sides = 14, .steps = 8});
}

TriangleMesh filled(TriangleMesh cup, double r, double y, Rgb drink) {
    join(cup, lathe({{0, y - 0.02}, {r, y - 0.02}, {r, y}, {0, y}}, drink, 36));
    return cup;
}

void add_mugs(Models& models) {
    const auto mug = [](const std::vector<Point>& outside, double low, double high, double reach, double r, Rgb colour,
                        Rgb drink, double level, double drink_r) {
        TriangleMesh m = filled(vessel(outside, 0.045, colour), drink_r, level, drink);
        double x_low = 0.4, x_high = 0.4;
        for (const Point p : spline(outside, 12)) {
            if (p.y <= low) x_low = p.x;
            if (p.y <= high) x_high = p.x;
        }
        join(m, handle(x_low, low, x_high, high, reach, r, lighter(colour, 0.15)));
        return scaled(m, {1.0, 1.0, 0.75});
    };
    add_model(models, "mug", "Mug",
              mug({{0.38, 0}, {0.4, 0.02}, {0.4, 0.5}, {0.4, 0.9}}, 0.2, 0.72, 0.26, 0.05, kCoral, kCocoa, 0.78, 0.37));
    add_model(models, "mug", "Round mug",
              mug({{0.25, 0}, {0.4, 0.15}, {0.47, 0.4}, {0.42, 0.65}, {0.38, 0.78}}, 0.2, 0.62, 0.2, 0.055, kTeal,
                  kHoney, 0.68, 0.37));
    add_model(
        models, "mug", "Tall mug",
        mug({{0.3, 0}, {0.31, 0.3}, {0.34, 0.7}, {0.42, 1.15}}, 0.3, 0.92, 0.22, 0.042, kMustard, kCocoa, 1.0, 0.35));
    add_model(
        models, "mug", "Camping mug",
        mug({{0.46, 0}, {0.48, 0.04}, {0.48, 0.4}, {0.5, 0.66}}, 0.14, 0.54, 0.3, 0.035, kNavy, kWalnut, 0.55, 0.45));
    add_model(models, "mug", "Farmhouse mug",
              mug({{0.44, 0}, {0.42, 0.1}, {0.34, 0.45}, {0.36, 0.8}, {0.42, 0.98}}, 0.2, 0.76, 0.3, 0.06, kCream,
                  kBrick, 0.84, 0.33));
    add_model(models, "mug", "Teacup",
              mug({{0.2, 0}, {0.34, 0.16}, {0.46, 0.42}, {0.5, 0.6}}, 0.18, 0.5, 0.22, 0.04, kSky, kHoney, 0.5, 0.44));
    add_model(models, "mug", "Espresso cup",
              mug({{0.22, 0}, {0.3, 0.1}, {0.36, 0.4}, {0.38, 0.62}}, 0.16, 0.5, 0.2, 0.042, kWhite, kInk, 0.52, 0.33));
    add_model(
        models, "mug", "Straight mug",
        mug({{0.4, 0}, {0.41, 0.03}, {0.41, 0.5}, {0.41, 0.86}}, 0.34, 0.64, 0.13, 0.05, kLeaf, kCocoa, 0.76, 0.36));
    add_model(
        models, "mug", "Broad-based mug",
        mug({{0.47, 0}, {0.46, 0.05}, {0.4, 0.4}, {0.34, 0.74}}, 0.22, 0.52, 0.15, 0.05, kBlue, kHoney, 0.66, 0.28));
    add_model(
        models, "mug", "Square mug",
        mug({{0.42, 0}, {0.44, 0.03}, {0.44, 0.4}, {0.44, 0.72}}, 0.26, 0.6, 0.14, 0.06, kLilac, kCocoa, 0.64, 0.39));
    add_model(
        models, "mug", "Slim mug",
        mug({{0.29, 0}, {0.3, 0.03}, {0.3, 0.5}, {0.3, 0.98}}, 0.44, 0.72, 0.1, 0.045, kRose, kCocoa, 0.88, 0.25));
    TriangleMesh cocoa =
        mug({{0.2, 0}, {0.34, 0.1}, {0.42, 0.36}, {0.43, 0.78}}, 0.24, 0.64, 0.17, 0.05, kBrick, kCocoa, 0.74, 0.38);
    join(cocoa, scaled(lathe_smooth({{0, 0.72}, {0.38, 0.74}, {0.34, 0.84}, {0.18, 0.9}, {0, 0.91}}, kCream, 32),
                       {1, 1, 0.75}));
    add_model(models, "mug", "Cocoa with cream", cocoa);
    TriangleMesh beer =
        mug({{0.36, 0}, {0.38, 0.03}, {0.37, 0.5}, {0.36, 1.0}}, 0.26, 0.82, 0.2, 0.06, kMustard, kCream, 0.98, 0.32);
    join(beer, scaled(lathe_smooth({{0, 0.95}, {0.38, 0.95}, {0.4, 1.03}, {0.26, 1.12}, {0, 1.13}}, kWhite, 32),
                      {1, 1, 0.75}));
    add_model(models, "mug", "Beer mug", beer);
}

struct Teapot {
    std::vector<Point> body{{0.28, 0}, {0.46, 0.14}, {0.52, 0.44}, {0.4, 0.74}, {0.22, 0.84}};
    double spout_low = 0.25, spout_high = 0.84, spout_reach = 0.46;
    bool hoop = false;  ///< a handle over the lid
    bool bare = false;  ///< no handle, like a lamp that a genie lives in
    Rgb colour = kTeal, accent = kBrass;
};

TriangleMesh teapot(const Teapot& t) {
    Assembly a;
    std::vector<Point> body = t.body;
    body.insert(body.begin(), {0.0, body.front().y});
    const double top = t.body.back().y, rim = t.body.back().x;
    double side = 0.0;
    for (const Point p : t.body) side = std::max(side, p.x);
    a.add(lathe(spline(t.body, 8), t.colour, 40));
    a.add(moved(
        lathe_smooth({{rim * 1.08, -0.02}, {rim * 1.02, 0.03}, {rim * 0.6, 0.1}, {0.04, 0.13}}, lighter(t.colour), 36),
        {0, top, 0}));
    a.add(ball({0, top + 0.17, 0}, 0.06, t.accent));
    a.add(tube({{{side * 0.8, t.spout_low, 0}, 0.13},
                {{side + t.spout_reach * 0.35, t.spout_low + 0.1, 0}, 0.1},
                {{side + t.spout_reach * 0.6, (t.spout_low + t.spout_high) / 2 + 0.08, 0}, 0.065},
                {{side + t.spout_reach, t.spout_high, 0}, 0.05}},
               t.colour, {.sides = 16, .cap = Cap::Flat}));
    a.add(rod({side + t.spout_reach * 0.99, t.spout_high, 0}, {side + t.spout_reach + 0.012, t.spout_high + 0.012, 0},
              0.034, kInk, Cap::Flat));
    if (t.hoop)
        a.add(tube({{{-side * 0.75, top * 0.75, 0}, 0.035},
                    {{-side * 0.72, top + 0.3, 0}, 0.035},
                    {{0, top + 0.55, 0}, 0.045},
                    {{side * 0.72, top + 0.3, 0}, 0.035},
                    {{side * 0.75, top * 0.75, 0}, 0.035}},
                   t.accent, {.steps = 10}));
    else if (!t.bare)
        a.add(mirrored_x(handle(side * 0.9, top * 0.28, side * 0.75, top * 0.82, 0.3, 0.05, t.accent)));
    return scaled(a.mesh(), {1.0, 1.0, 0.45});  // flat: spout and handle are what one sees
}

void add_teapots(Models& models) {
    add_model(models, "teapot", "Teapot", teapot({}));
    add_model(models, "teapot", "Tall coffee pot",
              teapot({.body = {{0.3, 0}, {0.4, 0.12}, {0.38, 0.5}, {0.28, 0.9}, {0.22, 1.05}},
                      .spout_low = 0.35,
                      .spout_high = 1.0,
                      .spout_reach = 0.4,
                      .colour = kBrick,
                      .accent = kBrick}));
    add_model(models, "teapot", "Iron kettle",
              teapot({.body = {{0.4, 0}, {0.6, 0.08}, {0.64, 0.28}, {0.5, 0.45}, {0.28, 0.52}},
                      .spout_low = 0.2,
                      .spout_high = 0.5,
                      .spout_reach = 0.32,
                      .hoop = true,
                      .colour = kSlate,
                      .accent = kWalnut}));
    add_model(models, "teapot", "Round teapot",
              teapot({.body = {{0.22, 0}, {0.44, 0.14}, {0.5, 0.46}, {0.38, 0.76}, {0.2, 0.86}},
                      .spout_low = 0.3,
                      .spout_high = 0.86,
                      .spout_reach = 0.46,
                      .colour = kRed,
                      .accent = kInk}));
    add_model(models, "teapot", "Kettle",
              teapot({.body = {{0.5, 0}, {0.55, 0.05}, {0.5, 0.4}, {0.34, 0.66}, {0.24, 0.7}},
                      .spout_low = 0.2,
                      .spout_high = 0.8,
                      .spout_reach = 0.4,
                      .colour = kMint,
                      .accent = kSlate}));
    add_model(models, "teapot", "Little teapot",
              teapot({.body = {{0.26, 0}, {0.42, 0.12}, {0.46, 0.38}, {0.36, 0.62}, {0.2, 0.7}},
                      .spout_low = 0.2,
                      .spout_high = 0.66,
                      .spout_reach = 0.4,
                      .colour = kCream,
                      .accent = kRose}));
    add_model(models, "teapot", "Whistling kettle",
              teapot({.body = {{0.46, 0}, {0.5, 0.05}, {0.46, 0.32}, {0.3, 0.52}, {0.2, 0.56}},
                      .spout_low = 0.3,
                      .spout_high = 0.66,
                      .spout_reach = 0.3,
                      .hoop = true,
                      .colour = kSky,
                      .accent = kInk}));
    add_model(models, "teapot", "Genie's teapot",
              teapot({.body = {{0.24, 0}, {0.46, 0.16}, {0.5, 0.36}, {0.38, 0.54}, {0.2, 0.6}},
                      .spout_low = 0.2,
                      .spout_high = 0.62,
                      .spout_reach = 0.5,
                      .bare = true,
                      .colour = kBrass,
                      .accent = kWine}));
    add_model(models, "teapot", "Enamel coffee pot",
              teapot({.body = {{0.44, 0}, {0.45, 0.04}, {0.42, 0.4}, {0.36, 0.76}, {0.3, 0.8}},
                      .spout_low = 0.54,
                      .spout_high = 0.86,
                      .spout_reach = 0.24,
                      .colour = kBlue,
                      .accent = kNavy}));
    add_model(models, "teapot", "Long-spouted teapot",
              teapot({.body = {{0.36, 0}, {0.42, 0.06}, {0.42, 0.34}, {0.32, 0.54}, {0.2, 0.58}},
                      .spout_low = 0.14,
                      .spout_high = 0.52,
                      .spout_reach = 0.62,
                      .colour = kPlum,
                      .accent = kMustard}));
}

void add_glasses(Models& models) {
    const auto goblet = [](double bowl, double bowl_height, double stem, Rgb wine, double pinch) {
        TriangleMesh m = lathe(spline({{0.3, 0},
                                       {0.28, 0.03},
                                       {0.06, 0.08},
                                       {0.035, stem * 0.5},
                                       {0.04, stem},
                                       {bowl * 0.7, stem + bowl_height * 0.18},
                                       {bowl, stem + bowl_height * 0.5},
                                       {bowl * pinch, stem + bowl_height}},
                                      6),
                               kGlass, 36);
        const double from = stem + bowl_height * 0.1, to = stem + bowl_height * 0.62;
        return painted(m, [=](Vec3 p, Rgb c) { return p.y > from && p.y < to ? wine : c; });
    };
    add_model(models, "wine glass", "Red wine glass", goblet(0.34, 0.62, 0.62, kWine, 0.78));
    add_model(models, "wine glass", "White wine glass", goblet(0.26, 0.6, 0.55, kStraw, 0.85));
    add_model(models, "wine glass", "Champagne flute", goblet(0.17, 0.85, 0.5, kMustard, 0.95));
    add_model(models, "wine glass", "Balloon glass", goblet(0.44, 0.62, 0.34, kHoney, 0.62));
    add_model(models, "wine glass", "Goblet", goblet(0.34, 0.5, 0.4, kPlum, 1.05));

    const auto bottle = [](double r, double body, double shoulder, double neck, Rgb glass, Rgb label, Rgb cap) {
        Assembly a;
        a.add(lathe(spline({{r * 0.96, 0},
                            {r, 0.03},
                            {r, body * 0.5},
                            {r, body},
                            {r * 0.75, body + shoulder * 0.6},
                            {0.1, body + shoulder},
                            {0.09, body + shoulder + neck * 0.6},
                            {0.09, body + shoulder + neck}},
                           5),
                    glass, 32));
        a.add(
            lathe({{0, body * 0.25}, {r + 0.006, body * 0.25}, {r + 0.006, body * 0.82}, {0, body * 0.82}}, label, 32));
        a.add(lathe({{0, body + shoulder + neck * 0.62},
                     {0.105, body + shoulder + neck * 0.62},
                     {0.105, body + shoulder + neck + 0.02},
                     {0, body + shoulder + neck + 0.02}},
                    cap, 24));
        return a.mesh();
    };
    add_model(models, "wine bottle", "Wine bottle", bottle(0.27, 0.8, 0.22, 0.38, kForest, kCream, kWine));
    add_model(models, "wine bottle", "Burgundy bottle", bottle(0.32, 0.55, 0.42, 0.3, kOlive, kIvory, kBrass));
    add_model(models, "wine bottle", "Hock bottle", bottle(0.22, 0.7, 0.6, 0.3, kTeal, kWhite, kNavy));
    add_model(models, "wine bottle", "Stout bottle", bottle(0.36, 0.62, 0.2, 0.28, kChestnut, kMustard, kInk));
    add_model(models, "wine bottle", "Round flask", bottle(0.42, 0.42, 0.3, 0.36, kLeaf, kCream, kWalnut));
    add_model(models, "wine bottle", "Broad bottle", bottle(0.46, 0.62, 0.3, 0.34, kForest, kSand, kRed));
    add_model(models, "wine bottle", "Long-necked bottle", bottle(0.26, 0.56, 0.2, 0.56, kNavy, kSky, kBrass));
    add_model(models, "wine bottle", "Magnum", bottle(0.36, 0.74, 0.18, 0.3, kOlive, kCream, kInk));
}

void add_cutlery(Models& models) {
    const auto grip = [](double length, double wide, Rgb colour) {
        return tube({{{0, 0.1, 0}, 0.028, 0.022},
                     {{0, -length * 0.4, 0}, wide * 0.75, 0.024},
                     {{0, -length * 0.85, 0}, wide, 0.026},
                     {{0, -length, 0}, wide * 0.8, 0.024}},
                    colour);
    };
    const auto fork = [&](int tines, double tine_length, double width, double length, Rgb metal, Rgb grip_colour) {
        Assembly a;
        a.add(grip(length, 0.06, grip_colour))
            .add(slab(closed_spline({{0.028, 0.05},
                                     {0.035, 0.16},
                                     {width, 0.3},
                                     {width, 0.42},
                                     {-width, 0.42},
                                     {-width, 0.3},
                                     {-0.035, 0.16},
                                     {-0.028, 0.05}},
                                    5),
                      0.05, 0.015, metal));
        for (int k = 0; k < tines; ++k) {
            const double x = (k / (tines - 1.0) - 0.5) * 2.0 * (width - 0.02);
            a.add(tube({{{x, 0.36, 0}, 0.026, 0.022},
                        {{x, 0.4 + tine_length * 0.6, 0}, 0.022, 0.02},
                        {{x, 0.4 + tine_length, 0}, 0.008}},
                       metal));
        }
        return a.mesh();
    };
    add_model(models, "fork", "Fork", fork(4, 0.36, 0.18, 0.85, kSteel, kSteel));
    add_model(models, "fork", "Dessert fork", fork(3, 0.34, 0.17, 0.7, kBrass, kBrass));
    add_model(models, "fork", "Carving fork", fork(2, 0.55, 0.12, 0.9, kSteel, kWalnut));
    add_model(models, "fork", "Picnic fork", fork(3, 0.38, 0.22, 0.6, kCoral, kCoral));
    add_model(models, "fork", "Wooden-handled fork", fork(4, 0.3, 0.18, 1.15, kSteel, kHoney));
    const auto spoon = [&](double wide, double high, double length, double broad, Rgb metal, Rgb grip_colour) {
        Assembly a;
        a.add(grip(length, broad, grip_colour))
            .add(tube({{{0, 0, 0}, 0.034, 0.025}, {{0, 0.2, 0}, 0.05, 0.03}}, metal));
        a.add(ball({0, 0.16 + high, 0}, {wide, high, 0.06}, metal, 16))
            .add(ball({0, 0.16 + high, 0.035}, {wide * 0.8, high * 0.82, 0.035}, darker(metal, 0.15), 14));
        return a.mesh();
    };
    add_model(models, "spoon", "Spoon", spoon(0.2, 0.3, 0.85, 0.07, kSteel, kSteel));
    add_model(models, "spoon", "Soup spoon", spoon(0.28, 0.32, 0.75, 0.075, kBrass, kBrass));
    add_model(models, "spoon", "Wooden spoon", spoon(0.18, 0.26, 1.2, 0.05, kHoney, kHoney));
    add_model(models, "spoon", "Dessert spoon", spoon(0.24, 0.38, 0.7, 0.09, kSlate, kRed));
    add_model(models, "spoon", "Baby spoon", spoon(0.19, 0.25, 0.5, 0.085, kSteel, kMint));
}

void add_pans(Models& models) {
    const auto pan = [](double r, double depth, double grip, Rgb metal, Rgb handle_colour, bool egg) {
        Assembly a;
        a.add(vessel({{r * 0.8, 0}, {r * 0.86, 0.02}, {r * 0.95, depth * 0.6}, {r, depth}}, 0.035, metal));
        a.add(tube({{{r * 0.95, depth * 0.75, 0}, 0.03, 0.05},
                    {{r + grip * 0.3, depth * 0.9, 0}, 0.03, 0.045},
                    {{r + grip * 0.4, depth, 0}, 0.042, 0.065},
                    {{r + grip, depth * 1.2, 0}, 0.04, 0.07}},
                   handle_colour));
        if (egg) {
            const std::vector<Point> white =
                closed_spline({{0.3, 0.05}, {0.1, 0.28}, {-0.22, 0.2}, {-0.3, -0.08}, {-0.05, -0.25}, {0.2, -0.22}}, 5);
            a.add(moved(turned_x(slab(white, 0.04, 0.015, kWhite), -90), {0, 0.06, 0}));
            a.add(ball({0, 0.09, 0}, {0.1, 0.06, 0.1}, kMustard));
        }
        return turned_x(scaled(a.mesh(), {1.0, 0.7, 1.0}), 72);
    };
    add_model(models, "frying pan", "Frying pan", pan(0.5, 0.12, 0.8, kInk, kWalnut, true));
    add_model(models, "frying pan", "Copper pan", pan(0.46, 0.24, 0.75, kHoney, kBrass, false));
    add_model(models, "frying pan", "Crepe pan", pan(0.58, 0.06, 0.7, kSlate, kInk, false));
    add_model(models, "frying pan", "Red skillet", pan(0.48, 0.14, 0.5, kRed, kRed, true));
    add_model(models, "frying pan", "Small egg pan", pan(0.4, 0.13, 0.95, kTeal, kHoney, true));
}

}  // namespace

void add_tableware(Models& models) {
    add_mugs(models);
    add_teapots(models);
    add_glasses(models);
    add_cutlery(models);
    add_pans(models);
}

}  // namespace core::starter
