#pragma once
// Rounded sections along a straight axis, as a distance field: the trunk and the limbs of a mannequin.

#include <vector>

#include "core/geometry/point.hpp"
#include "core/mesh/field_sample.hpp"

namespace core {

/// One section, across the axis: superellipses of a common width, one in front, one behind.
struct Section {
    double along = 0.0;                     ///< place on the axis
    double side = 1.0;                      ///< half width
    double back = 1.0, front = 1.0;         ///< depths from the middle
    double middle_x = 0.0, middle_z = 0.0;  ///< of the section, from the axis
};

/// Directions of unit length, perpendicular to each other.
struct LoftFrame {
    Vec3 origin, along, side, front;
};

class Loft {
  public:
    enum class Shape { Ellipse, Boxy };  ///< exponent 2, 2.25

    /// `sections` in ascending order, two at least, are joined by a smooth curve that passes near them. Ends are flat.
    Loft(LoftFrame frame, const std::vector<Section>& sections, Shape shape);

    /// Exact to first order near the surface.
    [[nodiscard]] FieldSample sample(Vec3 p) const;
    [[nodiscard]] const LoftFrame& frame() const { return frame_; }
    /// The smoothed section at a place on the axis.
    [[nodiscard]] Section at(double along) const;
    /// The middle of that section, in space.
    [[nodiscard]] Vec3 middle(double along) const;

  private:
    struct Sloped {
        Section value, slope;
    };
    [[nodiscard]] Sloped sloped_at(double along) const;

    LoftFrame frame_;
    Shape shape_;
    double first_ = 0.0, last_ = 0.0, step_ = 1.0;
    std::vector<Section> controls_;  // of a uniform cubic B-spline, one a step, one more at either end
};

}  // namespace core
