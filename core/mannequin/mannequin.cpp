#include "core/mannequin/mannequin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <utility>

#include "core/mannequin/body_mesher.hpp"
#include "core/mesh/surface_net.hpp"

namespace core {
namespace {

constexpr double kCellCm = 1.25;
constexpr int kDirections = 96;  // of the section of a field
constexpr int kFieldRounds = 8;  // of solving on the field
constexpr int kMeshRounds = 2;   // of correcting by what the mesh measures
constexpr double kGirthEnough_cm = 0.05;

/// One girth that is solved for.
struct Girth {
    Measure measure;
    const char* name;
    double BodyScales::*scale;
    std::function<CutPlane(const BodyShape&, const BodyFrame&)> plane;
    double asked = 0.0;  ///< of the tape
    double goal = 0.0;   ///< for the field: asked, and what the mesh loses
};

CutPlane level_plane(Vec3 middle) {
    return {middle, {1, 0, 0}, {0, 0, -1}};
}

auto trunk_at(double BodyFrame::*height) {
    return
        [height](const BodyShape& shape, const BodyFrame& f) { return level_plane(shape.trunk().middle(f.*height)); };
}
auto leg_at(double BodyFrame::*height) {
    return [height](const BodyShape& shape, const BodyFrame& f) { return level_plane(shape.leg().middle(f.*height)); };
}
auto arm_at(double BodyFrame::*along) {
    return [along](const BodyShape& shape, const BodyFrame& f) {
        const LoftFrame& frame = shape.arm().frame();
        return CutPlane{shape.arm().middle(f.*along), frame.front, frame.side};
    };
}

std::vector<Girth> girths_of(const BodyMeasures& m) {
    const bool woman = m.figure == Figure::Woman;
    std::vector<Girth> girths{{Measure::Bust, woman ? "bust" : "chest",
                               woman ? &BodyScales::breast_cm : &BodyScales::chest, trunk_at(&BodyFrame::bust)},
                              {Measure::Waist, "waist", &BodyScales::waist, trunk_at(&BodyFrame::waist)},
                              {Measure::Hip, "hip", &BodyScales::hip, trunk_at(&BodyFrame::hip)},
                              {Measure::Neck, "neck", &BodyScales::neck, trunk_at(&BodyFrame::neck)},
                              {Measure::UpperArm, "upper_arm", &BodyScales::upper_arm, arm_at(&BodyFrame::upper_arm)},
                              {Measure::Wrist, "wrist", &BodyScales::wrist, arm_at(&BodyFrame::wrist)},
                              {Measure::Thigh, "thigh", &BodyScales::thigh, leg_at(&BodyFrame::thigh)},
                              {Measure::Knee, "knee", &BodyScales::knee, leg_at(&BodyFrame::knee)},
                              {Measure::Calf, "calf", &BodyScales::calf, leg_at(&BodyFrame::calf)},
                              {Measure::Ankle, "ankle", &BodyScales::ankle, leg_at(&BodyFrame::ankle)}};
    if (woman)
        girths.insert(girths.begin() + 1,
                      {Measure::UnderBust, "under_bust", &BodyScales::under_bust, trunk_at(&BodyFrame::under_bust)});
    for (Girth& g : girths) g.asked = g.goal = m[g.measure];
    return girths;
}

/// How far from `from` along the unit vector `direction` the body ends, for a start inside; steps no longer than what
/// the field says.
double way_out(const BodyShape& shape, Vec3 from, Vec3 direction, BodyShape::Mask parts = BodyShape::kAll) {
    double at = 0.0;
    for (int step = 0; step < 60; ++step) {
        const FieldSample s = shape.sample(from + direction * at, parts);
        if (s.distance > -1e-4) {
            const double slope = dot(s.gradient, direction);
            return slope > 0.1 ? at - s.distance / slope : at;
        }
        at += std::max(-0.85 * s.distance, 1e-4);
    }
    return at;
}

/// `about`: a girth that is not much smaller.
double field_girth(const BodyShape& shape, const CutPlane& plane, double about) {
    const BodyShape::Mask parts = shape.near(plane.origin, about / 8.0);
    std::vector<Point> points;
    for (int k = 0; k < kDirections; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kDirections;
        const Point d{std::cos(angle), std::sin(angle)};
        points.push_back(d * way_out(shape, plane.origin, plane.right * d.x + plane.up * d.y, parts));
    }
    return hull_length(std::move(points)) *
           (1.0 + std::numbers::pi * std::numbers::pi / (6.0 * kDirections * kDirections));
}

/// The lowest point of the trunk between the legs.
double field_crotch(const BodyShape& shape, const BodyFrame& f) {
    double lowest = f.hip;
    for (int z = -6; z <= 5; ++z) {
        const double down = way_out(shape, {0.0, f.hip, static_cast<double>(z)}, {0, -1, 0});
        lowest = std::min(lowest, f.hip - down);
    }
    return lowest;
}

double field_crown(const BodyShape& shape, const BodyFrame& f) {
    double highest = 0.0;
    const double from = f.stature - 10.0;
    for (int half = 0; half <= 10; ++half)
        highest = std::max(highest, from + way_out(shape, {0, from, half * 0.5}, {0, 1, 0}));
    return highest;
}

/// Breasts are a depth and not a factor: when they cannot reach the bust, the chest below them grows, when they would
/// vanish it shrinks.
void correct_breasts(BodyScales& scales, double asked, double reached) {
    constexpr double kLeast = 2.0, kMost = 11.0;
    scales.breast_cm += 0.45 * (asked - reached);
    const double clamped = std::clamp(scales.breast_cm, kLeast, kMost);
    if (clamped != scales.breast_cm) scales.chest *= 1.0 + 0.5 * (asked / reached - 1.0);
    scales.breast_cm = clamped;
}

class Solver {
  public:
    explicit Solver(const BodyMeasures& m) : measures_(m), frame_(body_frame(m)), girths_(girths_of(m)) {
        start();
        crotch_goal_ = frame_.crotch;
    }

    void solve_on_field(int rounds) {
        for (int round = 0; round < rounds; ++round) {
            const BodyShape shape = this->shape();
            double worst = 0.0;
            for (const Girth& g : girths_) {
                const double reached = field_girth(shape, g.plane(shape, frame_), g.asked);
                worst = std::max(worst, std::abs(g.goal - reached));
                correct(g, g.goal, reached);
            }
            const double crotch = field_crotch(shape, frame_), crown = field_crown(shape, frame_);
            scales_.crotch_shift_cm += std::clamp(0.8 * (crotch_goal_ - crotch), -2.0, 2.0);
            scales_.crown_shift_cm += frame_.stature - crown;
            if (worst < 0.01 && std::abs(crotch_goal_ - crotch) < 0.02) break;
        }
    }

    /// Moves the goals by what the mesh misses; true when it was near enough already.
    bool learn_from(const QuadMesh& mesh) {
        const BodyShape shape = this->shape();
        double worst = 0.0;
        for (Girth& g : girths_) {
            const double reached = tape_length(mesh, g.plane(shape, frame_));
            worst = std::max(worst, std::abs(g.asked - reached));
            g.goal += g.asked - reached;
        }
        return worst < kGirthEnough_cm;
    }

    [[nodiscard]] BodyShape shape() const { return {measures_, scales_}; }
    [[nodiscard]] const BodyFrame& frame() const { return frame_; }

    [[nodiscard]] std::vector<ReachedMeasure> reached(const QuadMesh& mesh) const {
        const BodyShape shape = this->shape();
        std::vector<ReachedMeasure> out;
        for (const Girth& g : girths_) {
            const CutPlane plane = g.plane(shape, frame_);
            out.push_back({g.name, g.asked, tape_length(mesh, plane), plane});
        }
        return out;
    }

  private:
    /// Scales as the measures stand to those of the reference figure: near the answer for usual bodies.
    void start() {
        const BodyMeasures reference = *measures_of_size(measures_.figure == Figure::Woman ? "36" : "m");
        for (const Girth& g : girths_)
            if (g.scale != &BodyScales::breast_cm) scales_.*g.scale = measures_[g.measure] / reference[g.measure];
        if (measures_.figure == Figure::Woman) {
            scales_.chest = scales_.under_bust;
        } else {
            scales_.under_bust = 0.5 * (scales_.waist + scales_.chest);
        }
    }

    void correct(const Girth& g, double goal, double reached) {
        const double ratio = std::clamp(goal / reached, 0.7, 1.4);
        if (g.scale == &BodyScales::breast_cm) {
            correct_breasts(scales_, goal, reached);
        } else {
            scales_.*g.scale *= ratio;
        }
        if (g.scale == &BodyScales::under_bust) scales_.chest *= ratio;
        if (measures_.figure == Figure::Man) scales_.under_bust = 0.5 * (scales_.waist + scales_.chest);
    }

    BodyMeasures measures_;
    BodyFrame frame_;
    BodyScales scales_;
    std::vector<Girth> girths_;
    double crotch_goal_ = 0.0;
};

/// Heights as the mesh has them: the extremes of its outline, the level of the narrowest and the widest tape.
class HeightFinder {
  public:
    explicit HeightFinder(const QuadMesh& mesh) : mesh_(mesh) {}

    [[nodiscard]] double crown() const {
        double top = 0.0;
        for (const Vec3& v : mesh_.vertices) top = std::max(top, v.y);
        return top;
    }
    /// Where the two legs become one piece.
    [[nodiscard]] double crotch(double about) const {
        double low = about - 4.0, high = about + 4.0;
        while (high - low > 0.01) {
            const double y = 0.5 * (low + high);
            bool joined = false;
            for (const auto& piece : plane_section(mesh_, level_plane({0, y, 0}))) {
                const auto [left, right] =
                    std::minmax_element(piece.begin(), piece.end(), [](Point a, Point b) { return a.x < b.x; });
                joined = joined || (left->x < 0.0 && right->x > 0.0);
            }
            (joined ? high : low) = y;
        }
        return 0.5 * (low + high);
    }

  private:
    const QuadMesh& mesh_;
};

std::vector<ReachedMeasure> heights_of(const Mannequin& body, const BodyFrame& f) {
    const HeightFinder finder(body.mesh);
    const BodyMeasures& m = body.measures;
    const auto at = [](double y) { return level_plane({0, y, 0}); };
    return {{"stature", m[Measure::Stature], finder.crown(), at(f.stature)},
            {"bust", m[Measure::BustHeight], f.bust, at(f.bust)},
            {"waist", m[Measure::WaistHeight], f.waist, at(f.waist)},
            {"hip", m[Measure::HipHeight], f.hip, at(f.hip)},
            {"crotch", m[Measure::CrotchHeight], finder.crotch(f.crotch), at(f.crotch)},
            {"knee", m[Measure::KneeHeight], f.knee, at(f.knee)}};
}

std::vector<Landmark> landmarks_of(const BodyShape& shape, const BodyFrame& f) {
    std::vector<Landmark> out;
    const auto level = [&](const char* name, double y) {
        const Vec3 middle = shape.trunk().middle(y);
        const auto to = [&](Vec3 d) { return middle + d * way_out(shape, middle, d); };
        out.push_back({std::string(name) + "_front", to({0, 0, 1})});
        out.push_back({std::string(name) + "_back", to({0, 0, -1})});
        out.push_back({std::string(name) + "_left", to({1, 0, 0})});
        out.push_back({std::string(name) + "_right", to({-1, 0, 0})});
    };
    level("bust", f.bust);
    level("under_bust", f.under_bust);
    level("waist", f.waist);
    level("hip", f.hip);
    level("neck", f.neck);
    const auto pair = [&](const std::string& name, Vec3 from, Vec3 direction) {
        const Vec3 p = from + direction * way_out(shape, from, direction);
        out.push_back({name + "_left", p});
        out.push_back({name + "_right", {-p.x, p.y, p.z}});
    };
    const Vec3 nape_middle = shape.trunk().middle(f.nape);
    out.push_back({"nape", nape_middle + Vec3{0, 0, -1} * way_out(shape, nape_middle, {0, 0, -1})});
    out.push_back({"crotch", {0, field_crotch(shape, f), 0}});
    pair("shoulder", f.arm_root, normalised({0.35, 1.0, 0.0}));
    pair("elbow", shape.arm().middle(f.elbow), shape.arm().frame().front);
    pair("wrist", shape.arm().middle(f.wrist), shape.arm().frame().front);
    pair("knee", shape.leg().middle(f.knee), {0, 0, 1});
    pair("ankle", shape.leg().middle(f.ankle), {1, 0, 0});
    return out;
}

}  // namespace

Result<Mannequin> make_mannequin(const BodyMeasures& measures) {
    if (const Result<void> fits = check_measures(measures); !fits) return unexpected(fits.error());
    Solver solver(measures);
    solver.solve_on_field(kFieldRounds);
    Mannequin body;
    body.measures = measures;
    body.mesh = mesh_body(solver.shape(), kCellCm);
    for (int round = 0; round < kMeshRounds && !solver.learn_from(body.mesh); ++round) {
        solver.solve_on_field(3);
        settle_on(solver.shape(), body.mesh);
    }
    const BodyShape shape = solver.shape();
    body.closed = is_closed_manifold(body.mesh);
    body.girths = solver.reached(body.mesh);
    body.heights = heights_of(body, solver.frame());
    body.landmarks = landmarks_of(shape, solver.frame());
    for (const Quad& q : body.mesh.quads) {
        Vec3 sum;
        for (const std::uint32_t v : q) sum = sum + body.mesh.vertices[v];
        body.part_of_quad.push_back(shape.part_at(sum * 0.25));
    }
    return body;
}

}  // namespace core
