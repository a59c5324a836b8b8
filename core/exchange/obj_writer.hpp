#pragma once
// Quad meshes as Wavefront OBJ files, one named group a piece.

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/mesh/quad_mesh.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// A stretch of a mesh's quads under one name.
struct QuadGroup {
    std::string name;  ///< empty: no group line is written
    std::size_t first = 0, count = 0;
};

/// A mesh of triangles that is written beside the quads, in the same unit.
struct TriangleGroup {
    std::string name;
    const TriangleMesh* mesh = nullptr;
};

/// Writes vertices with as many digits as give the same number back, then the quads of each group. Without groups all
/// quads are written. `texture`: of every quad of the mesh, written as it is, in the mesh's unit, or none. Spaces in a
/// name become underscores. The same mesh gives the same bytes. ErrorCode::BadMesh when a face names a vertex that does
/// not exist or has no texture where others have; ErrorCode::WriteFailed if the stream gives up.
[[nodiscard]] Result<void> write_obj(std::ostream& out, const QuadMesh& mesh, std::span<const QuadGroup> groups = {},
                                     std::span<const QuadTexture> texture = {},
                                     std::span<const TriangleGroup> others = {});

/// The same into a file, replaced if it exists. The error names the file.
[[nodiscard]] Result<void> write_obj_file(const std::filesystem::path& path, const QuadMesh& mesh,
                                          std::span<const QuadGroup> groups = {},
                                          std::span<const QuadTexture> texture = {});

}  // namespace core
