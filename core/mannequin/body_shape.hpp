#pragma once
// The form of a mannequin as a smooth distance field: lofts and ellipsoids that flow into each other.

#include <cstdint>
#include <vector>

#include "core/mannequin/body_measures.hpp"
#include "core/mannequin/loft.hpp"

namespace core {

enum class BodyPart { Torso, Hips, ArmLeft, ArmRight, LegLeft, LegRight, Neck, Head };
inline constexpr std::size_t kBodyPartCount = 8;
/// "torso", "hips" (from waist to crotch, where skirts sit), "arm_left" (the body's own left, +x), …
[[nodiscard]] const char* body_part_name(BodyPart part);

/// What the measures leave open and mannequin.cpp solves for: how much the sections of the reference figure grow.
struct BodyScales {
    double hip = 1, waist = 1, under_bust = 1, chest = 1, neck = 1, thigh = 1, knee = 1, calf = 1, ankle = 1,
           upper_arm = 1, wrist = 1;
    double breast_cm = 6.0;        ///< depth of the breasts' ellipsoids; women only
    double crotch_shift_cm = 0.0;  ///< of the trunk's lower end
    double crown_shift_cm = 0.0;   ///< of the head
};

/// Named places of a body, y up, facing +z, on or near the surface.
struct BodyFrame {
    double stature, nape, shoulder, bust, under_bust, waist, hip, thigh, crotch, knee, calf, ankle, neck;  ///< heights
    Vec3 arm_root, arm_direction;    ///< of the left arm, +x
    double upper_arm, elbow, wrist;  ///< along the arm, from its root
};
[[nodiscard]] BodyFrame body_frame(const BodyMeasures& measures);

class BodyShape {
  public:
    BodyShape(const BodyMeasures& measures, const BodyScales& scales);

    /// Parts that can matter near a place: a set of bits, one a part.
    using Mask = std::uint32_t;
    static constexpr Mask kAll = ~Mask{0};
    [[nodiscard]] Mask near(Vec3 p, double radius) const;

    /// Within a few centimetres of the surface close to the true distance; the same on both sides of x = 0.
    [[nodiscard]] FieldSample sample(Vec3 p, Mask parts = kAll) const;
    [[nodiscard]] BodyPart part_at(Vec3 p) const;

    [[nodiscard]] const Loft& trunk() const { return lofts_[0]; }
    [[nodiscard]] const Loft& leg() const { return lofts_[1]; }  ///< left
    [[nodiscard]] const Loft& arm() const { return lofts_[2]; }  ///< left

    /// Corners of a box that holds the body.
    [[nodiscard]] Vec3 low() const;
    [[nodiscard]] Vec3 high() const;

  private:
    struct Egg {
        Vec3 centre, radii;
        Vec3 axis_x{1, 0, 0}, axis_y{0, 1, 0}, axis_z{0, 0, 1};
        double blend = 0.0;
        BodyPart part = BodyPart::Torso;
    };
    [[nodiscard]] static FieldSample egg_sample(const Egg& egg, Vec3 p);
    [[nodiscard]] FieldSample part_sample(std::size_t part, Vec3 p) const;
    [[nodiscard]] std::size_t part_count() const { return lofts_.size() + eggs_.size(); }
    [[nodiscard]] double blend(std::size_t part) const;

    void add_legs(const BodyScales& s);
    void add_arms(const BodyMeasures& m, const BodyScales& s);
    void add_head(const BodyScales& s);
    void add_breasts(const BodyScales& s);

    Figure figure_;
    BodyFrame frame_;
    std::vector<Loft> lofts_;  // trunk, leg, arm
    std::vector<Egg> eggs_;
};

}  // namespace core
