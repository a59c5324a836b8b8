#include "core/garment/cloth.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace core {
namespace {

constexpr double kOnPlane_cm = 1e-6;

Result<FilledRegion> fill(const Network& network, const NetworkRegion& region, std::vector<BoundaryKey>& keys) {
    Result<RegionBoundary> boundary = network.boundary(region);
    if (!boundary) return unexpected(boundary.error());
    keys = std::move(boundary->keys);
    return fill_region(boundary->outline, region.alpha);
}

}  // namespace

BuiltCloth build_cloth(const Network& network, int layer) {
    BuiltCloth out;
    Cloth& cloth = out.cloth;
    std::map<BoundaryKey, std::uint32_t> vertex_of;
    for (const NetworkRegion& region : network.regions()) {
        if (!region.alive || region.layer != layer) continue;
        std::vector<BoundaryKey> keys;
        const Result<FilledRegion> filled = fill(network, region, keys);
        if (!filled) {
            out.faults.push_back({region.name, filled.error()});
            continue;
        }
        std::vector<std::uint32_t> number;
        for (std::size_t v = 0; v < filled->mesh.vertices.size(); ++v) {
            const bool border = v < keys.size();
            const auto next = static_cast<std::uint32_t>(cloth.mesh.vertices.size());
            const std::uint32_t at = border ? vertex_of.emplace(keys[v], next).first->second : next;
            number.push_back(at);
            if (at != next) continue;
            cloth.mesh.vertices.push_back(filled->mesh.vertices[v]);
            cloth.drawn.push_back(border);
            cloth.line.push_back(border ? keys[v].line : -1);
        }
        cloth.pieces.push_back({region.name, layer, cloth.mesh.quads.size(), filled->mesh.quads.size(),
                                filled->topology.counts, filled->alpha, -1, region.parts});
        for (const Quad& q : filled->mesh.quads)
            cloth.mesh.quads.push_back({number[q[0]], number[q[1]], number[q[2]], number[q[3]]});
    }
    return out;
}

Cloth mirrored_and_joined(const Cloth& half) {
    Cloth whole = half;
    constexpr std::uint32_t kNone = ~0U;
    std::vector<std::uint32_t> image(half.mesh.vertices.size(), kNone);
    const auto image_of = [&](std::uint32_t v) {
        if (image[v] != kNone) return image[v];
        const Vec3 p = half.mesh.vertices[v];
        if (std::abs(p.x) < kOnPlane_cm) return image[v] = v;
        image[v] = static_cast<std::uint32_t>(whole.mesh.vertices.size());
        whole.mesh.vertices.push_back({-p.x, p.y, p.z});
        whole.drawn.push_back(half.drawn[v]);
        if (!half.line.empty()) whole.line.push_back(half.line[v]);
        return image[v];
    };
    whole.texture.clear();
    for (std::size_t p = 0; p < half.pieces.size(); ++p) {
        const ClothPiece& piece = half.pieces[p];
        bool left = false, right = false;
        for (std::size_t q = piece.first; q < piece.first + piece.count; ++q)
            for (const std::uint32_t v : half.mesh.quads[q]) {
                left = left || half.mesh.vertices[v].x > kOnPlane_cm;
                right = right || half.mesh.vertices[v].x < -kOnPlane_cm;
            }
        if (left && right) continue;
        ClothPiece other = piece;
        other.name += "_mirrored";
        other.mirror_of = static_cast<int>(p);
        other.parts = mirrored_parts(piece.parts);
        other.first = whole.mesh.quads.size();
        for (std::size_t q = piece.first; q < piece.first + piece.count; ++q) {
            const Quad& quad = half.mesh.quads[q];
            whole.mesh.quads.push_back({image_of(quad[0]), image_of(quad[3]), image_of(quad[2]), image_of(quad[1])});
        }
        whole.pieces.push_back(std::move(other));
    }
    return whole;
}

PieceMesh mesh_of_piece(const Cloth& cloth, const ClothPiece& piece) {
    PieceMesh out;
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::size_t q = piece.first; q < piece.first + piece.count; ++q) {
        Quad quad{};
        for (std::size_t k = 0; k < 4; ++k) {
            const std::uint32_t v = cloth.mesh.quads[q][k];
            const auto [at, fresh] = number.emplace(v, static_cast<std::uint32_t>(out.vertex.size()));
            if (fresh) {
                out.vertex.push_back(v);
                out.mesh.vertices.push_back(cloth.mesh.vertices[v]);
            }
            quad[k] = at->second;
        }
        out.mesh.quads.push_back(quad);
    }
    return out;
}

ClothEdges edges_of(const Cloth& cloth) {
    struct Side {
        std::uint32_t low, high;
        std::size_t piece;
    };
    std::vector<Side> sides;
    for (std::size_t p = 0; p < cloth.pieces.size(); ++p)
        for (std::size_t q = cloth.pieces[p].first; q < cloth.pieces[p].first + cloth.pieces[p].count; ++q)
            for (std::size_t k = 0; k < 4; ++k) {
                const std::uint32_t a = cloth.mesh.quads[q][k], b = cloth.mesh.quads[q][(k + 1) % 4];
                sides.push_back({std::min(a, b), std::max(a, b), p});
            }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.low, x.high, x.piece) < std::tie(y.low, y.high, y.piece);
    });
    ClothEdges out;
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
        if (end - i == 1)
            out.hems.push_back({sides[i].low, sides[i].high});
        else if (sides[i].piece != sides[end - 1].piece)
            out.seams.push_back({sides[i].low, sides[i].high});
        i = end;
    }
    return out;
}

}  // namespace core
