// Shirts, trousers and socks. They lie flat and face +z.

#include <cmath>

#include "core/starter/kit/assembly.hpp"
#include "core/starter/kit/solid.hpp"
#include "core/starter/kit/sweep.hpp"
#include "core/starter/models/models.hpp"

namespace core::starter {
namespace {

/// The outline from its right half, given from the top's middle round to the bottom's.
std::vector<Point> both_halves(std::vector<Point> right) {
    std::vector<Point> ring(right.rbegin(), right.rend());
    for (const Point p : right)
        if (p.x > 1e-9) ring.push_back({-p.x, p.y});
    return ring;
}

enum class Print { None, Stripes, Dot, Star, Pocket };

struct Shirt {
    double half = 0.36, length = 0.92, flare = 0.02;
    double sleeve = 0.3, drop = 0.24, cuff = 0.26;  ///< reach and fall of the sleeve, width at its end
    double neck = 0.15, dip = 0.1;
    Print print = Print::None;
    Rgb cloth = kRed, trim = kCream;
};

/// A badge on the chest, front and back.
void add_print(Assembly& a, const Shirt& s) {
    const double z = 0.075;
    const auto both_faces = [&](const TriangleMesh& badge) {
        a.add(moved(badge, {0, 0, z})).add(moved(badge, {0, 0, -z}));
    };
    switch (s.print) {
        case Print::None:
            break;
        case Print::Stripes:
            for (int k = 0; k < 4; ++k)
                both_faces(box({0, -s.length * (0.36 + 0.16 * k), 0}, {2 * s.half * 0.96, 0.06, 0.02}, 0.008, s.trim));
            break;
        case Print::Dot:
            both_faces(slab(circle_outline({0, -0.42}, 0.15, 0.15), 0.02, 0.006, s.trim));
            break;
        case Print::Star:
            both_faces(slab(star_outline({0, -0.42}, 5, 0.2, 0.085, 90), 0.02, 0.006, s.trim));
            break;
        case Print::Pocket:
            a.add(moved(slab(rounded_rectangle({0.06, -0.46}, {0.24, -0.26}, 0.03), 0.02, 0.006, s.trim), {0, 0, z}));
            for (int k = 0; k < 3; ++k) a.add(ball({0, -0.2 - 0.12 * k, z + 0.01}, {0.024, 0.024, 0.012}, s.trim, 8));
            break;
    }
}

TriangleMesh shirt(const Shirt& s) {
    const double reach = std::hypot(s.sleeve, s.drop), ex = s.half + s.sleeve, ey = -0.06 - s.drop;
    const Point end{ex, ey}, below{ex - s.cuff * s.drop / reach, ey - s.cuff * s.sleeve / reach};
    const std::vector<Point> right{{0, -s.dip},
                                   {s.neck * 0.6, -s.dip * 0.72},
                                   {s.neck, 0},
                                   {s.half, -0.06},
                                   end,
                                   below,
                                   {s.half, -0.1 - s.cuff - s.drop * 0.35},
                                   {s.half + s.flare, -s.length},
                                   {0, -s.length - 0.01}};
    Assembly a;
    a.add(slab(both_halves(right), 0.15, 0.04, s.cloth));
    a.add(tube({{{-s.neck, 0.0, 0}, 0.035, 0.08},
                {{-s.neck * 0.55, -s.dip * 0.72, 0}, 0.03, 0.085},
                {{0, -s.dip, 0}, 0.03, 0.085},
                {{s.neck * 0.55, -s.dip * 0.72, 0}, 0.03, 0.085},
                {{s.neck, 0.0, 0}, 0.035, 0.08}},
               s.trim));
    const Vec3 from{end.x, end.y, 0}, to{below.x, below.y, 0};
    a.pair_x(tube({{from + (to - from) * 0.08, 0.025, 0.07}, {from + (to - from) * 0.92, 0.025, 0.07}}, s.trim));
    add_print(a, s);
    return a.mesh();
}

void add_shirts(Models& models) {
    add_model(models, "t-shirt", "Red T-shirt", shirt({.print = Print::Dot}));
    add_model(
        models, "t-shirt", "Striped T-shirt",
        shirt({.half = 0.33, .sleeve = 0.34, .drop = 0.14, .print = Print::Stripes, .cloth = kWhite, .trim = kNavy}));
    add_model(models, "t-shirt", "Star T-shirt",
              shirt({.half = 0.4,
                     .length = 0.86,
                     .sleeve = 0.24,
                     .drop = 0.3,
                     .cuff = 0.3,
                     .print = Print::Star,
                     .cloth = kBlue,
                     .trim = kStraw}));
    add_model(models, "t-shirt", "Polo shirt",
              shirt({.half = 0.34,
                     .length = 1.0,
                     .sleeve = 0.36,
                     .drop = 0.2,
                     .neck = 0.13,
                     .dip = 0.07,
                     .print = Print::Pocket,
                     .cloth = kLeaf,
                     .trim = kCream}));
    add_model(models, "t-shirt", "Wide T-shirt",
              shirt({.half = 0.42,
                     .length = 0.8,
                     .flare = 0.08,
                     .sleeve = 0.3,
                     .drop = 0.08,
                     .cuff = 0.32,
                     .neck = 0.2,
                     .dip = 0.16,
                     .cloth = kLilac,
                     .trim = kPlum}));
}

struct Trousers {
    double waist = 0.34, length = 0.9, crotch = 0.28;
    double leg = 0.24, splay = 0.06;  ///< width at the hem; how far the hem lies outside the waist
    bool belt = true, cuffs = false, knees = false;
    Rgb cloth = kBlue, trim = kWalnut;
};

TriangleMesh trousers(const Trousers& t) {
    const double out = t.waist + t.splay, in = out - t.leg;
    Assembly a;
    a.add(slab(both_halves({{0, 0},
                            {t.waist, 0},
                            {t.waist + 0.03, -t.crotch * 0.7},
                            {out, -t.length},
                            {in, -t.length},
                            {0, -t.crotch}}),
               0.17, 0.045, t.cloth));
    if (t.belt) {
        a.add(box({0, -0.045, 0}, {2 * t.waist + 0.03, 0.09, 0.19}, 0.03, t.trim))
            .add(box({0, -0.045, 0.095}, {0.12, 0.1, 0.03}, 0.012, kBrass));
    }
    if (t.cuffs) a.pair_x(box({(out + in) / 2, -t.length + 0.05, 0}, {t.leg + 0.04, 0.1, 0.2}, 0.035, t.trim));
    a.pair_x(tube({{{t.waist * 0.45, -0.1, 0.085}, 0.012},
                   {{t.waist * 0.55, -0.2, 0.085}, 0.012},
                   {{t.waist * 0.98, -0.26, 0.075}, 0.012}},
                  darker(t.cloth), {.sides = 6}))
        .add(rod({0, -0.09, 0.084}, {0, -t.crotch + 0.05, 0.084}, 0.01, darker(t.cloth)));
    if (t.knees)
        a.pair_x(slab(rounded_rectangle({in * 0.5 + out * 0.5 - 0.09 - t.splay * 0.3, -t.length * 0.72},
                                        {in * 0.5 + out * 0.5 + 0.09 - t.splay * 0.3, -t.length * 0.54}, 0.03),
                      0.2, 0.01, t.trim));
    return a.mesh();
}

void add_trousers(Models& models) {
    add_model(models, "pants", "Jeans", trousers({}));
    add_model(models, "pants", "Short trousers",
              trousers({.waist = 0.36,
                        .length = 0.6,
                        .crotch = 0.24,
                        .leg = 0.27,
                        .splay = 0.1,
                        .cloth = kLeaf,
                        .trim = kForest}));
    add_model(models, "pants", "Marching trousers",
              trousers({.waist = 0.26,
                        .length = 0.9,
                        .crotch = 0.22,
                        .leg = 0.22,
                        .splay = 0.26,
                        .cloth = kBrick,
                        .trim = kStraw}));
    add_model(
        models, "pants", "Flared trousers",
        trousers(
            {.waist = 0.28, .length = 1.0, .crotch = 0.3, .leg = 0.3, .splay = 0.2, .cloth = kPlum, .trim = kMustard}));
    add_model(models, "pants", "Pyjama trousers",
              trousers({.waist = 0.36,
                        .length = 0.8,
                        .leg = 0.3,
                        .splay = 0.04,
                        .belt = false,
                        .cuffs = true,
                        .cloth = kSky,
                        .trim = kWhite}));
    add_model(models, "pants", "Patched trousers",
              trousers({.waist = 0.34,
                        .length = 0.75,
                        .crotch = 0.26,
                        .leg = 0.24,
                        .splay = 0.14,
                        .knees = true,
                        .cloth = kTan,
                        .trim = kBrick}));
    add_model(
        models, "pants", "Slim trousers",
        trousers(
            {.waist = 0.28, .length = 1.1, .crotch = 0.3, .leg = 0.19, .splay = 0.03, .cloth = kSlate, .trim = kInk}));
}

struct Sock {
    double leg = 0.75, foot = 0.5, r = 0.17, heel = 0.17, lean = 0.0;
    int stripes = 0;
    Rgb wool = kRed, trim = kWhite;
};

/// The leg comes down from +y, the toes point to +x.
TriangleMesh sock(const Sock& s) {
    const double side = s.r * 0.6;
    Assembly a;
    a.add(painted(tube({{{-s.lean, s.leg, 0}, s.r, side},
                        {{-s.lean * 0.4, s.leg * 0.5, 0}, s.r * 0.95, side},
                        {{0, s.r * 0.6, 0}, s.heel, side * 1.05},
                        {{s.r * 0.75, -s.r * 0.35, 0}, s.heel, side * 1.1},
                        {{s.foot * 0.6, -s.r * 0.5, 0}, s.r * 0.86, side},
                        {{s.foot, -s.r * 0.5, 0}, s.r * 0.84, side}},
                       s.wool, {.sides = 20, .steps = 10, .cap = Cap::Round}),
                  [&](Vec3 p, Rgb c) {
                      if (p.x > s.foot * 0.92) return s.trim;
                      if (s.stripes > 0 && p.y > s.r && std::sin(p.y * s.stripes) > 0.2) return s.trim;
                      return c;
                  }));
    a.add(tube({{{-s.lean * 1.02, s.leg - 0.02, 0}, s.r * 1.08, side * 1.12},
                {{-s.lean * 1.15, s.leg + s.r * 0.75, 0}, s.r * 1.1, side * 1.14}},
               s.trim, {.sides = 20, .cap = Cap::Flat}));
    return a.mesh();
}

void add_socks(Models& models) {
    add_model(models, "sock", "Red sock", sock({}));
    add_model(
        models, "sock", "Striped sock",
        sock({.leg = 0.9, .foot = 0.45, .r = 0.14, .heel = 0.15, .stripes = 26, .wool = kMustard, .trim = kTeal}));
    add_model(models, "sock", "Short sock", sock({.leg = 0.6, .foot = 0.46, .wool = kSky, .trim = kNavy}));
    add_model(models, "sock", "Christmas stocking",
              sock({.leg = 0.7, .foot = 0.42, .r = 0.22, .heel = 0.2, .lean = 0.08, .wool = kBrick, .trim = kCream}));
    add_model(models, "sock", "Knee sock",
              sock({.leg = 1.1,
                    .foot = 0.5,
                    .r = 0.15,
                    .heel = 0.14,
                    .lean = 0.16,
                    .stripes = 14,
                    .wool = kPlum,
                    .trim = kPink}));
}

}  // namespace

void add_clothes(Models& models) {
    add_shirts(models);
    add_trousers(models);
    add_socks(models);
}

}  // namespace core::starter
