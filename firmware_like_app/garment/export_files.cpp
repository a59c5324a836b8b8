#include "firmware_like_app/garment/export_files.hpp"

#include <sstream>
#include <utility>

#include "core/exchange/glb_writer.hpp"
#include "core/exchange/obj_writer.hpp"
#include "core/exchange/pattern_files.hpp"
#include "ui/draw/fabric.hpp"
#include "ui/screens/garment_parts.hpp"

namespace app {
namespace {

core::Rgb rgb_of(const ui::Colour& colour) {
    const auto channel = [](float c) { return static_cast<std::uint8_t>(c * 255.0F + 0.5F); };
    return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

}  // namespace

std::size_t made_as(const DressedDesign& dressed, std::size_t layer) {
    return layer < dressed.look.order.size() ? static_cast<std::size_t>(dressed.look.order[layer]) : layer;
}

core::Rgb piece_colour(const DressedDesign& dressed, std::size_t layer, const core::ClothPiece& piece) {
    const ui::Colour own = ui::Colour::hex(ui::kSwatches[made_as(dressed, layer) % 5]);
    const auto material = dressed.look.materials.find(region_of_piece(piece));
    return rgb_of(material == dressed.look.materials.end() ? own : ui::colour_of(material->second.colour, own));
}

std::string region_of_piece(const core::ClothPiece& piece) {
    constexpr std::string_view kImage = "_mirrored";
    const bool image = piece.mirror_of >= 0 && piece.name.ends_with(kImage);
    return image ? piece.name.substr(0, piece.name.size() - kImage.size()) : piece.name;
}

core::Result<std::string> garment_obj(const DressedDesign& dressed) {
    core::QuadMesh all;
    std::vector<core::QuadGroup> groups;
    std::vector<core::QuadTexture> texture;
    for (const core::FinishedLayer& layer : dressed.garment.layers) {
        const core::Cloth& cloth = layer.fitted;
        const auto shift = static_cast<std::uint32_t>(all.vertices.size());
        for (const core::ClothPiece& piece : cloth.pieces)
            groups.push_back({piece.name, all.quads.size() + piece.first, piece.count});
        all.vertices.insert(all.vertices.end(), cloth.mesh.vertices.begin(), cloth.mesh.vertices.end());
        texture.insert(texture.end(), cloth.texture.begin(), cloth.texture.end());
        for (const core::Quad& q : cloth.mesh.quads)
            all.quads.push_back({q[0] + shift, q[1] + shift, q[2] + shift, q[3] + shift});
    }
    std::vector<core::TriangleGroup> objects;
    for (const PlacedMesh& object : dressed.objects) objects.push_back({object.name, &object.mesh});
    std::ostringstream out;
    if (const auto written = core::write_obj(out, all, groups, texture, objects); !written)
        return core::unexpected(written.error());
    return out.str();
}

core::Result<std::string> garment_glb(const DressedDesign& dressed) {
    std::vector<core::GlbMesh> meshes;
    for (std::size_t i = 0; i < dressed.garment.layers.size(); ++i) {
        const core::Cloth& cloth = dressed.garment.layers[i].fitted;
        for (const core::ClothPiece& piece : cloth.pieces)
            meshes.push_back({.name = piece.name,
                              .mesh = &cloth.mesh,
                              .first = piece.first,
                              .count = piece.count,
                              .colour = piece_colour(dressed, i, piece),
                              .texture = &cloth.texture});
    }
    for (const PlacedMesh& object : dressed.objects)
        meshes.push_back({.name = object.name, .colour = {}, .two_sided = true, .triangles = &object.mesh});
    std::ostringstream out;
    if (const auto written = core::write_glb(out, meshes); !written) return core::unexpected(written.error());
    return out.str();
}

core::Result<std::vector<NamedBytes>> pattern_files(const DressedDesign& dressed, const ExportPlan& plan) {
    const core::Result<core::Pattern> pattern = core::make_pattern(dressed.design, dressed.garment, plan.pattern);
    if (!pattern) return core::unexpected(pattern.error());
    const core::PatternSheet sheet = core::lay_out_sheet(*pattern, core::kFabricWidth_cm);
    std::vector<NamedBytes> files;
    if (plan.print_pattern) {
        files.push_back({"pattern.svg", core::sheet_svg(sheet)});
        for (const core::PaperSize& paper : {core::kA4, core::kA3, core::kLetter}) {
            core::Result<std::string> pdf = core::sheet_pdf(sheet, paper);
            if (!pdf) return core::unexpected(pdf.error());
            files.push_back({std::string("pattern-") + paper.name + ".pdf", std::move(*pdf)});
        }
        files.push_back({"strain.svg", core::strain_svg(*pattern, sheet)});
    }
    if (plan.cut_pattern) {
        files.push_back({"pattern.dxf", core::pattern_dxf(*pattern, sheet)});
        files.push_back({"seams.json", core::pattern_json(*pattern)});
    }
    return files;
}

}  // namespace app
