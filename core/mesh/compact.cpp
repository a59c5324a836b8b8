#include "core/mesh/compact.hpp"

namespace core {

TriangleMesh without_unused_vertices(const TriangleMesh& mesh) {
    constexpr std::uint32_t kUnused = UINT32_MAX;
    std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused);
    for (const auto& triangle : mesh.triangles) {
        for (const std::uint32_t v : triangle) place[v] = 0;
    }
    TriangleMesh out;
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (place[v] == kUnused) continue;
        place[v] = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(mesh.vertices[v]);
        if (!mesh.colours.empty()) out.colours.push_back(mesh.colours[v]);
    }
    for (const auto& t : mesh.triangles) out.triangles.push_back({place[t[0]], place[t[1]], place[t[2]]});
    return out;
}

}  // namespace core
