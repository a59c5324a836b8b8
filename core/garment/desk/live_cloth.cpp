#include "core/garment/desk/live_cloth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/garment/region.hpp"

namespace core {
namespace {

constexpr std::uint32_t kNone = ~0U;
constexpr double kOnPlane_cm = 1e-6;
constexpr double kClearance_cm = 0.2;  // less than fitted cloth has, which stays where it is
constexpr int kWaysOut = 3;

Vec3 outside(Vec3 p, const Obstacle& below) {
    for (int i = 0; i < kWaysOut; ++i) {
        const FieldSample sample = below.quick_sample(p);
        if (sample.distance >= kClearance_cm) break;
        p = p + sample.gradient * (kClearance_cm - sample.distance);
    }
    return p;
}

/// The ring of a region's outline, in the order of its keys, each line at a given number of edges.
std::vector<Vec3> ring_places(const Network& network, const std::vector<BoundaryKey>& keys,
                              const std::vector<int>& edges) {
    std::vector<Vec3> ring(keys.size());
    std::vector<SpaceLine> points(network.lines().size());
    for (std::size_t k = 0; k < keys.size(); ++k) {
        if (keys[k].vertex >= 0) {
            ring[k] = network.vertices()[static_cast<std::size_t>(keys[k].vertex)].place;
            continue;
        }
        const auto line = static_cast<std::size_t>(keys[k].line);
        if (points[line].empty()) points[line] = resampled(network.lines()[line].shape, edges[line]);
        ring[k] = points[line][static_cast<std::size_t>(keys[k].index)];
    }
    return ring;
}

}  // namespace

LiveCloth::LiveCloth(const Network& network, int layer, bool mirror, const FinishedLayer& finished,
                     std::shared_ptr<const Obstacle> below)
    : below_(std::move(below)),
      drawn_(finished.drawn.mesh.vertices),
      fitted_(finished.fitted.mesh.vertices),
      places_(fitted_) {
    for (const NetworkLine& line : network.lines()) {
        edges_.push_back(network.edge_count(line));
        ends_.push_back({line.from, line.to});
    }
    // pieces stand in the cloth in the order of their regions, the images after them
    const std::vector<ClothPiece>& all = finished.drawn.pieces;
    for (std::size_t p = 0; p < all.size(); ++p) {
        if (all[p].mirror_of >= 0) continue;
        const NetworkRegion* region = network.find_region(all[p].name);
        if (region == nullptr || region->layer != layer) continue;
        Result<RegionBoundary> boundary = network.boundary(*region);
        if (!boundary) continue;
        Result<RegionTopology> topology = outline_topology(boundary->outline);
        if (!topology) continue;
        // mesh and topology name their quads in the same order: read off which vertex is which
        std::vector<std::uint32_t> vertex(topology->vertices, kNone), image(topology->vertices, kNone);
        if (topology->quads.size() != all[p].count) continue;
        for (std::size_t q = 0; q < topology->quads.size(); ++q)
            for (std::size_t k = 0; k < 4; ++k)
                vertex[topology->quads[q][k]] = finished.drawn.mesh.quads[all[p].first + q][k];
        for (std::size_t m = p + 1; mirror && m < all.size(); ++m) {
            if (all[m].mirror_of != static_cast<int>(p)) continue;
            constexpr std::array<std::size_t, 4> kTurned{0, 3, 2, 1};  // as mirrored_and_joined turns them
            for (std::size_t q = 0; q < topology->quads.size(); ++q)
                for (std::size_t k = 0; k < 4; ++k)
                    image[topology->quads[q][k]] = finished.drawn.mesh.quads[all[m].first + q][kTurned[k]];
        }
        PermanencePatch patch(topology->quads, topology->vertices, topology->boundary, all[p].alpha);
        std::vector<Vec3> now(topology->vertices);
        for (std::size_t v = 0; v < now.size(); ++v)
            if (vertex[v] != kNone) now[v] = drawn_[vertex[v]];
        pieces_.push_back({all[p].name, std::move(boundary->keys), std::move(vertex), std::move(image),
                           std::move(patch), std::move(now)});
    }
}

/// The fitted place, moved as the filling moved, and out of the body from there.
void LiveCloth::show(const Piece& piece) {
    for (std::size_t v = 0; v < piece.now.size(); ++v) {
        const std::uint32_t own = piece.vertex[v], image = piece.image[v];
        if (own == kNone) continue;
        const Vec3 moved = piece.now[v] - drawn_[own];
        places_[own] = outside(fitted_[own] + moved, *below_);
        if (image != kNone && image != own)
            places_[image] = outside(fitted_[image] + Vec3{-moved.x, moved.y, moved.z}, *below_);
        if (image == own && std::abs(drawn_[own].x) < kOnPlane_cm) places_[own].x = fitted_[own].x;
    }
}

void LiveCloth::set_alpha(const std::string& region, double alpha) {
    for (Piece& piece : pieces_) {
        if (piece.name != region) continue;
        piece.patch.set_alpha(alpha);
        piece.patch.solve(piece.now);
        show(piece);
    }
}

bool LiveCloth::follow(const Network& moved) {
    if (moved.lines().size() != edges_.size()) return false;
    for (std::size_t i = 0; i < edges_.size(); ++i)
        if (moved.lines()[i].from != ends_[i][0] || moved.lines()[i].to != ends_[i][1]) return false;
    for (Piece& piece : pieces_) {
        const std::vector<Vec3> ring = ring_places(moved, piece.keys, edges_);
        if (std::equal(ring.begin(), ring.end(), piece.now.begin())) continue;
        std::copy(ring.begin(), ring.end(), piece.now.begin());
        piece.patch.solve(piece.now);
        show(piece);
    }
    return true;
}

}  // namespace core
