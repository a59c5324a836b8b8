#pragma once
// Where a model that was found goes on the figure at first: a hat on the head, a bag into the hand. From there the
// designer moves it.

#include <string>
#include <vector>

#include "core/garment/design.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "core/views/camera.hpp"

namespace app {

/// A model of the collection as the visitor found it.
struct FoundObject {
    std::string name;        ///< as the visitor reads it
    std::string model;       ///< as the design calls it, see models_of_index
    std::string class_name;  ///< may be empty
    core::Camera camera;     ///< the view that matched: it is placed as it was drawn
};

/// Above which a model is no object to wear but a mistake; its size on the figure is kept between these.
inline constexpr double kLeastObject_cm = 1, kMostObject_cm = 200;

/// `model` in any unit. Words of class and name tell where: hats, glasses, necklaces, shoes, watches, belts, rucksacks;
/// all else is held in the left hand. The drawing's up is up; its side is seen from the front, or for shoes from the
/// side. `taken`: names of the design's other objects; the new one gets a number where its name is among them. A form
/// without landmarks gets what it would have at the places of an upright body of its height.
[[nodiscard]] core::PlacedObject put_on(const FoundObject& found, const core::TriangleMesh& model,
                                        const core::DressForm& form, const std::vector<core::PlacedObject>& taken);

/// The longest side of the model's box as it lies in its file; 0 without vertices.
[[nodiscard]] double longest_side(const core::TriangleMesh& model);

}  // namespace app
