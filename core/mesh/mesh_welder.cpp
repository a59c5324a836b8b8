#include "core/mesh/mesh_welder.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace core {
namespace {

constexpr std::uint32_t kFree = std::numeric_limits<std::uint32_t>::max();

std::uint64_t mix(std::uint64_t h, std::uint64_t value) {
    h = (h ^ value) * 0x9e3779b97f4a7c15ULL;
    return h ^ (h >> 29);
}

std::uint64_t hash_of(Vec3 p, Rgb c) {
    std::uint64_t h = (std::uint64_t{c.r} << 16) | (std::uint64_t{c.g} << 8) | c.b;
    h = mix(h, std::bit_cast<std::uint64_t>(p.x));
    h = mix(h, std::bit_cast<std::uint64_t>(p.y));
    return mix(h, std::bit_cast<std::uint64_t>(p.z));
}

}  // namespace

bool is_usable(Vec3 p) {
    // Written so that NaN fails too.
    return std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate &&
           std::abs(p.z) <= kLargestCoordinate;
}

void MeshWelder::add(const Corner& a, const Corner& b, const Corner& c) {
    const bool usable = is_usable(a.position) && is_usable(b.position) && is_usable(c.position);
    if (!usable || a.position == b.position || b.position == c.position || c.position == a.position) {
        ++left_out_;
        return;
    }
    const std::uint32_t i = vertex(a), j = vertex(b), k = vertex(c);
    mesh_.triangles.push_back({i, j, k});
}

std::uint32_t MeshWelder::vertex(const Corner& corner) {
    if (slots_.size() < 2 * (mesh_.vertices.size() + 1)) grow();
    const Vec3 p = corner.position + Vec3{};  // -0 becomes 0
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = hash_of(p, corner.colour) & mask;
    while (slots_[at] != kFree) {
        const std::uint32_t known = slots_[at];
        if (mesh_.vertices[known] == p && mesh_.colours[known] == corner.colour) return known;
        at = (at + 1) & mask;
    }
    const auto index = static_cast<std::uint32_t>(mesh_.vertices.size());
    slots_[at] = index;
    mesh_.vertices.push_back(p);
    mesh_.colours.push_back(corner.colour);
    return index;
}

void MeshWelder::grow() {
    const std::size_t size = slots_.empty() ? 64 : 2 * slots_.size();
    slots_.assign(size, kFree);
    for (std::size_t i = 0; i < mesh_.vertices.size(); ++i) {
        std::size_t at = hash_of(mesh_.vertices[i], mesh_.colours[i]) & (size - 1);
        while (slots_[at] != kFree) at = (at + 1) & (size - 1);
        slots_[at] = static_cast<std::uint32_t>(i);
    }
}

TriangleMesh MeshWelder::finish() && {
    bool all_clay = true;
    for (const Rgb& c : mesh_.colours) all_clay = all_clay && c == Rgb{};
    if (all_clay) mesh_.colours = {};
    return std::move(mesh_);
}

}  // namespace core
