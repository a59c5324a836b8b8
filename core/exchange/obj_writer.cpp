#include "core/exchange/obj_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <map>
#include <ostream>
#include <tuple>
#include <vector>

namespace core {
namespace {

template <typename Number>
void put(std::string& text, Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    text.append(digits.data(), end.ptr);
}

/// A line of numbers, without minus signs before 0.
void put_line(std::string& text, const char* head, std::initializer_list<double> numbers) {
    text += head;
    for (const double number : numbers) {
        text += ' ';
        put(text, number + 0.0);
    }
    text += '\n';
}

/// Numbers the places of a texture, each once for a vertex.
class TexturePlaces {
  public:
    std::uint64_t number(std::uint32_t vertex, Point at, std::string& text) {
        const auto [found, fresh] = known_.emplace(std::tuple(vertex, at.x, at.y), known_.size() + 1);
        if (fresh) put_line(text, "vt", {at.x, at.y});
        return found->second;
    }

  private:
    std::map<std::tuple<std::uint32_t, double, double>, std::uint64_t> known_;
};

/// `numbers`: of the corners' texture places, or 0 for none.
void put_quad(std::string& text, const Quad& quad, const std::array<std::uint64_t, 4>& numbers) {
    text += 'f';
    for (std::size_t k = 0; k < 4; ++k) {
        text += ' ';
        put(text, std::uint64_t{quad[k]} + 1);
        if (numbers[k] == 0) continue;
        text += '/';
        put(text, numbers[k]);
    }
    text += '\n';
}

std::string group_line(const std::string& name) {
    std::string line = "g " + name + "\n";
    std::replace(line.begin() + 2, line.end() - 1, ' ', '_');
    return line;
}

/// `first`: the number of its first vertex.
void put_triangles(std::string& faces, const TriangleGroup& group, std::uint64_t first) {
    if (!group.name.empty()) faces += group_line(group.name);
    for (const auto& triangle : group.mesh->triangles) {
        faces += 'f';
        for (const std::uint32_t corner : triangle) {
            faces += ' ';
            put(faces, first + corner);
        }
        faces += '\n';
    }
}

Result<void> check_triangles(std::span<const TriangleGroup> groups) {
    for (const TriangleGroup& group : groups)
        for (const auto& t : group.mesh->triangles)
            if (*std::max_element(t.begin(), t.end()) >= group.mesh->vertices.size())
                return unexpected(ErrorCode::BadMesh, "A triangle of the mesh names a vertex that does not exist.");
    return {};
}

}  // namespace

Result<void> write_obj(std::ostream& out, const QuadMesh& mesh, std::span<const QuadGroup> groups,
                       std::span<const QuadTexture> texture, std::span<const TriangleGroup> others) {
    if (Result<void> sound = check_triangles(others); !sound) return sound;
    for (const Quad& quad : mesh.quads)
        if (*std::max_element(quad.begin(), quad.end()) >= mesh.vertices.size())
            return unexpected(ErrorCode::BadMesh, "A quad of the mesh names a vertex that does not exist.");
    if (!texture.empty() && texture.size() != mesh.quads.size())
        return unexpected(ErrorCode::BadMesh, "Some quads of the mesh have texture coordinates, others none.");
    std::string text = "# made by Croquis\n", faces;
    for (const Vec3& v : mesh.vertices) put_line(text, "v", {v.x, v.y, v.z});
    std::uint64_t first = mesh.vertices.size() + 1;
    for (const TriangleGroup& group : others)
        for (const Vec3& v : group.mesh->vertices) put_line(text, "v", {v.x, v.y, v.z});
    const std::vector<QuadGroup> all{{"", 0, mesh.quads.size()}};
    TexturePlaces places;
    for (const QuadGroup& group : groups.empty() ? std::span<const QuadGroup>(all) : groups) {
        if (!group.name.empty()) faces += group_line(group.name);
        for (std::size_t i = group.first; i < group.first + group.count; ++i) {
            std::array<std::uint64_t, 4> numbers{};
            for (std::size_t k = 0; k < 4 && !texture.empty(); ++k)
                numbers[k] = places.number(mesh.quads[i][k], texture[i][k], text);
            put_quad(faces, mesh.quads[i], numbers);
        }
    }
    for (const TriangleGroup& group : others) {
        put_triangles(faces, group, first);
        first += group.mesh->vertices.size();
    }
    text += faces;
    if (!out.write(text.data(), static_cast<std::streamsize>(text.size())).flush())
        return unexpected(ErrorCode::WriteFailed, "The mesh could not be written; check the free space.");
    return {};
}

Result<void> write_obj_file(const std::filesystem::path& path, const QuadMesh& mesh, std::span<const QuadGroup> groups,
                            std::span<const QuadTexture> texture) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (!out)
        return unexpected(ErrorCode::WriteFailed, "The file cannot be opened for writing; check the folder's rights.",
                          path.string());
    Result<void> written = write_obj(out, mesh, groups, texture);
    if (!written) return unexpected(written.error().code, written.error().message, path.string());
    return {};
}

}  // namespace core
