#include "core/garment/sewing.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>

#include "core/garment/design.hpp"
#include "core/mesh/nearest_on_triangle.hpp"

namespace core {
namespace {

constexpr double kReach_cm = 1.0;     // a pocket is drawn half a centimetre off, and fitting adds a clearance
constexpr double kPatchShare = 0.8;   // of a sheet's hem
constexpr double kAlongHem_cm = 1.5;  // from a hem below

/// Quads with a ball around each, so that most are passed over by one comparison.
struct Sheet {
    const QuadMesh* mesh = nullptr;
    std::uint32_t first = 0;  // of its vertices in the joined mesh
    std::vector<Vec3> middle;
    std::vector<double> radius;
    std::vector<Vec3> hem;  // its vertices

    Sheet(const Cloth& cloth, std::uint32_t first_vertex) : mesh(&cloth.mesh), first(first_vertex) {
        for (const Quad& q : mesh->quads) {
            Vec3 sum;
            for (const std::uint32_t v : q) sum = sum + mesh->vertices[v];
            middle.push_back(sum * 0.25);
            double most = 0;
            for (const std::uint32_t v : q) most = std::max(most, length(mesh->vertices[v] - middle.back()));
            radius.push_back(most);
        }
    }

    /// The nearest triangle within reach, with the distance.
    void nearest(Vec3 p, double& least, std::optional<SewnVertex>& found) const {
        for (std::size_t k = 0; k < middle.size(); ++k) {
            const double near = least + radius[k];
            const Vec3 d = middle[k] - p;
            if (dot(d, d) > near * near) continue;
            const Quad& q = mesh->quads[k];
            for (const std::array<std::uint32_t, 3>& t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
                const Vec3 a = mesh->vertices[t[0]], b = mesh->vertices[t[1]], c = mesh->vertices[t[2]];
                const Vec3 on = nearest_on_triangle(p, a, b, c).point;
                if (const double away = length(on - p); away < least) {
                    least = away;
                    found = held_at(p, on, t);
                }
            }
        }
    }

    [[nodiscard]] SewnVertex held_at(Vec3 p, Vec3 on, const std::array<std::uint32_t, 3>& t) const {
        const Vec3 a = mesh->vertices[t[0]], b = mesh->vertices[t[1]], c = mesh->vertices[t[2]];
        const Vec3 whole = cross(b - a, c - a);
        const double area = dot(whole, whole);
        SewnVertex held;
        held.on = {t[0] + first, t[1] + first, t[2] + first};
        held.share = {1, 0, 0};
        if (area > 0) {
            held.share[1] = dot(cross(on - a, c - a), whole) / area;
            held.share[2] = dot(cross(b - a, on - a), whole) / area;
            held.share[0] = 1 - held.share[1] - held.share[2];
        }
        const TriangleAxes axes = axes_of_triangle(a, b, c);
        const Vec3 off = p - on;
        held.off = {dot(off, axes.along), dot(off, axes.across), dot(off, axes.normal)};
        return held;
    }
};

/// The sheet of its layer that each vertex belongs to, by its lowest vertex.
std::vector<std::uint32_t> sheets_of(const QuadMesh& mesh) {
    std::vector<std::uint32_t> root(mesh.vertices.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](std::uint32_t v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const Quad& q : mesh.quads)
        for (std::size_t k = 1; k < 4; ++k) {
            const std::uint32_t a = find(q[0]), b = find(q[k]);
            root[std::max(a, b)] = std::min(a, b);
        }
    for (std::uint32_t v = 0; v < root.size(); ++v) root[v] = find(v);
    return root;
}

std::vector<std::uint32_t> hem_vertices(const Cloth& cloth) {
    std::vector<std::uint32_t> out;
    for (const auto& [a, b] : edges_of(cloth).hems) out.insert(out.end(), {a, b});
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    return out;
}

bool runs_along(const std::vector<Sheet>& below, Vec3 p) {
    for (const Sheet& sheet : below)
        for (const Vec3& v : sheet.hem)
            if (length(v - p) < kAlongHem_cm) return true;
    return false;
}

}  // namespace

TriangleAxes axes_of_triangle(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = normalised(cross(b - a, c - a)), along = normalised(b - a);
    return {along, cross(normal, along), normal};
}

std::vector<SewnVertex> sewn(const std::vector<FinishedLayer>& layers) {
    std::vector<SewnVertex> out;
    std::vector<Sheet> below;
    std::uint32_t first = 0;
    for (const FinishedLayer& layer : layers) {
        const Cloth& cloth = layer.fitted;
        const std::vector<std::uint32_t> hem = hem_vertices(cloth), sheet = sheets_of(cloth.mesh);
        std::vector<std::optional<SewnVertex>> held(hem.size());
        std::vector<int> of_sheet(cloth.mesh.vertices.size(), 0), near(of_sheet);
        for (std::size_t k = 0; k < hem.size(); ++k) {
            double least = kReach_cm;
            for (const Sheet& lower : below) lower.nearest(cloth.mesh.vertices[hem[k]], least, held[k]);
            ++of_sheet[sheet[hem[k]]];
            near[sheet[hem[k]]] += held[k] ? 1 : 0;
        }
        for (std::size_t k = 0; k < hem.size(); ++k) {
            if (!held[k]) continue;
            const bool patch = near[sheet[hem[k]]] >= kPatchShare * of_sheet[sheet[hem[k]]];
            if (!patch && !runs_along(below, cloth.mesh.vertices[hem[k]])) continue;
            held[k]->vertex = hem[k] + first;
            out.push_back(*held[k]);
        }
        Sheet own(cloth, first);
        for (const std::uint32_t v : hem) own.hem.push_back(cloth.mesh.vertices[v]);
        first += static_cast<std::uint32_t>(cloth.mesh.vertices.size());
        below.push_back(std::move(own));
    }
    return out;
}

}  // namespace core
