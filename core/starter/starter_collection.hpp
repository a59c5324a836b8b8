#pragma once
// The built-in starter collection: labelled, coloured models made by code, so that a fresh kiosk has something to find.
//
//     for (const core::StarterModel& model : core::starter_collection()) use(model.mesh, model.class_name);

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

struct StarterModel {
    std::string name;        ///< for people, unique: "Rocking chair"
    std::string class_name;  ///< a category of everyday drawings: "chair"
    TriangleMesh mesh;       ///< one colour a vertex; made of closed parts facing outward, which may overlap
};

/// All models, grouped by class, always the same in the same order. y is up; what has a head or a prow faces +z, so
/// that its profile is seen from +x and -x; flat things (a key, a guitar) show their face to +z. Units differ by model.
/// Takes a few seconds on one core, and some 50 MB.
[[nodiscard]] std::vector<StarterModel> starter_collection();

/// Writes the collection into a folder, which is made if it is missing: one `CLASS-NAME.ply` a model (lower case, words
/// joined by '-') and `starter.list` with a line `file<TAB>class` each. Files of the same names are replaced.
/// ErrorCode::WriteFailed names the file that could not be written.
[[nodiscard]] Result<void> write_starter_collection(const std::filesystem::path& folder);

}  // namespace core
