#pragma once
// Reads a 3D model file of any usual format into one triangle mesh.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// Larger files are refused before a byte is read, so that memory stays bounded.
inline constexpr std::uintmax_t kLargestMeshFileBytes = 512ULL << 20;
/// A file that unfolds into more triangles than this is refused.
inline constexpr std::size_t kMostMeshTriangles = 20'000'000;

/// The file name extensions that a folder of models is searched for: lower case, without the dot, in alphabetical
/// order.
[[nodiscard]] const std::vector<std::string>& mesh_extensions();

/// Whether `path` ends in one of mesh_extensions(), in upper or lower case.
[[nodiscard]] bool has_mesh_extension(const std::filesystem::path& path);

/// The triangles of a model file: all its meshes, each placed as the file's nodes say, in the file's unit, with the
/// colours of its vertices or else of its materials (textures are not looked at). Equal corners are one vertex. Faces
/// that show nothing (a corner not finite, two corners in one place, fewer than three corners) are left out; vertices
/// that no face uses too. OFF is read by our own reader (off_reader.hpp), the other formats by assimp
/// in a process of its own (isolated.hpp), for there are damaged files on which it crashes or never ends.
/// Every fault is an Error with the path in `where`: FileMissing, FileUnreadable (no rights, a folder or device, too
/// large), UnknownFormat (extension, or an archive under another name), BadFormat (damaged, cut short, empty),
/// BadMesh (corner number out of range, more triangles than kMostMeshTriangles), EmptyMesh (no faces).
/// Files that the model names (materials, buffers) are read only where they are ordinary files within the size limit.
/// Time and memory are linear in the file, and the other process may have 256 MB and 64 times
/// the file's size, 4 GB and half of the machine's memory at most. Both
/// together took for 5,000,000 triangles: STL (250 MB) 830 MB, PLY (95 MB) and OFF (187 MB) 450 MB, OBJ (192 MB) 1.2
/// GB.
[[nodiscard]] Result<TriangleMesh> read_mesh(const std::filesystem::path& path);

}  // namespace core
