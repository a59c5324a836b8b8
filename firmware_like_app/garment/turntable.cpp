#include "firmware_like_app/garment/turntable.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "firmware_like_app/garment/export_files.hpp"
#include "ui/gl/headless_context.hpp"
#include "ui/screens/garment_parts.hpp"

namespace app {
namespace {

constexpr double kRaised_rad = 0.12;  // the eye looks a little down
constexpr double kMargin = 0.04;      // of the picture's height, at each edge

/// The body, and what it wears or carries beside cloth.
core::TriangleMesh figure_of(const DressedDesign& dressed) {
    core::TriangleMesh all = dressed.form.mesh;
    all.colours.clear();
    for (const PlacedMesh& object : dressed.objects) {
        const auto shift = static_cast<std::uint32_t>(all.vertices.size());
        all.vertices.insert(all.vertices.end(), object.mesh.vertices.begin(), object.mesh.vertices.end());
        for (const auto& t : object.mesh.triangles) all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    }
    return all;
}

/// The picture on a plain ground, opaque.
core::RgbaImage on_ground(core::RgbaImage image, const ui::Colour& ground) {
    const std::array<float, 3> under{ground.r * 255.0F, ground.g * 255.0F, ground.b * 255.0F};
    for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
        const float bare = 1.0F - static_cast<float>(image.pixels[i + 3]) / 255.0F;  // colours are premultiplied
        for (std::size_t k = 0; k < 3; ++k) {
            const float value = static_cast<float>(image.pixels[i + k]) + under[k] * bare;
            image.pixels[i + k] = static_cast<std::uint8_t>(std::min(255.0F, value + 0.5F));
        }
        image.pixels[i + 3] = 255;
    }
    return image;
}

}  // namespace

std::vector<ui::FabricLook> piece_looks(const DressedDesign& dressed, std::size_t layer) {
    const ui::Colour own = ui::Colour::hex(ui::kSwatches[made_as(dressed, layer) % 5]);
    std::vector<ui::FabricLook> looks;
    for (const core::ClothPiece& piece : dressed.garment.layers[layer].fitted.pieces) {
        const auto material = dressed.look.materials.find(region_of_piece(piece));
        if (material == dressed.look.materials.end()) {
            looks.push_back({ui::Fabric::Plain, own, {}});
            continue;
        }
        looks.push_back({ui::fabric_of(material->second.fabric), ui::colour_of(material->second.colour, own), {}});
    }
    return looks;
}

Turntable::Turntable(std::unique_ptr<ui::Context> context, ui::FigureStage stage)
    : context_(std::move(context)), stage_(std::move(stage)) {}

core::Result<Turntable> Turntable::create(const DressedDesign& dressed) {
    core::Result<std::unique_ptr<ui::Context>> context = ui::make_headless_context();
    if (!context) return core::unexpected(context.error());
    core::Result<ui::FigureStage> stage = ui::FigureStage::create();
    if (!stage) return core::unexpected(stage.error());
    Turntable table(std::move(*context), std::move(*stage));
    table.stage_.set_body(ui::corners_of_body(figure_of(dressed)));
    const std::vector<core::FinishedLayer>& layers = dressed.garment.layers;
    table.stage_.set_layer_count(layers.size());
    for (std::size_t i = 0; i < layers.size(); ++i) {
        table.stage_.set_layer(i, ui::corners_of_cloth(layers[i].fitted, piece_looks(dressed, i)));
        const std::size_t made = made_as(dressed, i);
        table.look_.shown.push_back(made >= dressed.look.layers.size() || dressed.look.layers[made].shown);
    }
    double top = 0.0;
    for (const core::Vec3& v : dressed.form.mesh.vertices) top = std::max(top, v.y);
    table.height_cm_ = top;
    return table;
}

core::RgbaImage Turntable::picture(int k, int n, ui::SizePx size) {
    const double turn = 2.0 * std::numbers::pi * k / std::max(1, n), margin = kMargin * size.height;
    const ui::Rect box{margin, margin, size.width - 2.0 * margin, size.height - 2.0 * margin};
    const ui::FigureCamera camera = ui::framed(ui::solid_view(turn, kRaised_rad, height_cm_), box, height_cm_);
    ui::Target target = ui::FigureStage::make_target(size);
    stage_.draw(camera, look_, target);
    target.resolve();
    return on_ground(target.read_back(), ui::palette::kSheet);
}

}  // namespace app
