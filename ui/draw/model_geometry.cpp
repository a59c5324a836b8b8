#include "ui/draw/model_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace ui {
namespace {

using core::Vec3;

constexpr double kCreaseCosine = 0.643;  // cosine of 50 degrees
constexpr std::size_t kMostFaces = 48;   // round one corner; beyond that the face's own normal does
constexpr double kBlendShare = 0.012;    // of the model's height, by the design
constexpr double kContactShare = 0.035;  // of the model's height counts as standing on the ground
constexpr int kContactCells = 64;
constexpr std::size_t kBands = 48;

struct PositionHash {
    std::size_t operator()(const std::array<std::int64_t, 3>& p) const {
        std::uint64_t h = 0xcbf29ce484222325ULL;
        for (const std::int64_t v : p) h = (h ^ static_cast<std::uint64_t>(v)) * 0x100000001b3ULL;
        return static_cast<std::size_t>(h ^ h >> 29);
    }
};

/// Number of the position that each vertex shares with others.
std::vector<std::uint32_t> weld(const core::TriangleMesh& mesh) {
    std::unordered_map<std::array<std::int64_t, 3>, std::uint32_t, PositionHash> seen;
    std::vector<std::uint32_t> welded;
    welded.reserve(mesh.vertices.size());
    for (const Vec3& v : mesh.vertices) {
        const std::array<std::int64_t, 3> cell{std::llround(v.x * 1e5), std::llround(v.y * 1e5),
                                               std::llround(v.z * 1e5)};
        welded.push_back(seen.emplace(cell, static_cast<std::uint32_t>(seen.size())).first->second);
    }
    return welded;
}

/// Mean of the faces round a corner that continue the face's own surface, turned to its side.
Vec3 corner_normal(const std::vector<Vec3>& twice_areas, const std::vector<std::uint32_t>& around, const Vec3& own) {
    if (around.size() > kMostFaces) return own;
    Vec3 sum;
    for (const std::uint32_t face : around) {
        const Vec3& n = twice_areas[face];
        const double c = core::dot(core::normalised(n), own);
        if (std::abs(c) >= kCreaseCosine) sum = sum + n * (c > 0 ? 1.0 : -1.0);
    }
    return core::length(sum) > 0 ? core::normalised(sum) : own;
}

void find_box(CardModel& model) {
    const std::vector<float>& c = model.geometry->corners;
    bool first = true;
    for (std::size_t i = 0; i + 8 < c.size(); i += 9) {
        const core::Point p = model.camera.project({c[i], c[i + 1], c[i + 2]});
        model.left = first ? p.x : std::min(model.left, p.x);
        model.right = first ? p.x : std::max(model.right, p.x);
        model.bottom = first ? p.y : std::min(model.bottom, p.y);
        model.top = first ? p.y : std::max(model.top, p.y);
        first = false;
    }
}

void find_contacts(CardModel& model) {
    const double width = model.right - model.left, height = model.top - model.bottom;
    if (width <= 0) return;
    std::array<bool, kContactCells> standing{};
    const auto cell_of = [&](double x) {
        return std::clamp(static_cast<int>((x - model.left) / width * kContactCells), 0, kContactCells - 1);
    };
    const std::vector<float>& c = model.geometry->corners;
    const double limit = model.bottom + height * kContactShare;
    for (std::size_t i = 0; i + 26 < c.size(); i += 27) {
        double low = 2, high = -2, lowest_top = -2;
        for (std::size_t k = 0; k < 27; k += 9) {
            const core::Point p = model.camera.project({c[i + k], c[i + k + 1], c[i + k + 2]});
            low = std::min(low, p.x);
            high = std::max(high, p.x);
            lowest_top = std::max(lowest_top, p.y);
        }
        if (lowest_top > limit) continue;
        for (int k = cell_of(low); k <= cell_of(high); ++k) standing[static_cast<std::size_t>(k)] = true;
    }
    for (int k = 0; k < kContactCells; ++k) {
        if (!standing[static_cast<std::size_t>(k)]) continue;
        const int first = k;
        while (k + 1 < kContactCells && standing[static_cast<std::size_t>(k + 1)]) ++k;
        model.contacts.push_back(
            {model.left + first * width / kContactCells, model.left + (k + 1) * width / kContactCells});
    }
}

void find_reaches(CardModel& model) {
    const double height = model.top - model.bottom;
    if (height <= 0) return;
    model.reaches.assign(kBands, {1e300, -1e300});
    const auto band_of = [&](double y) {
        const double band = (y - model.bottom) / height * kBands;
        return static_cast<std::size_t>(std::clamp(band, 0.0, kBands - 1.0));
    };
    const std::vector<float>& c = model.geometry->corners;
    for (std::size_t i = 0; i + 26 < c.size(); i += 27) {
        std::array<core::Point, 3> p;
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = model.camera.project({c[i + k * 9], c[i + k * 9 + 1], c[i + k * 9 + 2]});
        const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
        const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
        for (std::size_t band = band_of(low); band <= band_of(high); ++band) {
            core::Point& reach = model.reaches[band];
            reach = {std::min(reach.x, left), std::max(reach.y, right)};
        }
    }
}

}  // namespace

ModelGeometry make_model_geometry(const core::TriangleMesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh);
    std::vector<Vec3> twice_areas;
    twice_areas.reserve(mesh.triangles.size());
    std::vector<std::vector<std::uint32_t>> around(mesh.vertices.size());
    for (const auto& t : mesh.triangles) {
        const Vec3& a = mesh.vertices[t[0]];
        twice_areas.push_back(core::cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a));
        for (const std::uint32_t v : t) {
            std::vector<std::uint32_t>& faces = around[welded[v]];
            if (faces.size() <= kMostFaces) faces.push_back(static_cast<std::uint32_t>(twice_areas.size() - 1));
        }
    }
    ModelGeometry geometry;
    geometry.corners.reserve(mesh.triangles.size() * 27);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 own = core::normalised(twice_areas[i]);
        if (core::length(own) == 0) continue;
        for (const std::uint32_t v : mesh.triangles[i]) {
            const Vec3 n = corner_normal(twice_areas, around[welded[v]], own);
            const Vec3& p = mesh.vertices[v];
            const core::Rgb c = mesh.colours.empty() ? core::Rgb{} : mesh.colours[v];
            for (const double value : {p.x, p.y, p.z, n.x, n.y, n.z, c.r / 255.0, c.g / 255.0, c.b / 255.0}) {
                geometry.corners.push_back(static_cast<float>(value));
            }
        }
    }
    return geometry;
}

CardModel make_card_model(std::shared_ptr<const ModelGeometry> geometry, const core::Camera& camera, bool mirrored,
                          const std::vector<PartRegion>& parts, int map_size) {
    CardModel model;
    model.geometry = std::move(geometry);
    model.camera = camera;
    model.mirrored = mirrored;
    find_box(model);
    find_contacts(model);
    find_reaches(model);
    if (!parts.empty()) model.part_map = bake_part_map(parts, map_size, (model.top - model.bottom) * kBlendShare);
    return model;
}

}  // namespace ui
