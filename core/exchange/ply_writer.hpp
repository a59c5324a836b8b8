#pragma once
// Meshes as PLY files (Turk 1994): the small format that keeps a colour for every vertex, unlike OBJ.

#include <filesystem>
#include <iosfwd>

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// Writes binary little-endian PLY: float x y z and, if the mesh has colours, uchar red green blue a vertex; triangles
/// as lists. Positions are rounded to float. An empty mesh gives a valid file without faces. ErrorCode::BadMesh if
/// there are colours but not one a vertex, or an index points past the vertices; ErrorCode::WriteFailed if the stream
/// gives up.
[[nodiscard]] Result<void> write_ply(std::ostream& out, const TriangleMesh& mesh);

/// The same into a file, replaced if it exists. The error names the file.
[[nodiscard]] Result<void> write_ply_file(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace core
