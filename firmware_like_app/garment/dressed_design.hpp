#pragma once
// A saved design, made again from its steps: what an export and a gallery's picture are taken from.

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/design.hpp"

namespace app {

/// The mesh of a model of the collection by the name that a design calls it; any unit.
using ModelSource = std::function<core::Result<core::TriangleMesh>(const std::string& model)>;

/// An object of the design where it is worn, in centimetres.
struct PlacedMesh {
    std::string name;
    core::TriangleMesh mesh;
};

struct DressedDesign {
    core::Design design;
    core::Garment garment;  ///< with texture coordinates
    core::DesignLook look;
    core::DressForm form;  ///< that it is worn by
    std::vector<PlacedMesh> objects;
    std::vector<std::string> faults;  ///< steps, pieces and objects that could not be made; a sentence each
};

/// Takes all steps, on the design's own body or the one it was changed to last, fills and fits all layers. Faults are
/// passed over and named. Some hundred milliseconds a layer; looks at `stop` between layers. ErrorCode::BadArgument
/// when the measures fit no body, ErrorCode::Cancelled.
[[nodiscard]] core::Result<DressedDesign> dress(const core::Design& design, const core::FormSource& bodies = {},
                                                const ModelSource& models = {}, const std::stop_token& stop = {});

/// The model moved: its middle (of its bounding box) at `at`, `scale` centimetres a unit, turned about x, then y, then
/// z.
[[nodiscard]] core::TriangleMesh placed_mesh(const core::PlacedObject& object, const core::TriangleMesh& model);

}  // namespace app
