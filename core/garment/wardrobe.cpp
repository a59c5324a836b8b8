#include "core/garment/wardrobe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace core {
namespace {

using Kind = DesignStep::Kind;
using Tool = DrawingTool::Kind;
using Points = std::vector<Point>;

constexpr double kSeam_z = -1.2;  // side and shoulder seams lie in this plane

/// A part of a stroke as the pen draws it: few given points joined by a smooth curve.
StrokePart part(const char* view, Tool tool, double offset, const Points& through) {
    StrokePart out;
    out.view = *named_view(view);
    out.tool = {tool, offset};
    const auto at = [&](std::ptrdiff_t i) {
        return through[static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(i, 0, static_cast<std::ptrdiff_t>(through.size()) - 1))];
    };
    for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(through.size()); ++i) {
        const Point a = at(i - 1), b = at(i), c = at(i + 1), d = at(i + 2);
        const int steps = std::max(2, static_cast<int>(distance(b, c)));
        for (int k = 0; k < steps; ++k) {  // Catmull and Rom
            const double t = static_cast<double>(k) / steps, t2 = t * t, t3 = t2 * t;
            out.points.push_back(
                (b * 2.0 + (c - a) * t + (a * 2.0 - b * 5.0 + c * 4.0 - d) * t2 + (b * 3.0 - a - c * 3.0 + d) * t3) *
                0.5);
        }
    }
    out.points.push_back(through.back());
    return out;
}

/// The half of a drawn body that the designs are made on.
struct Measured {
    BodyFrame frame;
    double bust_x, waist_x, hip_x, knee_x, ankle_x;  ///< half widths; outer sides of the legs
    double bust_z, waist_z, hip_z;                   ///< fronts
    double bust_back, waist_back, hip_back;          ///< backs, negative

    explicit Measured(const Mannequin& body) : frame(body_frame(body.measures)) {
        const auto place = [&](const char* name) {
            for (const Landmark& l : body.landmarks)
                if (l.name == name) return l.place;
            return Vec3{};
        };
        bust_x = place("bust_left").x, waist_x = place("waist_left").x, hip_x = place("hip_left").x;
        bust_z = place("bust_front").z, waist_z = place("waist_front").z, hip_z = place("hip_front").z;
        bust_back = place("bust_back").z, waist_back = place("waist_back").z, hip_back = place("hip_back").z;
        ankle_x = place("ankle_left").x;
        knee_x = 0.5 * (hip_x + ankle_x);
    }
    /// A place beside the left arm, as the front view shows it: `along` its axis, `across` upwards and away.
    [[nodiscard]] Point arm(double along, double across) const {
        const Vec3 d = frame.arm_direction, p = frame.arm_root + d * along;
        const double flat = std::hypot(d.x, d.y);
        return {p.x - d.y / flat * across, p.y + d.x / flat * across};
    }
};

class Maker {
  public:
    Maker(std::string name, const Mannequin& body) : m(body) {
        design_.name = std::move(name);
        design_.body = body.measures;
        design_.network.snap_cm = 3.0;
    }

    void edges(double length_cm) { design_.network.edge_cm = length_cm; }

    void line(const std::string& name, SketchStroke stroke) {
        DesignStep step;
        step.name = name;
        step.stroke = std::move(stroke);
        design_.steps.push_back(std::move(step));
    }
    void region(const std::string& name, std::vector<std::string> lines, double alpha = kCoonsAlpha) {
        DesignStep step;
        step.kind = Kind::Region;
        step.name = name;
        step.lines = std::move(lines);
        step.alpha = alpha;
        design_.steps.push_back(std::move(step));
    }
    void cut(Kind kind, const std::string& region, const std::string& name, SketchStroke stroke) {
        DesignStep step;
        step.kind = kind;
        step.region = region;
        step.name = name;
        step.stroke = std::move(stroke);
        design_.steps.push_back(std::move(step));
    }
    void next_layer() {
        DesignStep step;
        step.kind = Kind::Layer;
        design_.steps.push_back(step);
    }

    /// A place in the plane of the side seams, where the pieces of front and back meet.
    static StrokePart seam(const Points& through) { return part("front", Tool::PlaneXY, kSeam_z, through); }
    static Point mirrored(Point p) { return {-p.x, p.y}; }

    [[nodiscard]] Point neck_point() const { return {7.2, m.frame.nape + 0.8}; }
    [[nodiscard]] Point shoulder_tip() const { return {m.frame.arm_root.x + 1.5, m.frame.shoulder + 1.2}; }
    [[nodiscard]] Point underarm(double ease) const { return {m.bust_x + ease, m.frame.bust + 4.0}; }

    /// Shoulder seam, necklines and arm holes, `ease` from the body; the neckline ends `deep` below the nape in front.
    void bodice_top(double ease, double deep) {
        const BodyFrame& f = m.frame;
        const Point neck = neck_point(), tip = shoulder_tip(), under = underarm(ease);
        line("shoulder", {seam({neck, {0.5 * (neck.x + tip.x), 0.45 * neck.y + 0.55 * tip.y}, tip})});
        line(
            "neckline",
            {seam({neck}),
             part("front", Tool::Body, ease,
                  {{0.92 * neck.x, f.nape - 0.3 * deep}, {0.6 * neck.x, f.nape - 0.75 * deep}, {0.0, f.nape - deep}})});
        line("neckline_back",
             {seam({neck}), part("back", Tool::Body, ease,
                                 {{-0.8 * neck.x, f.nape - 1.6}, {-0.4 * neck.x, f.nape - 2.6}, {0.0, f.nape - 3.0}})});
        const double middle = 0.5 * (f.shoulder + f.bust) + 2.0;
        // the last of it goes round under the arm, where no view shows the body: on planes from front to side
        const auto below = [&](double z, double in, double up) {
            return part("front", Tool::PlaneXY, z, {{under.x - in, under.y + up}});
        };
        line("armhole", {seam({tip}),
                         part("front", Tool::Body, ease,
                              {{tip.x - 1.2, tip.y - 3.5}, {tip.x - 2.0, middle}, {under.x - 1.0, under.y + 5.0}}),
                         below(3.4, 0.8, 2.4), below(1.6, 0.4, 0.7), seam({under})});
        line("armhole_back", {seam({tip}),
                              part("back", Tool::Body, ease,
                                   {{1.0 - tip.x, tip.y - 3.5}, {1.8 - tip.x, middle}, {0.8 - under.x, under.y + 1.5}}),
                              seam({under})});
    }

    /// Tubes around the arm from the arm holes to `end` along it, `loose` from its axis at the end.
    void sleeve(double ease, double end, double loose) {
        const Point top = m.arm(end, loose), under = m.arm(end, -loose), middle = midpoint(top, under);
        line("sleeve_top", {seam({shoulder_tip(), m.arm(0.4 * end, 5.6 + ease), top})});
        line("sleeve_under", {seam({underarm(ease), m.arm(0.6 * end, -5.0 - ease), under})});
        line("cuff", {seam({top}),
                      part("front", Tool::Body, ease + 0.5, {midpoint(top, middle), middle, midpoint(middle, under)}),
                      seam({under})});
        line("cuff_back", {seam({top}),
                           part("back", Tool::Body, ease + 0.5,
                                {mirrored(midpoint(top, middle)), mirrored(middle), mirrored(midpoint(middle, under))}),
                           seam({under})});
        region("sleeve", {"armhole", "sleeve_top", "cuff", "sleeve_under"});
        region("sleeve_back", {"armhole_back", "sleeve_top", "cuff_back", "sleeve_under"});
    }

    Measured m;
    Design take() && { return std::move(design_); }

  private:
    Design design_;
};

Design dress(const Mannequin& body) {
    Maker d("dress", body);
    const Measured& m = d.m;
    const BodyFrame& f = m.frame;
    const double ease = 0.8, hem = f.knee + 4.0, flare = m.hip_x + 11.0, deep = 9.0;
    d.bodice_top(ease, deep);
    // the side: on the silhouette down to the hip, then free in the plane of the side
    d.line("side", {Maker::seam({d.underarm(ease),
                                 {m.bust_x + ease, f.bust - 2.0},
                                 {m.waist_x + 1.0, f.waist},
                                 {m.hip_x + 1.5, f.hip + 2.0},
                                 {flare, hem}})});
    // front and back middle in the side view, hems in the level plane
    d.line("middle", {part("front", Tool::Body, ease, {{0.0, f.nape - deep}}), part("left", Tool::PlaneYZ, 0.0,
                                                                                    {{-m.bust_z - 1.0, f.bust},
                                                                                     {-m.waist_z - 1.2, f.waist},
                                                                                     {-m.hip_z - 2.5, f.hip},
                                                                                     {-m.hip_z - 13.0, hem}})});
    d.line("middle_back", {part("back", Tool::Body, ease, {{0.0, f.nape - 3.0}}), part("left", Tool::PlaneYZ, 0.0,
                                                                                       {{-m.bust_back + 1.2, f.bust},
                                                                                        {-m.waist_back + 1.2, f.waist},
                                                                                        {-m.hip_back + 1.5, f.hip},
                                                                                        {-m.hip_back + 9.0, hem}})});
    d.line("hem", {part("top", Tool::PlaneXZ, hem,
                        {{flare, 1.0}, {0.75 * flare, -0.72 * (m.hip_z + 13.0)}, {0.0, -m.hip_z - 13.0}})});
    d.line("hem_back", {part("top", Tool::PlaneXZ, hem,
                             {{flare, 1.0}, {0.75 * flare, 0.75 * (9.0 - m.hip_back)}, {0.0, 9.0 - m.hip_back}})});
    d.region("front", {"shoulder", "neckline", "middle", "hem", "side", "armhole"});
    d.region("back", {"shoulder", "neckline_back", "middle_back", "hem_back", "side", "armhole_back"});
    d.sleeve(ease, 0.42 * f.wrist, 7.0);
    d.cut(Kind::Cut, "front", "skirt", {part("front", Tool::Body, 1.0, {{0.0, f.waist}, {m.waist_x + 1.0, f.waist}})});
    d.cut(Kind::Cut, "back", "skirt_back",
          {part("back", Tool::Body, 1.0, {{-m.waist_x - 1.0, f.waist}, {0.0, f.waist}})});
    const Point hole = m.arm(0.24 * f.wrist, 0.0);
    Points ring;
    for (int k = 0; k <= 16; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 16;
        ring.push_back({hole.x + 2.6 * std::cos(angle), hole.y + 2.6 * std::sin(angle)});
    }
    d.cut(Kind::Hole, "sleeve", "sleeve_slit", {part("front", Tool::Body, 1.2, ring)});
    return std::move(d).take();
}

void draw_trousers(Maker& d) {
    const Measured& m = d.m;
    const BodyFrame& f = m.frame;
    const double ease = 0.7, hem = f.ankle - 3.0;
    const Vec3 leg{0.5 * (m.ankle_x + m.ankle_x - 7.0), 0, 0};
    const double inner = leg.x - 6.0, outer = leg.x + 8.5;
    d.line("waistband",
           {part("front", Tool::Body, ease,
                 {{0.0, f.waist - 2.0}, {0.45 * m.waist_x, f.waist - 1.8}, {0.8 * m.waist_x, f.waist - 1.3}}),
            Maker::seam({{m.waist_x + ease, f.waist - 1.0}})});
    d.line("waistband_back",
           {part("back", Tool::Body, ease,
                 {{0.0, f.waist - 1.0}, {-0.45 * m.waist_x, f.waist - 1.0}, {-0.8 * m.waist_x, f.waist - 1.0}}),
            Maker::seam({{m.waist_x + ease, f.waist - 1.0}})});
    d.line("outseam", {Maker::seam({{m.waist_x + ease, f.waist - 1.0},
                                    {m.hip_x + 1.2, f.hip},
                                    {m.hip_x + 1.6, f.thigh},
                                    {0.5 * (m.hip_x + outer) + 1.0, f.knee},
                                    {outer, hem}})});
    d.line("rise", {part("left", Tool::PlaneYZ, 0.0,
                         {{-m.waist_z - ease, f.waist - 2.0},
                          {-m.hip_z - 1.2, f.hip},
                          {-3.5, f.crotch - 0.6},
                          {0.0, f.crotch - 1.8}})});
    d.line("rise_back", {part("left", Tool::PlaneYZ, 0.0,
                              {{-m.waist_back + ease, f.waist - 1.0},
                               {-m.hip_back + 1.2, f.hip},
                               {6.5, f.crotch - 0.6},
                               {0.0, f.crotch - 1.8}})});
    d.line("inseam",
           {Maker::seam({{0.0, f.crotch - 1.8}, {0.6, f.thigh - 2.0}, {0.75 * inner, f.knee}, {inner, hem}})});
    d.line("hem", {part("top", Tool::PlaneXZ, hem, {{outer, 1.0}, {leg.x + 1.0, -8.0}, {inner, 1.0}})});
    d.line("hem_back", {part("top", Tool::PlaneXZ, hem, {{outer, 1.0}, {leg.x + 1.0, 9.5}, {inner, 1.0}})});
    d.region("leg", {"waistband", "outseam", "hem", "inseam", "rise"});
    d.region("leg_back", {"waistband_back", "outseam", "hem_back", "inseam", "rise_back"});
}

void draw_jacket(Maker& d, double ease) {
    const Measured& m = d.m;
    const BodyFrame& f = m.frame;
    const double hem = f.hip - 3.0, deep = 13.0, open = 1.2;
    d.bodice_top(ease, deep);
    d.line("jacket_side", {Maker::seam({d.underarm(ease),
                                        {m.bust_x + ease + 0.5, f.bust - 2.0},
                                        {m.waist_x + ease + 2.0, f.waist},
                                        {m.hip_x + ease + 2.5, hem}})});
    d.line("jacket_middle",
           {part("front", Tool::Body, ease, {{0.0, f.nape - deep}}),
            part("left", Tool::PlaneYZ, 0.0,
                 {{-m.bust_z - open, f.bust}, {-m.waist_z - ease - 1.5, f.waist}, {-m.hip_z - ease - 3.0, hem}})});
    d.line("jacket_middle_back",
           {part("back", Tool::Body, ease, {{0.0, f.nape - 3.0}}), part("left", Tool::PlaneYZ, 0.0,
                                                                        {{-m.bust_back + ease, f.bust},
                                                                         {-m.waist_back + ease + 1.5, f.waist},
                                                                         {-m.hip_back + ease + 2.0, hem}})});
    const double side = m.hip_x + ease + 2.5, front = m.hip_z + ease + 3.0, back = ease + 2.0 - m.hip_back;
    d.line("jacket_hem", {part("top", Tool::PlaneXZ, hem, {{side, 1.0}, {0.72 * side, -0.78 * front}, {0.0, -front}})});
    d.line("jacket_hem_back", {part("top", Tool::PlaneXZ, hem, {{side, 1.0}, {0.72 * side, 0.8 * back}, {0.0, back}})});
    d.region("jacket_front", {"shoulder", "neckline", "jacket_middle", "jacket_hem", "jacket_side", "armhole"});
    d.region("jacket_back",
             {"shoulder", "neckline_back", "jacket_middle_back", "jacket_hem_back", "jacket_side", "armhole_back"});
    d.sleeve(ease, 0.93 * f.wrist, 4.6 + ease);
}

Design outfit(const Mannequin& body) {
    Maker d("outfit", body);
    draw_trousers(d);
    d.next_layer();
    draw_jacket(d, 1.6);
    return std::move(d).take();
}

Design trousers(const Mannequin& body) {
    Maker d("trousers", body);
    draw_trousers(d);
    return std::move(d).take();
}

/// The collar stands on the neckline of the jacket; the pocket is drawn on its front, as a layer of its own.
Design jacket(const Mannequin& body) {
    Maker d("jacket", body);
    const Measured& m = d.m;
    const BodyFrame& f = m.frame;
    d.edges(1.6);  // a collar goes over the sharp line of the shoulder
    draw_jacket(d, 1.2);
    d.next_layer();
    // just outside of the jacket's neckline, and a hand's breadth farther
    const double deep = 13.0;
    const auto around = [&](const char* name, double out, double offset) {
        const double x = d.neck_point().x + out;
        d.line(name, {part("front", Tool::Body, offset,
                           {{0.0, f.nape - deep - 1.2 * out},
                            {0.62 * x, f.nape - 0.72 * deep - 0.7 * out},
                            {0.95 * x, f.nape - 0.3 * deep - 0.3 * out}}),
                      part("top", Tool::Body, offset, {{x, -1.0}, {x, 2.5}}),
                      part("back", Tool::Body, offset,
                           {{-0.85 * x, f.nape - 2.0 - 0.7 * out},
                            {-0.45 * x, f.nape - 3.2 - out},
                            {0.0, f.nape - 3.4 - 1.1 * out}})});
    };
    around("collar_inner", 1.2, 0.5);
    around("collar_outer", 5.5, 0.8);
    d.line("collar_front", {part("front", Tool::Body, 0.7, {{0.0, f.nape - deep - 1.4}, {0.0, f.nape - deep - 6.6}})});
    d.line("collar_back", {part("back", Tool::Body, 0.7, {{0.0, f.nape - 4.7}, {0.0, f.nape - 9.5}})});
    d.region("collar", {"collar_inner", "collar_back", "collar_outer", "collar_front"});
    const double x = 0.55 * m.waist_x, y = f.waist - 7.0;
    d.line("pocket", {part("front", Tool::Body, 0.5, {{x - 4.5, y}, {x + 4.5, y}}),
                      part("front", Tool::Body, 0.5, {{x + 4.5, y}, {x + 4.5, y - 9.0}}),
                      part("front", Tool::Body, 0.5, {{x + 4.5, y - 9.0}, {x - 4.5, y - 9.0}}),
                      part("front", Tool::Body, 0.5, {{x - 4.5, y - 9.0}, {x - 4.5, y}})});
    d.region("pocket", {"pocket"});
    return std::move(d).take();
}

/// A skirt whose hem is drawn in waves: folds.
Design skirt(const char* name, const Mannequin& body, double alpha) {
    Maker d(name, body);
    const Measured& m = d.m;
    const BodyFrame& f = m.frame;
    const double hem = f.knee + 2.0, wide = m.hip_x + 14.0;
    d.line("waist",
           {part("front", Tool::Body, 0.6, {{0.0, f.waist}, {0.45 * m.waist_x, f.waist}, {0.8 * m.waist_x, f.waist}}),
            Maker::seam({{m.waist_x + 0.6, f.waist}})});
    d.line("waist_back",
           {part("back", Tool::Body, 0.6, {{0.0, f.waist}, {-0.45 * m.waist_x, f.waist}, {-0.8 * m.waist_x, f.waist}}),
            Maker::seam({{m.waist_x + 0.6, f.waist}})});
    d.line("side", {Maker::seam({{m.waist_x + 0.6, f.waist}, {m.hip_x + 3.0, f.hip}, {wide, hem}})});
    d.line("middle", {part("left", Tool::PlaneYZ, 0.0,
                           {{-m.waist_z - 0.6, f.waist}, {-m.hip_z - 4.5, f.hip}, {-wide + 4.0, hem}})});
    d.line("middle_back", {part("left", Tool::PlaneYZ, 0.0,
                                {{-m.waist_back + 0.6, f.waist}, {-m.hip_back + 2.0, f.hip}, {wide - 2.0, hem}})});
    const auto wave = [&](double depth, double sign) {
        Points points;
        for (int k = 0; k <= 60; ++k) {
            const double t = k / 60.0, angle = t * std::numbers::pi / 2.0;
            const double bump =
                1.0 + 0.13 * std::sin(2.0 * std::numbers::pi * 3.0 * t) * std::sin(std::numbers::pi * t);
            points.push_back(
                {wide * std::cos(angle) * bump, sign * depth * std::sin(angle) * bump + 1.0 * std::cos(angle)});
        }
        return points;
    };
    d.line("hem", {part("top", Tool::PlaneXZ, hem, wave(wide - 4.0, -1.0))});
    d.line("hem_back", {part("top", Tool::PlaneXZ, hem, wave(wide - 2.0, 1.0))});
    d.region("front", {"waist", "side", "hem", "middle"}, alpha);
    d.region("back", {"waist_back", "side", "hem_back", "middle_back"}, alpha);
    Design design = std::move(d).take();
    design.network.edge_cm = 1.5;
    return design;
}

}  // namespace

const std::vector<std::string>& wardrobe_names() {
    static const std::vector<std::string> kNames{"dress", "trousers", "outfit", "jacket", "skirt_flat", "skirt_folds"};
    return kNames;
}

Result<Design> wardrobe_design(std::string_view name, const Mannequin& body) {
    if (name == "dress") return dress(body);
    if (name == "trousers") return trousers(body);
    if (name == "outfit") return outfit(body);
    if (name == "jacket") return jacket(body);
    if (name == "skirt_flat") return skirt("skirt_flat", body, kHarmonicAlpha);
    if (name == "skirt_folds") return skirt("skirt_folds", body, kCoonsAlpha);
    return unexpected(ErrorCode::BadArgument,
                      "There is no worked design \"" + std::string(name) +
                          "\"; there are dress, trousers, outfit, jacket, skirt_flat, skirt_folds.");
}

}  // namespace core
