#include "core/exchange/obj_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <string_view>
#include <vector>

namespace core {
namespace {

template <typename Number>
void put(std::string& text, Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end.ptr);
}

void put_quad(std::string& text, const Quad& quad) {
    text += 'f';
    for (const std::uint32_t v : quad) {
        text += ' ';
        put(text, std::uint64_t{v} + 1);
    }
    text += '\n';
}

std::string group_line(const std::string& name) {
    std::string line = "g " + name + "\n";
    std::replace(line.begin() + 2, line.end() - 1, ' ', '_');
    return line;
}

}  // namespace

Result<void> write_obj(std::ostream& out, const QuadMesh& mesh, std::span<const QuadGroup> groups) {
    for (const Quad& quad : mesh.quads)
        if (*std::max_element(quad.begin(), quad.end()) >= mesh.vertices.size())
            return unexpected(ErrorCode::BadMesh, "A quad of the mesh names a vertex that does not exist.");
    std::string text = "# made by Croquis\n";
    for (const Vec3& v : mesh.vertices) {
        text += 'v';
        for (const double coordinate : {v.x, v.y, v.z}) {
            text += ' ';
            put(text, coordinate + 0.0);  // no minus sign before 0
        }
        text += '\n';
    }
    const std::vector<QuadGroup> all{{"", 0, mesh.quads.size()}};
    for (const QuadGroup& group : groups.empty() ? std::span<const QuadGroup>(all) : groups) {
        if (!group.name.empty()) text += group_line(group.name);
        for (std::size_t i = 0; i < group.count; ++i) put_quad(text, mesh.quads[group.first + i]);
    }
    if (!out.write(text.data(), static_cast<std::streamsize>(text.size())).flush())
        return unexpected(ErrorCode::WriteFailed, "The mesh could not be written; check the free space.");
    return {};
}

Result<void> write_obj_file(const std::filesystem::path& path, const QuadMesh& mesh,
                            std::span<const QuadGroup> groups) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (!out)
        return unexpected(ErrorCode::WriteFailed, "The file cannot be opened for writing; check the folder's rights.",
                          path.string());
    Result<void> written = write_obj(out, mesh, groups);
    if (!written) return unexpected(written.error().code, written.error().message, path.string());
    return {};
}

}  // namespace core
