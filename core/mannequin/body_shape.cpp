#include "core/mannequin/body_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace core {
namespace {

constexpr double kLegGap = 0.9;                         // from the plane between the legs to either, cm
constexpr double kTrunkToLeg = 6.0, kTrunkToArm = 6.0;  // how far from a joint two parts flow into each other, cm

/// A section of the trunk of the reference figure (size 36, size m), heights and depths in centimetres.
struct TrunkRow {
    double height, side, back, front;
};
constexpr std::array<TrunkRow, 17> kWomanRows{{{74.0, 8.0, 7.0, 3.5},
                                               {77.0, 14.2, 10.2, 6.4},
                                               {82.7, 16.6, 11.8, 8.1},
                                               {88.0, 16.0, 10.4, 9.1},
                                               {93.5, 14.6, 8.0, 9.5},
                                               {103.0, 12.7, 6.2, 9.5},
                                               {113.0, 12.8, 7.3, 8.9},
                                               {120.0, 13.9, 8.8, 8.6},
                                               {126.0, 14.7, 9.3, 7.3},
                                               {131.0, 15.4, 9.4, 6.4},
                                               {135.2, 14.6, 8.4, 4.9},
                                               {138.8, 11.8, 7.0, 3.6},
                                               {141.8, 8.4, 5.9, 3.4},
                                               {144.0, 6.2, 5.1, 4.2},
                                               {146.4, 5.3, 4.4, 5.4},
                                               {151.0, 5.3, 3.9, 6.4},
                                               {156.0, 5.6, 3.9, 7.2}}};
constexpr std::array<TrunkRow, 17> kManRows{{{79.0, 8.0, 7.0, 4.0},
                                             {82.4, 14.2, 10.2, 7.0},
                                             {88.0, 15.6, 11.6, 8.8},
                                             {93.0, 15.1, 9.8, 9.4},
                                             {99.5, 14.8, 8.2, 9.8},
                                             {110.2, 14.2, 7.5, 10.2},
                                             {118.0, 14.8, 8.2, 10.8},
                                             {126.4, 16.6, 9.9, 11.4},
                                             {133.0, 18.0, 10.4, 10.4},
                                             {138.4, 18.0, 10.2, 8.4},
                                             {142.4, 16.8, 9.2, 6.2},
                                             {146.2, 13.8, 8.0, 4.6},
                                             {149.4, 10.0, 7.0, 4.4},
                                             {152.2, 7.4, 6.1, 5.2},
                                             {155.4, 6.5, 5.3, 6.6},
                                             {161.0, 6.5, 4.8, 7.6},
                                             {165.0, 6.6, 4.8, 8.0}}};

/// Piecewise linear through ascending (x, y), flat beyond the ends.
class Ramp {
  public:
    Ramp(std::initializer_list<Point> points) : points_(points) {}
    [[nodiscard]] double operator()(double x) const {
        if (x <= points_.front().x) return points_.front().y;
        for (std::size_t i = 0; i + 1 < points_.size(); ++i)
            if (x <= points_[i + 1].x) {
                const double t = (x - points_[i].x) / (points_[i + 1].x - points_[i].x);
                return points_[i].y + t * (points_[i + 1].y - points_[i].y);
            }
        return points_.back().y;
    }

  private:
    std::vector<Point> points_;
};

/// min(a, b), rounded where they are within k of each other; C2. The gradient is that of the rounded minimum.
FieldSample smooth_min(const FieldSample& a, const FieldSample& b, double k) {
    const double gap = std::abs(a.distance - b.distance);
    const FieldSample &less = a.distance <= b.distance ? a : b, &more = a.distance <= b.distance ? b : a;
    if (gap >= k) return less;
    const double h = (k - gap) / k, share = 0.5 * h * h;  // of the farther one
    return {less.distance - h * h * h * k / 6.0, less.gradient * (1.0 - share) + more.gradient * share};
}

const TrunkRow* rows_of(Figure figure) {
    return figure == Figure::Woman ? kWomanRows.data() : kManRows.data();
}

/// The reference figure's heights against those of this body.
Ramp height_ramp(Figure figure, const BodyFrame& f) {
    const BodyMeasures reference = *measures_of_size(figure == Figure::Woman ? "36" : "m");
    const BodyFrame r = body_frame(reference);
    const double top_reference = r.nape + 12.0, top = f.nape + 12.0 * f.stature / r.stature;
    return {{r.crotch, f.crotch}, {r.hip, f.hip},           {r.waist, f.waist}, {r.under_bust, f.under_bust},
            {r.bust, f.bust},     {r.shoulder, f.shoulder}, {r.nape, f.nape},   {top_reference, top}};
}

Loft trunk_loft(const BodyMeasures& m, const BodyFrame& f, const BodyScales& s) {
    const Ramp height = height_ramp(m.figure, f);
    const Ramp girth{{f.hip, s.hip},    {f.waist, s.waist},    {f.under_bust, s.under_bust},
                     {f.bust, s.chest}, {f.shoulder, s.chest}, {f.neck, s.neck}};
    const double reference_width = m.figure == Figure::Woman ? 36.7 : 41.0;
    const double shoulders = m[Measure::Biacromial] / reference_width;
    const double armpit = 0.5 * (f.bust + f.shoulder);
    const Ramp width{{f.bust, s.chest},
                     {armpit, 0.5 * (s.chest + shoulders)},
                     {f.shoulder - 2.0, shoulders},
                     {f.shoulder + 1.0, shoulders},
                     {f.nape, s.neck}};
    std::vector<Section> sections;
    const BodyMeasures reference = *measures_of_size(m.figure == Figure::Woman ? "36" : "m");
    const double reference_crotch = reference[Measure::CrotchHeight];
    for (std::size_t i = 0; i < kWomanRows.size(); ++i) {
        const TrunkRow& row = rows_of(m.figure)[i];
        double y = height(row.height);
        if (row.height < reference_crotch) y = f.crotch - (reference_crotch - row.height);
        if (i < 2) y += s.crotch_shift_cm;
        const double grow = girth(y);
        sections.push_back({y, row.side * (y >= f.bust ? width(y) : grow), row.back * grow, row.front * grow, 0, 0});
    }
    return {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, sections, Loft::Shape::Boxy};
}

}  // namespace

const char* body_part_name(BodyPart part) {
    static constexpr std::array<const char*, kBodyPartCount> kNames{"torso",    "hips",      "arm_left", "arm_right",
                                                                    "leg_left", "leg_right", "neck",     "head"};
    return kNames[static_cast<std::size_t>(part)];
}

BodyFrame body_frame(const BodyMeasures& m) {
    BodyFrame f{};
    f.stature = m[Measure::Stature];
    f.waist = m[Measure::WaistHeight];
    f.hip = m[Measure::HipHeight];
    f.crotch = m[Measure::CrotchHeight];
    f.knee = m[Measure::KneeHeight];
    f.bust = m[Measure::BustHeight];
    // the tape follows the hollow of the back; a head needs its room whatever it says
    f.nape = std::min(f.waist + 0.985 * m[Measure::NapeToWaist], 0.860 * f.stature);
    f.shoulder = f.nape - 0.031 * f.stature;
    f.under_bust = f.bust - std::min(0.042 * f.stature, 0.5 * (f.bust - f.waist));
    f.neck = f.nape + 0.019 * f.stature;
    f.thigh = f.crotch - 0.02 * f.stature;
    f.calf = 0.74 * f.knee;
    f.ankle = 0.24 * f.knee;
    const double angle = 44.0 * std::numbers::pi / 180.0;  // an A-pose: from hanging down
    f.arm_direction = normalised({std::sin(angle), -std::cos(angle), 0.06});
    const double ribs = m.figure == Figure::Woman ? 0.195 * m[Measure::UnderBust] : 0.165 * m[Measure::Bust];
    f.arm_root = {std::max(0.5 * m[Measure::Biacromial] - 3.0, ribs), f.shoulder - 0.028 * f.stature, -1.8};
    const double length = m[Measure::ArmLength] - 2.0;  // the tape starts on the shoulder, above the root
    f.upper_arm = 0.30 * length;
    f.elbow = 0.56 * length;
    f.wrist = length;
    return f;
}

BodyShape::BodyShape(const BodyMeasures& m, const BodyScales& s) : figure_(m.figure), frame_(body_frame(m)) {
    lofts_.push_back(trunk_loft(m, frame_, s));
    add_legs(s);
    add_arms(m, s);
    if (figure_ == Figure::Woman) add_breasts(s);
    add_head(s);
}

void BodyShape::add_legs(const BodyScales& s) {
    const BodyFrame& f = frame_;
    const Ramp girth{{f.ankle, s.ankle}, {f.calf, s.calf}, {f.knee, s.knee}, {f.thigh, s.thigh}};
    const double hip_side = lofts_[0].at(f.hip).side;
    const double widest = 0.5 * (1.03 * hip_side - kLegGap);
    const double thigh_side = std::min(8.3 * s.thigh, widest);
    const double thigh_depth = s.thigh, top_side = 0.46 * hip_side;
    const double hip_x = thigh_side + kLegGap;
    const double spread = 0.010 * f.stature;
    const double knee_x = hip_x + 0.4 * spread, ankle_x = hip_x + 1.2 * spread;
    const auto row = [&](double y, double side, double back, double front, double x, double z) {
        const double g = girth(y);
        return Section{y, side * g, back * g, front * g, x, z};
    };
    const double middle = 0.5 * (f.thigh + f.knee);
    std::vector<Section> sections{
        row(0.06 * f.knee, 3.0, 3.6, 3.6, ankle_x, -1.2),
        row(f.ankle, 2.9, 3.7, 3.3, ankle_x, -1.2),
        row(0.5 * (f.ankle + f.calf), 4.1, 5.1, 3.9, ankle_x - 0.25 * spread, -1.2),
        row(f.calf, 5.25, 6.5, 4.6, 0.6 * knee_x + 0.4 * ankle_x, -1.0),
        row(0.5 * (f.calf + f.knee), 5.1, 5.9, 5.0, knee_x + 0.2 * spread, -0.8),
        row(f.knee, 5.3, 5.3, 5.8, knee_x, -0.6),
        row(f.knee + 0.3 * (middle - f.knee), 5.6, 5.7, 6.2, knee_x, -0.5),
        {middle, 0.5 * (5.9 * s.knee + thigh_side * 1.12), 0.5 * (6.4 * s.knee + 9.2 * thigh_depth),
         0.5 * (6.6 * s.knee + 9.0 * thigh_depth), 0.5 * (hip_x + knee_x), -0.4},
        {f.thigh, thigh_side, 9.3 * thigh_depth, 9.1 * thigh_depth, hip_x, -0.6},
        {f.crotch + 2.5, 0.98 * thigh_side, 10.0 * thigh_depth, 8.6 * thigh_depth, hip_x, -0.9},
        {f.hip, top_side, 9.8 * thigh_depth, 7.6 * thigh_depth, 0.97 * hip_side - top_side, -1.4},
        {f.hip + 5.0, 0.75 * top_side, 7.0 * thigh_depth, 5.6 * thigh_depth, 0.88 * hip_side - 0.75 * top_side, -1.6}};
    lofts_.emplace_back(LoftFrame{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, sections, Loft::Shape::Ellipse);

    const double grow = f.stature / 168.0, x = ankle_x;
    const auto egg = [&](Vec3 centre, Vec3 radii, double blend) {
        const Vec3 at{x + centre.x * grow, centre.y * grow, centre.z * grow - 1.2};
        eggs_.push_back({at, radii * grow, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, blend, BodyPart::LegLeft});
    };
    egg({-0.1, 2.6, -1.6}, {3.0, 3.2, 4.0}, 3.0);
    egg({0.2, 3.3, 5.0}, {3.4, 3.9, 7.6}, 4.0);
    egg({0.5, 1.6, 11.0}, {4.3, 2.6, 5.6}, 4.0);
    egg({0.3, 1.0, 15.4}, {3.9, 1.7, 3.8}, 3.0);
}

void BodyShape::add_arms(const BodyMeasures& m, const BodyScales& s) {
    const BodyFrame& f = frame_;
    const double hand = 0.105 * m[Measure::Stature];
    const Ramp girth{{0.0, s.upper_arm}, {f.elbow, 0.7 * s.upper_arm + 0.3 * s.wrist}, {f.wrist, s.wrist}};
    // across: the side axis points to the front of the body, the front axis away from it
    const Vec3 forward = normalised(Vec3{0, 0, 1} - f.arm_direction * f.arm_direction.z);
    const LoftFrame frame{f.arm_root, f.arm_direction, forward, cross(forward, f.arm_direction)};
    const auto row = [&](double along, double side, double inner, double outer) {
        const double g = girth(along);
        return Section{along, side * g, inner * g, outer * g, 0, 0};
    };
    const std::vector<Section> sections{row(-4.0, 1.8, 1.6, 1.8),
                                        row(-1.8, 4.0, 3.6, 4.0),
                                        row(2.0, 4.9, 4.5, 4.9),
                                        row(0.14 * f.wrist, 4.9, 4.6, 4.7),
                                        row(f.upper_arm, 4.45, 4.2, 4.2),
                                        row(0.46 * f.wrist, 4.1, 3.9, 3.7),
                                        row(f.elbow, 3.85, 3.75, 3.55),
                                        row(0.66 * f.wrist, 3.95, 3.7, 3.5),
                                        row(0.85 * f.wrist, 3.1, 2.6, 2.6),
                                        row(f.wrist, 2.75, 2.1, 2.1),
                                        row(f.wrist + 0.20 * hand, 3.1, 2.1, 2.0),
                                        row(f.wrist + 0.42 * hand, 3.7, 2.1, 1.9),
                                        row(f.wrist + 0.65 * hand, 3.5, 1.9, 1.6),
                                        row(f.wrist + 0.85 * hand, 2.8, 1.5, 1.3)};
    lofts_.emplace_back(frame, sections, Loft::Shape::Ellipse);
    const auto at = [&](double along, double side, double front) {
        return f.arm_root + frame.along * along + frame.side * side + frame.front * front;
    };
    const double g = s.wrist;
    eggs_.push_back({at(f.wrist + 0.84 * hand, 0, -0.1), Vec3{2.8, 3.2, 1.4} * g, frame.side, frame.along, frame.front,
                     1.0, BodyPart::ArmLeft});
    const Vec3 thumb = normalised(frame.along * 0.9 + frame.side * 0.42 - frame.front * 0.15);
    const Vec3 thumb_side = normalised(frame.side - thumb * dot(frame.side, thumb));
    eggs_.push_back({at(f.wrist + 0.33 * hand, 3.2 * g, -0.5), Vec3{1.4, 4.6, 1.5} * g, thumb_side, thumb, frame.front,
                     3.0, BodyPart::ArmLeft});
}

void BodyShape::add_breasts(const BodyScales& s) {
    const Section chest = lofts_[0].at(frame_.bust);
    const double x = 0.57 * chest.side, surface = chest.front * 0.80;
    const double width = 6.9 * s.chest, depth = s.breast_cm;
    const double height = std::min(1.05 * width, 0.85 * (frame_.bust - frame_.under_bust) + 0.5);
    const Vec3 outward = normalised({0.20, -0.16, 1.0}), side = normalised(Vec3{1, 0, 0} - outward * outward.x);
    eggs_.push_back({{x, frame_.bust + 0.2, surface - 0.35 * depth},
                     {width, height, depth},
                     side,
                     cross(outward, side),
                     outward,
                     5.0,
                     BodyPart::Torso});
}

void BodyShape::add_head(const BodyScales& s) {
    const double grow = frame_.stature / 168.0, top = frame_.stature + s.crown_shift_cm;
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    eggs_.push_back({{0, top - 9.2 * grow, 1.8}, Vec3{7.3, 9.2, 9.1} * grow, x, y, z, 3.0, BodyPart::Head});
    const double tilt = 0.28;
    const Vec3 up{0, std::cos(tilt), -std::sin(tilt)}, front{0, std::sin(tilt), std::cos(tilt)};
    eggs_.push_back({{0, top - 12.9 * grow, 4.6}, Vec3{5.4, 7.8, 5.6} * grow, x, up, front, 3.5, BodyPart::Head});
}

double BodyShape::blend(std::size_t part) const {
    static constexpr std::array<double, 3> kLoftBlends{0.0, kTrunkToLeg, kTrunkToArm};
    return part < lofts_.size() ? kLoftBlends[part] : eggs_[part - lofts_.size()].blend;
}

FieldSample BodyShape::egg_sample(const Egg& egg, Vec3 p) {
    const Vec3 q = p - egg.centre;
    const Vec3 local{dot(q, egg.axis_x), dot(q, egg.axis_y), dot(q, egg.axis_z)};
    const Vec3 u{local.x / egg.radii.x, local.y / egg.radii.y, local.z / egg.radii.z};
    const Vec3 w{u.x / egg.radii.x, u.y / egg.radii.y, u.z / egg.radii.z};
    const double k0 = length(u), k1 = length(w);
    if (k1 < 1e-9) return {-std::min({egg.radii.x, egg.radii.y, egg.radii.z}), egg.axis_z};
    const Vec3 n = w * (1.0 / k1);
    return {k0 * (k0 - 1.0) / k1, egg.axis_x * n.x + egg.axis_y * n.y + egg.axis_z * n.z};
}

FieldSample BodyShape::part_sample(std::size_t part, Vec3 p) const {
    return part < lofts_.size() ? lofts_[part].sample(p) : egg_sample(eggs_[part - lofts_.size()], p);
}

BodyShape::Mask BodyShape::near(Vec3 p, double radius) const {
    p.x = std::abs(p.x);
    std::array<double, 32> distances{};
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < part_count(); ++i) {
        distances[i] = part_sample(i, p).distance;
        least = std::min(least, distances[i]);
    }
    Mask mask = 0;
    for (std::size_t i = 0; i < part_count(); ++i)
        if (distances[i] <= least + 3.0 * radius + kTrunkToArm) mask |= Mask{1} << i;
    return mask;
}

FieldSample BodyShape::sample(Vec3 p, Mask parts) const {
    const bool right = p.x < 0.0;
    p.x = std::abs(p.x);
    FieldSample sum{std::numeric_limits<double>::max(), {}};
    for (std::size_t i = 0; i < part_count(); ++i)
        if ((parts >> i & 1U) != 0) {
            const FieldSample part = part_sample(i, p);
            sum = blend(i) > 0.0 ? smooth_min(sum, part, blend(i)) : (part.distance < sum.distance ? part : sum);
        }
    // the soles are flat: the rounded maximum with the half space below the floor
    const FieldSample sole = smooth_min({-sum.distance, sum.gradient * -1.0}, {p.y, {0, 1, 0}}, 0.8);
    if (p.y < 8.0) sum = {-sole.distance, sole.gradient * -1.0};
    if (right) sum.gradient.x = -sum.gradient.x;
    return sum;
}

BodyPart BodyShape::part_at(Vec3 p) const {
    const bool right = p.x < 0.0;
    p.x = std::abs(p.x);
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < part_count(); ++i) {
        const double distance = part_sample(i, p).distance;
        if (distance >= least) continue;
        least = distance;
        nearest = i;
    }
    if (nearest == 1 || (nearest >= lofts_.size() && eggs_[nearest - lofts_.size()].part == BodyPart::LegLeft))
        return right ? BodyPart::LegRight : BodyPart::LegLeft;
    if (nearest == 2 || (nearest >= lofts_.size() && eggs_[nearest - lofts_.size()].part == BodyPart::ArmLeft))
        return right ? BodyPart::ArmRight : BodyPart::ArmLeft;
    if (nearest >= lofts_.size()) return eggs_[nearest - lofts_.size()].part;
    if (p.y < frame_.waist) return BodyPart::Hips;
    return p.y < frame_.nape ? BodyPart::Torso : BodyPart::Neck;
}

Vec3 BodyShape::low() const {
    const Vec3 top = high();
    return {-top.x, 0.0, -22.0};
}

Vec3 BodyShape::high() const {
    const Vec3 finger = frame_.arm_root + frame_.arm_direction * (frame_.wrist + 0.13 * frame_.stature);
    return {finger.x + 3.0, frame_.stature + 1.0, 26.0};
}

}  // namespace core
