#pragma once
// The surface of a body by its parts: which part is near, and where the nearest place of some of them is.

#include <optional>
#include <unordered_map>
#include <vector>

#include "core/mannequin/dress_form.hpp"
#include "core/mannequin/part_set.hpp"

namespace core {

struct PartPlace {
    Vec3 place, outward;  ///< the middle of the nearest triangle, its normal
    BodyPart part = BodyPart::Torso;
    double distance = 0.0;
};

class PartSurface {
  public:
    /// Empty when the form's parts are not known.
    explicit PartSurface(const DressForm& form);

    [[nodiscard]] bool empty() const { return faces_.empty(); }

    /// The nearest triangle of these parts, by its middle, within `reach`. Some microseconds near the surface.
    [[nodiscard]] std::optional<PartPlace> nearest(Vec3 p, PartSet parts, double reach) const;

    /// The parts that a piece of cloth with these points lies over: nearest to a twentieth of them at least.
    [[nodiscard]] PartSet parts_under(const std::vector<Vec3>& points) const;

    /// Places inside a part, from its upper to its lower end: the middles of ten slices of it. Empty for a part that
    /// the body does not have.
    [[nodiscard]] std::vector<Vec3> centre_line(BodyPart part) const;

  private:
    struct Face {
        Vec3 middle, normal;
        BodyPart part;
    };
    [[nodiscard]] static std::int64_t key(int x, int y, int z) {
        return (static_cast<std::int64_t>(x + 4096) << 26) | (static_cast<std::int64_t>(y + 4096) << 13) | (z + 4096);
    }
    std::vector<Face> faces_;
    std::unordered_map<std::int64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace core
