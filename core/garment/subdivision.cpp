#include "core/garment/subdivision.hpp"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <map>
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

struct FlatPlace {
    Point p;
    void Clear(void* = nullptr) { p = {}; }                     // NOLINT: OpenSubdiv's names
    void AddWithWeight(const FlatPlace& other, float weight) {  // NOLINT
        p = p + other.p * static_cast<double>(weight);
    }
};

/// Places on the flat cloth by corners of quads: corners of one piece at one vertex share theirs.
struct FlatPlaces {
    std::vector<FlatPlace> places;
    std::vector<int> of_corner;
};

FlatPlaces flat_places(const Cloth& cloth) {
    FlatPlaces out;
    for (const ClothPiece& piece : cloth.pieces) {
        std::map<std::uint32_t, int> number;
        for (std::size_t q = piece.first; q < piece.first + piece.count; ++q)
            for (std::size_t k = 0; k < 4; ++k) {
                const auto [at, fresh] = number.emplace(cloth.mesh.quads[q][k], static_cast<int>(out.places.size()));
                if (fresh) out.places.push_back({cloth.texture[q][k]});
                out.of_corner.push_back(at->second);
            }
    }
    return out;
}

std::unique_ptr<far::TopologyRefiner> refiner_of(const Cloth& cloth, FlatPlaces& flat) {
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
    far::TopologyDescriptor::FVarChannel channel;
    if (!flat.places.empty()) {
        channel.numValues = static_cast<int>(flat.places.size());
        channel.valueIndices = flat.of_corner.data();
        descriptor.numFVarChannels = 1;
        descriptor.fvarChannels = &channel;
    }
    OpenSubdiv::Sdc::Options options;
    options.SetFVarLinearInterpolation(OpenSubdiv::Sdc::Options::FVAR_LINEAR_CORNERS_ONLY);
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
            for (const int child : children)
                next[static_cast<std::size_t>(child)] = from[static_cast<std::size_t>(face)];
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
    FlatPlaces flat;
    if (!cloth.texture.empty()) flat = flat_places(cloth);
    const std::unique_ptr<far::TopologyRefiner> refiner = refiner_of(cloth, flat);
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
        if (flat.places.empty()) continue;
        std::vector<FlatPlace> flatter(static_cast<std::size_t>(refiner->GetLevel(level).GetNumFVarValues(0)));
        auto* flat_target = flatter.data();
        primvars.InterpolateFaceVarying(level, flat.places.data(), flat_target);
        flat.places = std::move(flatter);
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
        if (flat.places.empty()) continue;
        const auto values = last.GetFaceFVarValues(static_cast<int>(face), 0);
        QuadTexture texture{};
        for (int k = 0; k < 4; ++k)
            texture[static_cast<std::size_t>(k)] = flat.places[static_cast<std::size_t>(values[k])].p;
        out.texture.push_back(texture);
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
