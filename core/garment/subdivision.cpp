#include "core/garment/subdivision.hpp"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace core {
namespace {

namespace far = OpenSubdiv::Far;

/// What OpenSubdiv blends: places.
struct Place {
    Vec3 p;
    void Clear(void* = nullptr) { p = {}; }  // NOLINT: OpenSubdiv's names
    void AddWithWeight(const Place& other, float weight) { p = p + other.p * static_cast<double>(weight); }  // NOLINT
};

std::unique_ptr<far::TopologyRefiner> refiner_of(const Cloth& cloth) {
    const ClothEdges edges = edges_of(cloth);
    std::vector<int> corners, counts(cloth.mesh.quads.size(), 4), creases;
    for (const Quad& q : cloth.mesh.quads)
        for (const std::uint32_t v : q) corners.push_back(static_cast<int>(v));
    for (const auto* list : {&edges.hems, &edges.seams})
        for (const auto& [a, b] : *list) creases.insert(creases.end(), {static_cast<int>(a), static_cast<int>(b)});
    const std::vector<float> sharp(creases.size() / 2, 10.0F);
    far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(cloth.mesh.vertices.size());
    descriptor.numFaces = static_cast<int>(counts.size());
    descriptor.numVertsPerFace = counts.data();
    descriptor.vertIndicesPerFace = corners.data();
    descriptor.numCreases = static_cast<int>(sharp.size());
    descriptor.creaseVertexIndexPairs = creases.data();
    descriptor.creaseWeights = sharp.data();
    OpenSubdiv::Sdc::Options options;
    options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = far::TopologyRefinerFactory<far::TopologyDescriptor>;
    return std::unique_ptr<far::TopologyRefiner>(
        Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
}

/// Of each face of the last level, the quad of the cloth it comes from.
std::vector<std::size_t> origins(const far::TopologyRefiner& refiner, int levels, std::size_t quads) {
    std::vector<std::size_t> from(quads);
    std::iota(from.begin(), from.end(), std::size_t{0});
    for (int level = 0; level < levels; ++level) {
        const auto& parent = refiner.GetLevel(level);
        std::vector<std::size_t> next(static_cast<std::size_t>(refiner.GetLevel(level + 1).GetNumFaces()));
        for (int face = 0; face < parent.GetNumFaces(); ++face) {
            const auto children = parent.GetFaceChildFaces(face);
            for (int k = 0; k < children.size(); ++k)
                next[static_cast<std::size_t>(children[k])] = from[static_cast<std::size_t>(face)];
        }
        from = std::move(next);
    }
    return from;
}

}  // namespace

Result<Cloth> subdivided(const Cloth& cloth, int levels) {
    if (levels < 1 || levels > 3)
        return unexpected(ErrorCode::BadArgument, "Cloth can be made finer by 1, 2 or 3 levels.");
    if (cloth.mesh.quads.empty()) return cloth;
    const std::unique_ptr<far::TopologyRefiner> refiner = refiner_of(cloth);
    if (!refiner) return unexpected(ErrorCode::BadMesh, "The cloth's quads cannot be subdivided.");
    refiner->RefineUniform(far::TopologyRefiner::UniformOptions(levels));
    std::vector<Place> places;
    for (const Vec3& v : cloth.mesh.vertices) places.push_back({v});
    const far::PrimvarRefiner primvars(*refiner);
    for (int level = 1; level <= levels; ++level) {
        std::vector<Place> finer(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
        auto* target = finer.data();
        primvars.Interpolate(level, places.data(), target);
        places = std::move(finer);
    }
    const auto& last = refiner->GetLevel(levels);
    const std::vector<std::size_t> origin = origins(*refiner, levels, cloth.mesh.quads.size());
    std::vector<std::size_t> order(origin.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return origin[a] < origin[b]; });
    Cloth out;
    for (const Place& place : places) out.mesh.vertices.push_back(place.p);
    for (const std::size_t face : order) {
        const auto v = last.GetFaceVertices(static_cast<int>(face));
        Quad quad{};
        for (int k = 0; k < 4; ++k) quad[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(v[k]);
        out.mesh.quads.push_back(quad);
    }
    const std::size_t share = std::size_t{1} << (2 * levels);
    for (ClothPiece piece : cloth.pieces) {
        piece.first *= share;
        piece.count *= share;
        out.pieces.push_back(std::move(piece));
    }
    out.drawn.assign(out.mesh.vertices.size(), false);
    const ClothEdges edges = edges_of(out);
    for (const auto* list : {&edges.hems, &edges.seams})
        for (const auto& [a, b] : *list) out.drawn[a] = out.drawn[b] = true;
    return out;
}

}  // namespace core
