#include "tests/support/figures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
#include <utility>

#include "core/geometry/polygon.hpp"

namespace test {
namespace {

using core::Point;
using core::Vec3;

constexpr int kAround = 28, kAlong = 8;
constexpr double kPi = std::numbers::pi;
constexpr std::size_t kMostResults = 12;
constexpr double kLeastSize = 30;  // of a drawing, in its units

/// A surface of revolution: two half balls and the cone between them.
void add_limb(core::TriangleMesh& mesh, const Limb& limb) {
    const Vec3 axis = core::normalised(limb.to - limb.from);
    const Vec3 helper = std::abs(axis.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
    const Vec3 u = core::normalised(core::cross(axis, helper)), v = core::cross(axis, u);
    std::vector<std::pair<Vec3, double>> rings;  // centre, radius
    for (int i = 0; i <= kAlong; ++i) {
        const double a = -kPi / 2 + kPi / 2 * i / kAlong;
        rings.emplace_back(limb.from + axis * (limb.r0 * std::sin(a)), limb.r0 * std::cos(a));
    }
    for (int i = 0; i <= kAlong; ++i) {
        const double a = kPi / 2 * i / kAlong;
        rings.emplace_back(limb.to + axis * (limb.r1 * std::sin(a)), limb.r1 * std::cos(a));
    }
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& [centre, radius] : rings) {
        for (int k = 0; k < kAround; ++k) {
            const double a = 2 * kPi * k / kAround;
            mesh.vertices.push_back(centre + u * (radius * std::cos(a)) + v * (radius * std::sin(a)));
        }
    }
    for (std::size_t r = 0; r + 1 < rings.size(); ++r) {
        for (int k = 0; k < kAround; ++k) {
            const auto at = [&](std::size_t ring, int step) {
                return base + static_cast<std::uint32_t>(ring * kAround + static_cast<std::size_t>(step % kAround));
            };
            mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r + 1, k)});
            mesh.triangles.push_back({at(r, k + 1), at(r + 1, k + 1), at(r + 1, k)});
        }
    }
}

core::Polygon outline_of(const Limb& limb, const core::Camera& camera) {
    std::vector<Point> points;
    for (const auto& [centre, radius] : {std::pair{limb.from, limb.r0}, std::pair{limb.to, limb.r1}}) {
        const Point c = camera.project(centre);
        for (int k = 0; k < 24; ++k)
            points.push_back(c + Point{std::cos(k * kPi / 12), std::sin(k * kPi / 12)} * radius);
    }
    return core::convex_hull(points);
}

struct Box {
    double left = 1e18, right = -1e18, low = 1e18, high = -1e18;
    void add(Point p) {
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    [[nodiscard]] double aspect() const { return (right - left) / std::max(high - low, 1e-9); }
};

}  // namespace

Figure make_figure(std::string name, std::vector<Limb> limbs) {
    std::stable_sort(limbs.begin(), limbs.end(),  // the nearer ones last: of overlapping parts the later one is seen
                     [](const Limb& a, const Limb& b) { return a.from.z + a.to.z < b.from.z + b.to.z; });
    Figure figure{std::move(name), std::move(limbs), {}};
    for (const Limb& limb : figure.limbs) add_limb(figure.mesh, limb);
    Vec3 low = figure.mesh.vertices[0], high = low;
    for (const Vec3& p : figure.mesh.vertices) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 centre = (low + high) * 0.5;
    double farthest = 0;
    for (const Vec3& p : figure.mesh.vertices) farthest = std::max(farthest, core::length(p - centre));
    const double s = 1 / farthest;
    for (Vec3& p : figure.mesh.vertices) p = (p - centre) * s;
    for (Limb& limb : figure.limbs) {
        limb = {(limb.from - centre) * s, (limb.to - centre) * s, limb.r0 * s, limb.r1 * s, limb.colour};
    }
    return figure;
}

Figure make_quadruped(std::string name, double neck, double legs, double tail) {
    std::vector<Limb> limbs{{{-0.5, 0, 0}, {0.5, 0, 0}, 0.26, 0.25, 0}};
    const Vec3 chest{0.6, 0.08, 0}, head{0.78 + neck * 0.25, 0.15 + neck, 0};
    limbs.push_back({chest, head, 0.19, 0.11, 1});
    limbs.push_back({head, head + Vec3{0.3, -0.14, 0}, 0.12, 0.08, 2});
    limbs.push_back({head, head + Vec3{-0.06, 0.18, 0.06}, 0.04, 0.02, 2});
    limbs.push_back({{0.5, -0.1, 0.13}, {0.54, -legs, 0.16}, 0.13, 0.06, 3});
    limbs.push_back({{0.42, -0.1, -0.13}, {0.34, -legs, -0.16}, 0.12, 0.06, 4});
    limbs.push_back({{-0.52, -0.05, 0.13}, {-0.62, -legs, 0.16}, 0.16, 0.06, 5});
    limbs.push_back({{-0.48, -0.05, -0.13}, {-0.38, -legs, -0.16}, 0.14, 0.06, 6});
    limbs.push_back({{-0.72, 0.1, 0}, {-0.76 - tail * 0.4, 0.1 - tail, 0}, 0.06, 0.03, 7});
    return make_figure(std::move(name), std::move(limbs));
}

std::vector<Figure> make_animals() {
    std::vector<Figure> all;
    all.push_back(make_quadruped("horse", 0.45, 0.85, 0.5));
    all.push_back(make_quadruped("stag", 0.55, 0.95, 0.15));
    all.push_back(make_quadruped("bull", 0.2, 0.62, 0.45));
    all.push_back(make_quadruped("ibex", 0.4, 0.75, 0.1));
    all.push_back(make_quadruped("camel", 0.7, 0.9, 0.4));
    all.push_back(make_quadruped("giraffe", 1.2, 1.15, 0.4));
    all.push_back(make_quadruped("hound", 0.3, 0.7, -0.4));
    all.push_back(make_quadruped("badger", 0.1, 0.4, 0.1));
    all.push_back(make_quadruped("sauropod_long_neck", 0.9, 0.6, 0.8));
    for (Limb& limb : all[3].limbs) {
        if (limb.colour >= 3) limb.colour = -1;  // only partly matched
    }
    for (Limb& limb : all[7].limbs) limb.colour = -1;  // not matched at all
    return all;
}

FigureSearcher::FigureSearcher(std::vector<Figure> figures, std::chrono::milliseconds pause) : pause_(pause) {
    for (Figure& figure : figures) {
        auto mesh = std::make_shared<const core::TriangleMesh>(figure.mesh);
        entries_.push_back({std::move(figure), std::move(mesh)});
    }
}

app::SearchAnswer FigureSearcher::search(const core::Drawing& drawing, std::stop_token stop) {
    for (auto left = pause_; left.count() > 0 && !stop.stop_requested(); left -= std::chrono::milliseconds(5)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    Box sheet;
    for (const core::Stroke& stroke : drawing.strokes) {
        for (const core::PenSample& s : stroke.samples) sheet.add({s.x, s.y});
    }
    app::SearchAnswer answer;
    if (std::max(sheet.right - sheet.left, sheet.high - sheet.low) < kLeastSize) {
        answer.message_key = "too_little";
        return answer;
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& entry = entries_[i];
        app::FoundModel model;
        model.id = static_cast<std::int64_t>(i) + 1;
        model.name = entry.figure.name;
        model.class_name = "animal";
        model.mesh = entry.mesh;
        // a little from above and in front, so that all legs are seen
        model.camera.direction = core::normalised({0.22, 0.16, 1});
        model.camera.up = core::normalised(Vec3{0, 1, 0} - model.camera.direction * model.camera.direction.y);
        Box view;
        for (const Vec3& p : entry.mesh->vertices) view.add(model.camera.project(p));
        model.distance = std::abs(std::log(sheet.aspect() / view.aspect()));
        for (const Limb& limb : entry.figure.limbs) {
            app::FoundPart part{limb.colour, {}, outline_of(limb, model.camera)};
            for (const Point& p : part.on_view) {
                part.on_drawing.push_back(
                    {sheet.left + (p.x - view.left) / (view.right - view.left) * (sheet.right - sheet.left),
                     sheet.high - (p.y - view.low) / (view.high - view.low) * (sheet.high - sheet.low)});
            }
            model.parts.push_back(std::move(part));
        }
        answer.best.push_back(std::move(model));
    }
    std::stable_sort(answer.best.begin(), answer.best.end(),
                     [](const auto& a, const auto& b) { return a.distance < b.distance; });
    if (answer.best.size() > kMostResults) answer.best.resize(kMostResults);
    return answer;
}

core::Drawing make_horse_drawing() {
    const std::vector<core::Polyline> lines{
        {{60, 110},  {48, 150},  {40, 190},  {46, 192},  {58, 160},  {70, 130},  {76, 160},
         {78, 200},  {72, 260},  {88, 262},  {94, 215},  {104, 170}, {116, 200}, {126, 262},
         {142, 260}, {136, 210}, {134, 165}, {180, 164}, {214, 166}, {222, 210}, {216, 262},
         {232, 262}, {242, 205}, {252, 250}, {256, 264}, {272, 262}, {262, 205}, {266, 150}},
        {{266, 150},
         {280, 110},
         {292, 70},
         {320, 84},
         {344, 92},
         {352, 82},
         {330, 60},
         {300, 40},
         {292, 24},
         {286, 40},
         {270, 64},
         {240, 96},
         {190, 102},
         {130, 96},
         {92, 96},
         {60, 110}},
        {{302, 56}, {304, 58}}};
    core::Drawing drawing;
    std::int64_t time_us = 0;
    for (const core::Polyline& line : lines) {
        core::Stroke stroke;
        const int count = std::max(2, static_cast<int>(core::chain_length(line) / 4));
        for (const Point& p : core::resample_chain(line, count)) {
            stroke.samples.push_back({time_us, p.x, p.y, 1.0});
            time_us += 8'000;
        }
        time_us += 250'000;
        drawing.strokes.push_back(std::move(stroke));
    }
    return drawing;
}

}  // namespace test
