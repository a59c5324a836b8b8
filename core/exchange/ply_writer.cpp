#include "core/exchange/ply_writer.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <string>

namespace core {
namespace {

void put_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xFF));
}

void put_float(std::string& bytes, double value) {
    put_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

std::string header(const TriangleMesh& mesh) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment made by Croquis\n";
    text += "element vertex " + std::to_string(mesh.vertices.size()) +
            "\nproperty float x\nproperty float y\nproperty float z\n";
    if (!mesh.colours.empty()) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    text += "element face " + std::to_string(mesh.triangles.size()) +
            "\nproperty list uchar uint vertex_indices\nend_header\n";
    return text;
}

}  // namespace

Result<void> write_ply(std::ostream& out, const TriangleMesh& mesh) {
    if (!mesh.colours.empty() && mesh.colours.size() != mesh.vertices.size())
        return unexpected(ErrorCode::BadMesh, "The mesh must have one colour a vertex, or none.");
    for (const auto& t : mesh.triangles)
        if (std::max({t[0], t[1], t[2]}) >= mesh.vertices.size())
            return unexpected(ErrorCode::BadMesh, "A triangle of the mesh names a vertex that does not exist.");
    std::string bytes = header(mesh);
    bytes.reserve(bytes.size() + mesh.vertices.size() * 15 + mesh.triangles.size() * 13);
    const std::size_t data = bytes.size();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        put_float(bytes, mesh.vertices[i].x);
        put_float(bytes, mesh.vertices[i].y);
        put_float(bytes, mesh.vertices[i].z);
        if (mesh.colours.empty()) continue;
        for (const std::uint8_t channel : {mesh.colours[i].r, mesh.colours[i].g, mesh.colours[i].b})
            bytes.push_back(static_cast<char>(channel));
    }
    // assimp takes a line feed after the header for one more end of line and then reads everything a byte too late; the
    // last bit of one coordinate is a small price.
    if (bytes.size() > data && bytes[data] == '\n') bytes[data] = '\v';
    for (const auto& t : mesh.triangles) {
        bytes.push_back(3);
        for (const std::uint32_t index : t) put_u32(bytes, index);
    }
    if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
        return unexpected(ErrorCode::WriteFailed, "The mesh could not be written; check the free space.");
    return {};
}

Result<void> write_ply_file(const std::filesystem::path& path, const TriangleMesh& mesh) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (!out)
        return unexpected(ErrorCode::WriteFailed, "The file cannot be opened for writing; check the folder's rights.",
                          path.string());
    Result<void> written = write_ply(out, mesh);
    if (!written) return unexpected(written.error().code, written.error().message, path.string());
    return {};
}

}  // namespace core
