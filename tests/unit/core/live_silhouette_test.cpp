#include "core/silhouette/live_silhouette.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <random>

#include "core/exchange/sketch_reader.hpp"

using core::Drawing;
using core::Point;
using core::Stroke;

namespace {

Stroke stroke(const std::vector<Point>& points) {
    Stroke result;
    for (const Point p : points) result.samples.push_back({0, p.x, p.y, 1.0});
    return result;
}

Stroke arc(Point centre, double radius, double from, double to, int count = 40) {
    std::vector<Point> points;
    for (int i = 0; i <= count; ++i) {
        const double angle = (from + (to - from) * i / count) * std::numbers::pi / 180.0;
        points.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
    }
    return stroke(points);
}

/// The same pixels, at the same place, or the same error.
bool same(const core::Result<core::Silhouette>& a, const core::Result<core::Silhouette>& b) {
    if (!a || !b) return !a && !b && a.error().code == b.error().code && a.error().message == b.error().message;
    return a->image.width == b->image.width && a->image.height == b->image.height &&
           a->image.pixels == b->image.pixels && a->raster.scale == b->raster.scale &&
           a->raster.offset == b->raster.offset;
}

/// Follows the drawing sample by sample and counts steps at which the whole is not the same. Looks at every `every`-th.
int differing_steps(core::LiveSilhouette& live, const Drawing& whole, int every,
                    const core::SilhouetteOptions& options = {}) {
    Drawing so_far;
    int wrong = 0, step = 0;
    for (const Stroke& s : whole.strokes) {
        so_far.strokes.emplace_back();
        for (const core::PenSample& sample : s.samples) {
            so_far.strokes.back().samples.push_back(sample);
            live.follow(so_far);
            if (step++ % every == 0 && !same(live.silhouette(), core::find_silhouette(so_far, options))) ++wrong;
        }
    }
    if (!same(live.silhouette(), core::find_silhouette(whole, options))) ++wrong;
    return wrong;
}

/// Strokes of a hand that wanders: loops, near misses, dots, far marks.
Drawing wandering(unsigned seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random()) / 4294967296.0; };
    Drawing d;
    const int strokes = 2 + static_cast<int>(random() % 5);
    for (int s = 0; s < strokes; ++s) {
        Point at{uniform(-100, 100), uniform(-80, 80)};
        double heading = uniform(0, 6.28);
        const double turn = uniform(-0.5, 0.5), stride = uniform(2, 25);
        std::vector<Point> points{at};
        for (int i = static_cast<int>(random() % 14); i > 0; --i) {
            heading += turn + uniform(-0.3, 0.3);
            at = at + Point{std::cos(heading), std::sin(heading)} * stride;
            points.push_back(at);
        }
        if (random() % 3 == 0) points.push_back(points.front());
        d.strokes.push_back(stroke(points));
    }
    if (random() % 3 == 0) d.strokes.push_back(stroke({{uniform(400, 900), 500}, {uniform(400, 900), 505}}));
    return d;
}

}  // namespace

TEST_CASE("a loop is filled with the sample that closes it, and opens again when that is undone", "[live silhouette]") {
    core::LiveSilhouette live;
    Drawing d{{arc({0, 0}, 50, 0, 300)}};
    live.follow(d);
    const auto open = live.silhouette();
    REQUIRE(open);
    const auto inside = [&] {
        const auto s = live.silhouette();
        const Point p = s->raster.to_raster({0, 0});
        return s->image.at(static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))) == 1;
    };
    CHECK_FALSE(inside());
    const Drawing before = d;
    d.strokes.push_back(arc({0, 0}, 50, 300, 360));
    live.follow(d);
    CHECK(inside());
    live.follow(before);
    CHECK(same(live.silhouette(), open));
}

TEST_CASE("drawn sample by sample it is the silhouette of the whole, at every step", "[live silhouette]") {
    for (unsigned seed = 1; seed <= 15; ++seed) {
        DYNAMIC_SECTION("wandering " << seed) {
            core::LiveSilhouette live;
            CHECK(differing_steps(live, wandering(seed), 3) == 0);
        }
    }
}

TEST_CASE("one that followed another drawing before follows the next as if it were new", "[live silhouette]") {
    core::LiveSilhouette live;
    for (unsigned seed = 30; seed < 33; ++seed) CHECK(differing_steps(live, wandering(seed), 6) == 0);
    live.follow({});
    CHECK(live.silhouette().error().code == core::ErrorCode::EmptyDrawing);
    CHECK(differing_steps(live, wandering(34), 6) == 0);
}

TEST_CASE("erasing and undo in any order give back exactly what was", "[live silhouette]") {
    std::mt19937 random(5);
    const Drawing all = wandering(8);
    Drawing now;
    core::LiveSilhouette live;
    for (int step = 0; step < 12; ++step) {
        if (now.strokes.size() > 1 && random() % 2 == 0) {
            now.strokes.erase(now.strokes.begin() + static_cast<std::ptrdiff_t>(random() % now.strokes.size()));
        } else {
            now.strokes.push_back(all.strokes[random() % all.strokes.size()]);
        }
        live.follow(now);
        CHECK(same(live.silhouette(), core::find_silhouette(now, {})));
    }
}

TEST_CASE("other options are kept to as well", "[live silhouette]") {
    core::SilhouetteOptions wide, tight;
    wide.closing_share *= 2.5;
    wide.joining_share *= 2.5;
    tight.closing_share /= 3;
    tight.joining_share = 0;
    for (const core::SilhouetteOptions& options : {wide, tight}) {
        core::LiveSilhouette live(options);
        CHECK(differing_steps(live, wandering(11), 5, options) == 0);
        CHECK(differing_steps(live, wandering(12), 5, options) == 0);
    }
}

TEST_CASE("odd drawings: nothing, dots, empty strokes, one line, huge and tiny units", "[live silhouette]") {
    core::LiveSilhouette live;
    CHECK(live.silhouette().error().code == core::ErrorCode::EmptyDrawing);
    const std::vector<Drawing> odd{{{stroke({{5, 5}})}},
                                   {{stroke({{5, 5}, {5, 5}})}},
                                   {{Stroke{}, stroke({{0, 0}, {10, 0}}), Stroke{}}},
                                   {{stroke({{5, 5}}), stroke({{9, 5}})}},
                                   {{stroke({{0, 0}, {1e9, 2e9}, {-1e9, 1e9}})}},
                                   {{stroke({{0, 0}, {1e-6, 2e-6}, {3e-6, 0}, {0, 0}})}},
                                   {{stroke({{1e12, 1e12}, {1e12 + 5, 1e12}})}}};
    for (const Drawing& d : odd) {
        live.follow(d);
        CHECK(same(live.silhouette(), core::find_silhouette(d, {})));
    }
}

TEST_CASE("a drawing that grows steadily is seldom made anew", "[live silhouette]") {
    core::LiveSilhouette live;
    Drawing d{{Stroke{}}};
    for (int i = 0; i < 400; ++i) {
        const double angle = i * 0.05, radius = 1 + 0.25 * i;
        d.strokes[0].samples.push_back({0, radius * std::cos(angle), radius * std::sin(angle), 1.0});
        live.follow(d);
    }
    CHECK(same(live.silhouette(), core::find_silhouette(d, {})));
    CHECK(live.rebuilds() < 60);
    const std::uint64_t before = live.rebuilds();
    live.follow(d);  // nothing new
    CHECK(live.rebuilds() == before);
}

TEST_CASE("the drawings of the replay folder, at steps through all of them", "[live silhouette]") {
    int drawings = 0;
    for (const auto& entry : std::filesystem::directory_iterator(CROQUIS_SOURCE_DIR "/tests/replay")) {
        const auto sketch = core::read_sketch((entry.path() / "drawing.ndjson").string());
        if (!sketch || !sketch->drawing) continue;
        core::LiveSilhouette live;
        CHECK(differing_steps(live, *sketch->drawing, 60) == 0);
        ++drawings;
    }
    CHECK(drawings >= 4);
}
