#include "core/exchange/glb_writer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <ostream>
#include <tuple>
#include <utility>
#include <vector>

namespace core {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;

void put_u32(std::string& bytes, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift & 0xFF));
}
void put_float(std::string& bytes, double value) {
    put_u32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

/// glTF colours are linear.
double linear(std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// The vertices of a part in order of first use; corners at one vertex with unlike texture are vertices of their own.
struct Corners {
    std::vector<std::uint32_t> number;  ///< of each corner of each quad of the part
    std::vector<std::uint32_t> vertex;  ///< of the mesh
    std::vector<Point> texture;
};

Corners corners_of(const GlbMesh& part) {
    Corners out;
    std::map<std::tuple<std::uint32_t, double, double>, std::uint32_t> known;
    for (std::size_t i = part.first; i < part.first + part.count; ++i)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t v = part.mesh->quads[i][k];
            const Point at = part.texture != nullptr ? (*part.texture)[i][k] : Point{};
            const auto [found, fresh] =
                known.emplace(std::tuple(v, at.x, at.y), static_cast<std::uint32_t>(out.vertex.size()));
            if (fresh) {
                out.vertex.push_back(v);
                out.texture.push_back(at);
            }
            out.number.push_back(found->second);
        }
    return out;
}

/// Of each vertex of the corners: the sum over the quads of the part that have it.
std::vector<Vec3> normals_of(const GlbMesh& part, const Corners& corners) {
    std::vector<Vec3> sum(part.mesh->vertices.size()), out;
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
        const Quad& q = part.mesh->quads[i];
        const auto& v = part.mesh->vertices;
        const Vec3 n = cross(v[q[2]] - v[q[0]], v[q[3]] - v[q[1]]);
        for (const std::uint32_t corner : q) sum[corner] = sum[corner] + n;
    }
    for (const std::uint32_t v : corners.vertex) out.push_back(sum[v]);
    return out;
}

/// Vertices and corners of a mesh of triangles, as Corners has them; normals by area.
std::vector<Vec3> normals_of(const TriangleMesh& mesh) {
    std::vector<Vec3> sum(mesh.vertices.size());
    for (const auto& t : mesh.triangles) {
        const Vec3 n = cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        for (const std::uint32_t corner : t) sum[corner] = sum[corner] + n;
    }
    return sum;
}

/// Grows the binary part and the lists that describe it.
class Document {
  public:
    void add(const GlbMesh& part) {
        if (part.triangles != nullptr) return add_triangles(part);
        const Corners corners = corners_of(part);
        const std::vector<Vec3> normals = normals_of(part, corners);
        std::string indices;
        for (std::size_t i = 0; i < part.count; ++i)
            for (const std::size_t k : {0, 1, 2, 0, 2, 3}) put_u32(indices, corners.number[4 * i + k]);
        Json attributes{{"POSITION", add_places(part.mesh->vertices, corners.vertex)},
                        {"NORMAL", add_normals(normals)}};
        if (part.texture != nullptr) attributes["TEXCOORD_0"] = add_texture(corners.texture);
        add_node(part, std::move(attributes), indices);
    }

    std::string finish() {
        json_["buffers"] = Json::array({{{"byteLength", bytes_.size()}}});
        std::string text = json_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string file = "glTF";
        put_u32(file, 2);
        put_u32(file, static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + bytes_.size()));
        put_u32(file, static_cast<std::uint32_t>(text.size()));
        file += "JSON" + text;
        put_u32(file, static_cast<std::uint32_t>(bytes_.size()));
        file += "BIN";
        file.push_back('\0');
        return file + bytes_;
    }

  private:
    void add_triangles(const GlbMesh& part) {
        std::vector<std::uint32_t> all(part.triangles->vertices.size());
        std::iota(all.begin(), all.end(), 0U);
        std::string indices;
        for (const auto& t : part.triangles->triangles)
            for (const std::uint32_t corner : t) put_u32(indices, corner);
        add_node(part,
                 {{"POSITION", add_places(part.triangles->vertices, all)},
                  {"NORMAL", add_normals(normals_of(*part.triangles))}},
                 indices);
    }

    void add_node(const GlbMesh& part, Json attributes, const std::string& indices) {
        const std::size_t material = json_["materials"].size();
        json_["materials"].push_back(
            {{"name", part.name},
             {"pbrMetallicRoughness",
              {{"baseColorFactor", {linear(part.colour.r), linear(part.colour.g), linear(part.colour.b), 1.0}},
               {"metallicFactor", 0.0},
               {"roughnessFactor", 0.9}}},
             {"doubleSided", part.two_sided}});
        const Json primitive{
            {"attributes", std::move(attributes)},
            {"indices", add_accessor(indices, kUnsignedInt, "SCALAR", indices.size() / 4, kElementBuffer)},
            {"material", material}};
        json_["meshes"].push_back({{"name", part.name}, {"primitives", Json::array({primitive})}});
        json_["nodes"].push_back({{"name", part.name}, {"mesh", material}});
        json_["scenes"][0]["nodes"].push_back(material);
    }

    std::size_t add_accessor(const std::string& data, int component, const char* type, std::size_t count, int target) {
        const std::size_t view = json_["bufferViews"].size();
        json_["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", data.size()}, {"target", target}});
        bytes_ += data;
        json_["accessors"].push_back(
            {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", type}});
        return json_["accessors"].size() - 1;
    }

    std::size_t add_places(const std::vector<Vec3>& places, const std::vector<std::uint32_t>& used) {
        std::string data;
        std::array<float, 3> low{}, high{};
        for (std::size_t i = 0; i < used.size(); ++i) {
            const Vec3 p = places[used[i]] * 0.01;
            const std::array<float, 3> place{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
            for (std::size_t k = 0; k < 3; ++k) {
                low[k] = i == 0 ? place[k] : std::min(low[k], place[k]);
                high[k] = i == 0 ? place[k] : std::max(high[k], place[k]);
                put_float(data, static_cast<double>(place[k]));
            }
        }
        const std::size_t accessor = add_accessor(data, kFloat, "VEC3", used.size(), kArrayBuffer);
        json_["accessors"][accessor]["min"] = low;
        json_["accessors"][accessor]["max"] = high;
        return accessor;
    }

    std::size_t add_texture(const std::vector<Point>& texture) {
        std::string data;
        for (const Point at : texture) {
            put_float(data, at.x * 0.01);
            put_float(data, -at.y * 0.01);
        }
        return add_accessor(data, kFloat, "VEC2", texture.size(), kArrayBuffer);
    }

    std::size_t add_normals(const std::vector<Vec3>& normals) {
        std::string data;
        for (const Vec3& normal : normals) {
            const Vec3 n = length(normal) > 0.0 ? normalised(normal) : Vec3{0, 1, 0};
            for (const double c : {n.x, n.y, n.z}) put_float(data, c);
        }
        return add_accessor(data, kFloat, "VEC3", normals.size(), kArrayBuffer);
    }

    Json json_{{"asset", {{"version", "2.0"}, {"generator", "Croquis"}}},
               {"scene", 0},
               {"scenes", Json::array({{{"nodes", Json::array()}}})},
               {"nodes", Json::array()},
               {"meshes", Json::array()},
               {"materials", Json::array()},
               {"accessors", Json::array()},
               {"bufferViews", Json::array()}};
    std::string bytes_;
};

}  // namespace

Result<void> write_glb(std::ostream& out, std::span<const GlbMesh> meshes) {
    Document document;
    for (const GlbMesh& part : meshes) {
        if (part.triangles != nullptr) {
            for (const auto& t : part.triangles->triangles)
                if (*std::max_element(t.begin(), t.end()) >= part.triangles->vertices.size())
                    return unexpected(ErrorCode::BadMesh, "A triangle of the mesh names a vertex that does not exist.");
            if (!part.triangles->triangles.empty()) document.add(part);
            continue;
        }
        if (part.first + part.count > part.mesh->quads.size())
            return unexpected(ErrorCode::BadMesh, "The mesh \"" + part.name + "\" has fewer quads than it should.");
        if (part.texture != nullptr && part.texture->size() != part.mesh->quads.size())
            return unexpected(ErrorCode::BadMesh,
                              "Some quads of the mesh \"" + part.name + "\" have no texture coordinates.");
        for (std::size_t i = part.first; i < part.first + part.count; ++i)
            if (*std::max_element(part.mesh->quads[i].begin(), part.mesh->quads[i].end()) >= part.mesh->vertices.size())
                return unexpected(ErrorCode::BadMesh, "A quad of the mesh names a vertex that does not exist.");
        if (part.count > 0) document.add(part);
    }
    const std::string bytes = document.finish();
    if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
        return unexpected(ErrorCode::WriteFailed, "The mesh could not be written; check the free space.");
    return {};
}

Result<void> write_glb_file(const std::filesystem::path& path, std::span<const GlbMesh> meshes) {
    std::ofstream out(path, std::ios::binary | std::ios::trunc);
    if (!out)
        return unexpected(ErrorCode::WriteFailed, "The file cannot be opened for writing; check the folder's rights.",
                          path.string());
    Result<void> written = write_glb(out, meshes);
    if (!written) return unexpected(written.error().code, written.error().message, path.string());
    return {};
}

}  // namespace core
