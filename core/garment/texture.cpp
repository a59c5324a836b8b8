#include "core/garment/texture.hpp"

#include <algorithm>
#include <cstddef>

#include "core/garment/pattern/flatten.hpp"

namespace core {
namespace {

/// The image of a quad names its corners the other way round (mirrored_and_joined).
QuadTexture reversed(const QuadTexture& t) {
    const auto turned = [](Point p) { return Point{-p.x, p.y}; };
    return {turned(t[0]), turned(t[3]), turned(t[2]), turned(t[1])};
}

double quad_area(const QuadMesh& mesh, const Quad& q) {
    return 0.5 * length(cross(mesh.vertices[q[2]] - mesh.vertices[q[0]], mesh.vertices[q[3]] - mesh.vertices[q[1]]));
}

}  // namespace

TextureReport lay_texture(Cloth& cloth) {
    TextureReport report;
    cloth.texture.assign(cloth.mesh.quads.size(), {});
    double area = 0.0;
    for (const ClothPiece& piece : cloth.pieces) {
        if (piece.mirror_of >= 0) {
            const ClothPiece& original = cloth.pieces[static_cast<std::size_t>(piece.mirror_of)];
            for (std::size_t i = 0; i < piece.count; ++i)
                cloth.texture[piece.first + i] = reversed(cloth.texture[original.first + i]);
            continue;
        }
        const PieceMesh part = mesh_of_piece(cloth, piece);
        FlattenOptions options;
        options.length_rounds = 0;
        const Result<FlatPiece> flat = flatten(part.mesh, options);
        if (!flat) {
            report.left_out.push_back(piece.name);
            continue;
        }
        double piece_area = 0.0;
        for (std::size_t i = 0; i < piece.count; ++i) {
            for (std::size_t k = 0; k < 4; ++k) cloth.texture[piece.first + i][k] = flat->places[part.mesh.quads[i][k]];
            piece_area += quad_area(part.mesh, part.mesh.quads[i]);
        }
        report.mean_strain += flat->mean_strain * piece_area;
        area += piece_area;
        report.largest_strain = std::max(report.largest_strain, flat->largest_strain);
    }
    if (area > 0.0) report.mean_strain /= area;
    return report;
}

}  // namespace core
