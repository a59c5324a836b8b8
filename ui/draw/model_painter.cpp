#include "ui/draw/model_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "ui/draw/palette.hpp"

namespace ui {
namespace {

constexpr int kOversampling = 2;
constexpr float kShadowStrength = 0.42F;

/// Image plane to picture: both -1 … 1, the picture y down.
struct Fit {
    double sx = 1, sy = -1, ox = 0, oy = 0;
    [[nodiscard]] double x(double plane_x) const { return plane_x * sx + ox; }
    [[nodiscard]] double y(double plane_y) const { return plane_y * sy + oy; }
};

/// The largest that keeps the margins, centred or leaning, and low down where there is room above.
Fit fit_box(const CardModel& model, SizePx size, const ModelPictureOptions& options) {
    const double width = std::max(model.right - model.left, 1e-6), height = std::max(model.top - model.bottom, 1e-6);
    const double room_x = (1 - 2 * options.margin) * size.width;
    const double room_y = (1 - options.margin - options.headroom - options.ground_margin) * size.height;
    const double scale = std::min(room_x / width, room_y / height);  // px a plane unit
    Fit fit;
    fit.sx = (model.mirrored ? -1.0 : 1.0) * scale * 2 / size.width;
    fit.sy = -scale * 2 / size.height;
    const double beside = (room_x - width * scale) / 2;
    const double lean = std::min(options.lean * size.width, beside) * 2 / size.width;
    fit.ox = lean - (model.left + model.right) / 2 * fit.sx;
    const double above = room_y - height * scale;  // wide models stand a little above the ground line, not in mid air
    const double ground = size.height * (1 - options.ground_margin) - above * 0.35;
    fit.oy = ground * 2 / size.height - 1 - model.bottom * fit.sy;
    return fit;
}

/// Wide faint and narrow dark ellipses under every place where the model stands.
std::vector<float> shadow_quads(const CardModel& model, const Fit& fit, SizePx size) {
    std::vector<float> quads;
    const auto add = [&](double centre, double y, double half_width, double half_height, float strength) {
        for (const double v : {centre - half_width, y - half_height, 2 * half_width, 2 * half_height}) {
            quads.push_back(static_cast<float>(v));
        }
        const Colour c = palette::kInk;
        for (const float v : {c.r, c.g, c.b, strength}) quads.push_back(v);
    };
    const double ground = (fit.y(model.bottom) + 1) / 2 * size.height;
    const double unit = size.height;
    double left = size.width, right = 0;
    for (const core::Point& span : model.contacts) {
        const double x0 = (fit.x(span.x) + 1) / 2 * size.width, x1 = (fit.x(span.y) + 1) / 2 * size.width;
        left = std::min({left, x0, x1});
        right = std::max({right, x0, x1});
        add((x0 + x1) / 2, ground - 0.008 * unit, std::abs(x1 - x0) / 2 + 0.045 * unit, 0.026 * unit, kShadowStrength);
    }
    if (right > left) {
        add((left + right) / 2, ground - 0.012 * unit, (right - left) / 2 + 0.16 * unit, 0.05 * unit,
            kShadowStrength * 0.45F);
    }
    return quads;
}

}  // namespace

PicturePlace picture_place(const CardModel& model, const ModelPictureOptions& options) {
    const Fit fit = fit_box(model, options.size, options);
    return {std::abs(fit.sx) * options.size.width / 2,
            {(fit.ox + 1) / 2 * options.size.width, (fit.oy + 1) / 2 * options.size.height},
            model.mirrored};
}

double free_at_left(const CardModel& model, const ModelPictureOptions& options, double from_y, double to_y) {
    const PicturePlace place = picture_place(model, options);
    const double band =
        (model.top - model.bottom) / static_cast<double>(std::max<std::size_t>(model.reaches.size(), 1));
    double free = options.size.width;
    for (std::size_t i = 0; i < model.reaches.size(); ++i) {
        const core::Point& reach = model.reaches[i];
        const double low = place.origin_px.y - (model.bottom + static_cast<double>(i) * band) * place.scale_px;
        if (reach.x > reach.y || low - band * place.scale_px > to_y || low < from_y) continue;
        free = std::min(free, place.origin_px.x + (model.mirrored ? -reach.y : reach.x) * place.scale_px);
    }
    return free;
}

core::Result<ModelPainter> ModelPainter::create() {
    core::Result<LitModel> model = LitModel::create();
    if (!model) return core::unexpected(model.error());
    return ModelPainter(std::move(*model));
}

Texture ModelPainter::paint(const CardModel& model, const ModelPictureOptions& options) {
    Target& target = draw(model, options);
    target.resolve();
    return target.take_texture();
}

core::RgbaImage ModelPainter::paint_image(const CardModel& model, const ModelPictureOptions& options) {
    return draw(model, options).read_back();
}

void ModelPainter::warm_up() {
    auto triangle = std::make_shared<ModelGeometry>();
    for (const double angle : {0.5, 2.6, 4.7}) {
        const auto x = static_cast<float>(std::cos(angle)), y = static_cast<float>(std::sin(angle));
        triangle->corners.insert(triangle->corners.end(), {x, y, 0, 0, 0, 1, 1, 1, 1});
    }
    CardModel model;
    model.geometry = std::move(triangle);
    model.part_map.width = model.part_map.height = 1;
    model.part_map.pixels = {0, 0, 0, 0};
    model.contacts = {{-0.5, 0.5}};
    ModelPictureOptions options;
    options.size = {16, 16};
    (void)paint(model, options);
    targets_.clear();
    finish();
}

Target& ModelPainter::target_of(SizePx size) {
    constexpr std::size_t kSizes = 2;  // the best card and the others
    const auto found =
        std::find_if(targets_.begin(), targets_.end(), [&](const Target& t) { return t.size() == size; });
    if (found != targets_.end()) {
        std::rotate(targets_.begin(), found, found + 1);
    } else {
        if (targets_.size() == kSizes) targets_.pop_back();
        targets_.insert(targets_.begin(), Target(size, PixelFormat::Colour, Target::Depth::Multisampled));
    }
    return targets_.front();
}

Target& ModelPainter::draw(const CardModel& model, const ModelPictureOptions& options) {
    const SizePx size{options.size.width * kOversampling, options.size.height * kOversampling};
    Target& target = target_of(size);
    target.bind();
    clear(0, 0, 0, 0, true);
    const Fit fit = fit_box(model, size, options);

    model_.draw_shadows(shadow_quads(model, fit, size), size);
    Texture map({std::max(model.part_map.width, 1), std::max(model.part_map.height, 1)}, PixelFormat::Colour);
    if (model.part_map.width > 0) map.upload(0, 0, map.size(), model.part_map.pixels);
    ModelLook look{model.camera, fit.sx, fit.sy, fit.ox, fit.oy, model.mirrored, options.own_colours, nullptr, 0.0F};
    look.parts = model.part_map.width > 0 ? &map : nullptr;
    look.part_share = palette::kPartShare;
    model_.set_corners(model.geometry->corners);
    model_.draw(look);
    return target;
}

}  // namespace ui
