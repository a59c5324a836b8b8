#pragma once
// Meshes with materials as binary glTF 2.0 files.

#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/mesh/quad_mesh.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// One mesh under its name, in one colour. Lengths in centimetres; the file has metres, as glTF asks.
struct GlbMesh {
    std::string name;
    const QuadMesh* mesh = nullptr;
    std::size_t first = 0, count = 0;  ///< quads of the mesh that belong to it
    Rgb colour{};
    bool two_sided = true;                              ///< cloth is
    const std::vector<QuadTexture>* texture = nullptr;  ///< of every quad of the mesh, in centimetres
    const TriangleMesh* triangles = nullptr;            ///< in place of `mesh`: all of it, in one colour
};

/// A node, a mesh and a material each, with smooth normals; quads become triangles. Texture coordinates are in metres
/// and run down, as glTF's pictures do: a picture that repeats covers one metre of cloth. The same meshes give the same
/// bytes. ErrorCode::BadMesh for a face that names a vertex that does not exist or is not in the mesh;
/// ErrorCode::WriteFailed if the stream gives up.
[[nodiscard]] Result<void> write_glb(std::ostream& out, std::span<const GlbMesh> meshes);
[[nodiscard]] Result<void> write_glb_file(const std::filesystem::path& path, std::span<const GlbMesh> meshes);

}  // namespace core
