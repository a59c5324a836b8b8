#include "core/mesh/quad_disc.hpp"

#include <algorithm>
#include <cstddef>

namespace core {
namespace {

constexpr std::size_t kMostQuads = 5;  // around one vertex

/// Of each vertex, where the edges of its quads go: one leaves it in each quad.
struct Fans {
    std::vector<std::array<std::uint32_t, kMostQuads>> to;
    std::vector<std::uint8_t> count;

    [[nodiscard]] bool has(std::uint32_t from, std::uint32_t target) const {
        const auto end = to[from].begin() + count[from];
        return std::find(to[from].begin(), end, target) != end;
    }
};

/// False when a vertex has too many quads or a directed edge occurs twice.
bool gather(std::span<const Quad> quads, std::uint32_t vertex_count, Fans& fans) {
    fans.to.resize(vertex_count);
    fans.count.assign(vertex_count, 0);
    for (const Quad& q : quads)
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t from = q[k], to = q[(k + 1) % 4];
            if (from >= vertex_count || to >= vertex_count || from == to || from == q[(k + 2) % 4]) return false;
            if (fans.count[from] == kMostQuads || fans.has(from, to)) return false;
            fans.to[from][fans.count[from]++] = to;
        }
    return true;
}

/// Edges in all; nothing when an edge without a partner is not one of the boundary, or one of the boundary is missing.
std::optional<std::size_t> count_edges(const Fans& fans, std::uint32_t boundary) {
    std::size_t directed = 0, single = 0;
    for (std::uint32_t v = 0; v < fans.count.size(); ++v)
        for (std::size_t k = 0; k < fans.count[v]; ++k) {
            ++directed;
            const std::uint32_t to = fans.to[v][k];
            if (fans.has(to, v)) continue;
            ++single;
            if (v >= boundary || to != (v + 1) % boundary) return std::nullopt;
        }
    if (single != boundary) return std::nullopt;
    return (directed + single) / 2;
}

}  // namespace

std::optional<QuadDiscCounts> count_quad_disc(std::span<const Quad> quads, std::uint32_t vertex_count,
                                              const std::vector<bool>& is_corner) {
    Fans fans;
    if (!gather(quads, vertex_count, fans)) return std::nullopt;
    const auto boundary = static_cast<std::uint32_t>(is_corner.size());
    const std::optional<std::size_t> edges = count_edges(fans, boundary);
    if (!edges || vertex_count + quads.size() != *edges + 1) return std::nullopt;
    QuadDiscCounts counts;
    for (std::uint32_t v = 0; v < vertex_count; ++v) {
        const std::size_t around = fans.count[v];
        if (v < boundary) {
            if (around < 1 || around > 4) return std::nullopt;
            counts.irregular_boundary += around != (is_corner[v] ? 1U : 2U);
        } else {
            if (around < 3 || around > 5) return std::nullopt;
            ++counts.interior_by_valence[around];
            counts.irregular_interior += around != 4;
        }
    }
    return counts;
}

}  // namespace core
