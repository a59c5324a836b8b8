#include "core/garment/part_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace core {
namespace {

constexpr double kCell_cm = 4.0;
constexpr double kFarFromBody_cm = 60.0;  // a train, a wide hem
constexpr double kShare = 0.05;

int cell_of(double v) {
    return std::clamp(static_cast<int>(std::floor(v / kCell_cm)), -4000, 4000);
}

}  // namespace

PartSurface::PartSurface(const DressForm& form) {
    if (form.part_of_triangle.size() != form.mesh.triangles.size()) return;
    for (std::size_t t = 0; t < form.mesh.triangles.size(); ++t) {
        const auto& [i, j, k] = form.mesh.triangles[t];
        const Vec3 a = form.mesh.vertices[i], b = form.mesh.vertices[j], c = form.mesh.vertices[k];
        const Face face{(a + b + c) * (1.0 / 3.0), normalised(cross(b - a, c - a)), form.part_of_triangle[t]};
        cells_[key(cell_of(face.middle.x), cell_of(face.middle.y), cell_of(face.middle.z))].push_back(
            static_cast<std::uint32_t>(faces_.size()));
        faces_.push_back(face);
    }
}

std::optional<PartPlace> PartSurface::nearest(Vec3 p, PartSet parts, double reach) const {
    std::optional<PartPlace> best;
    double least = reach;
    const int x = cell_of(p.x), y = cell_of(p.y), z = cell_of(p.z);
    // shells of cells around the place: the s-th is s - 1 whole cells away at least
    for (int s = 0; (s - 1) * kCell_cm <= least; ++s)
        for (int k = -s; k <= s; ++k)
            for (int j = -s; j <= s; ++j)
                for (int i = -s; i <= s; ++i) {
                    if (std::max({std::abs(i), std::abs(j), std::abs(k)}) != s) continue;
                    const auto cell = cells_.find(key(x + i, y + j, z + k));
                    if (cell == cells_.end()) continue;
                    for (const std::uint32_t f : cell->second) {
                        const Face& face = faces_[f];
                        const double d = length(face.middle - p);
                        if ((parts & part_bit(face.part)) == 0 || d >= least) continue;
                        least = d;
                        best = PartPlace{face.middle, face.normal, face.part, d};
                    }
                }
    return best;
}

std::vector<Vec3> PartSurface::centre_line(BodyPart part) const {
    constexpr std::size_t kSlices = 10;
    double low = std::numeric_limits<double>::max(), high = -low;
    for (const Face& face : faces_) {
        if (face.part != part) continue;
        low = std::min(low, face.middle.y);
        high = std::max(high, face.middle.y);
    }
    std::array<Vec3, kSlices> least{}, most{};
    std::array<bool, kSlices> some{};
    for (const Face& face : faces_) {
        if (face.part != part || high <= low) continue;
        const auto slice =
            std::min(kSlices - 1, static_cast<std::size_t>((high - face.middle.y) / (high - low) * kSlices));
        const Vec3 p = face.middle;
        Vec3 &a = least[slice], &b = most[slice];
        a = some[slice] ? Vec3{std::min(a.x, p.x), std::min(a.y, p.y), std::min(a.z, p.z)} : p;
        b = some[slice] ? Vec3{std::max(b.x, p.x), std::max(b.y, p.y), std::max(b.z, p.z)} : p;
        some[slice] = true;
    }
    std::vector<Vec3> line;
    for (std::size_t k = 0; k < kSlices; ++k)
        if (some[k]) line.push_back((least[k] + most[k]) * 0.5);
    return line;
}

PartSet PartSurface::parts_under(const std::vector<Vec3>& points) const {
    std::array<std::size_t, kBodyPartCount> count{};
    for (const Vec3& p : points)
        if (const auto near = nearest(p, ~PartSet{0}, kFarFromBody_cm); near)
            ++count[static_cast<std::size_t>(near->part)];
    PartSet parts = 0;
    for (std::size_t k = 0; k < kBodyPartCount; ++k)
        if (static_cast<double>(count[k]) > kShare * static_cast<double>(points.size()))
            parts |= part_bit(static_cast<BodyPart>(k));
    return parts;
}

}  // namespace core
