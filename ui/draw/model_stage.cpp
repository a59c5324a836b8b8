#include "ui/draw/model_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "ui/draw/palette.hpp"

namespace ui {
namespace {

constexpr double kNearGround = 0.04;  // of the height
constexpr double kCell = 0.28;        // units: two contacts nearer than this share a shadow

core::Vec3 corner_at(const ModelGeometry& geometry, int i) {
    const float* p = geometry.corners.data() + static_cast<std::ptrdiff_t>(i) * 9;
    return {p[0], p[1], p[2]};
}

}  // namespace

std::vector<GroundContact> find_ground_contacts(const ModelGeometry& geometry, core::Vec3 up) {
    double low = 1e9, high = -1e9;
    for (int i = 0; i < geometry.corner_count(); ++i) {
        const double h = core::dot(corner_at(geometry, i), up);
        low = std::min(low, h);
        high = std::max(high, h);
    }
    const core::Vec3 side =
        core::normalised(core::cross(up, std::abs(up.x) < 0.8 ? core::Vec3{1, 0, 0} : core::Vec3{0, 0, 1}));
    const core::Vec3 ahead = core::cross(side, up);
    struct Box {
        double u0 = 1e9, u1 = -1e9, v0 = 1e9, v1 = -1e9;
    };
    std::map<std::pair<int, int>, Box> cells;
    for (int i = 0; i < geometry.corner_count(); ++i) {
        const core::Vec3 p = corner_at(geometry, i);
        if (core::dot(p, up) > low + kNearGround * (high - low)) continue;
        const double u = core::dot(p, side), v = core::dot(p, ahead);
        Box& box = cells[{static_cast<int>(std::floor(u / kCell)), static_cast<int>(std::floor(v / kCell))}];
        box = {std::min(box.u0, u), std::max(box.u1, u), std::min(box.v0, v), std::max(box.v1, v)};
    }
    std::vector<GroundContact> contacts;
    for (const auto& [cell, box] : cells) {
        const core::Vec3 centre = side * ((box.u0 + box.u1) / 2) + ahead * ((box.v0 + box.v1) / 2) + up * low;
        contacts.push_back({centre, std::max(box.u1 - box.u0, box.v1 - box.v0) / 2});
    }
    return contacts;
}

core::Camera orbited(const core::Camera& base, double azimuth, double elevation) {
    const core::Vec3 level = base.direction * std::cos(azimuth) + base.right() * std::sin(azimuth);
    return {level * std::cos(elevation) + base.up * std::sin(elevation),
            base.up * std::cos(elevation) - level * std::sin(elevation)};
}

core::Point StageView::to_px(core::Vec3 p) const {
    const core::Point plane = camera.project(p);
    return {centre_px.x + (mirrored ? -plane.x : plane.x) * scale_px, centre_px.y - plane.y * scale_px};
}

core::Result<ModelStage> ModelStage::create() {
    core::Result<LitModel> model = LitModel::create();
    if (!model) return core::unexpected(model.error());
    return ModelStage(std::move(*model));
}

ModelStage::ModelStage(LitModel model)
    : model_(std::move(model)), target_({1, 1}, PixelFormat::Colour, Target::Depth::Multisampled) {}

void ModelStage::set_model(const ModelGeometry& geometry, std::vector<GroundContact> contacts) {
    model_.set_corners(geometry.corners);
    contacts_ = std::move(contacts);
}

void ModelStage::clear_model() {
    contacts_.clear();
    model_.set_corners({});
    target_ = Target({1, 1}, PixelFormat::Colour, Target::Depth::Multisampled);
}

void ModelStage::draw_shadows(const StageView& view) {
    if (contacts_.empty()) return;
    const SizePx size = target_.size();
    const double flat = std::max(std::abs(core::dot(view.camera.direction, view.ground_up)), 0.12);
    std::vector<float> quads;
    const auto add = [&](core::Point centre, double radius, double strength) {
        const Colour c = palette::kInk;
        for (const double v : {centre.x - radius, centre.y - radius * flat, 2 * radius, 2 * radius * flat}) {
            quads.push_back(static_cast<float>(v));
        }
        quads.insert(quads.end(), {c.r, c.g, c.b, static_cast<float>(strength)});
    };
    core::Point sum, low{1e9, 1e9}, high{-1e9, -1e9};
    const double strength = std::clamp(1.5 / static_cast<double>(contacts_.size()), 0.16, 0.40);
    for (const GroundContact& contact : contacts_) {
        const core::Point p = view.to_px(contact.centre);
        sum = sum + p;
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        add(p, (contact.radius + 0.10) * view.scale_px, strength);
    }
    add(sum * (1.0 / static_cast<double>(contacts_.size())), (high.x - low.x) / 2 + 0.34 * view.scale_px, 0.14);
    model_.draw_shadows(quads, size);
}

void ModelStage::draw(const StageView& view, SizePx size) {
    if (target_.size() != size) target_ = Target(size, PixelFormat::Colour, Target::Depth::Multisampled);
    target_.bind();
    clear(0, 0, 0, 0, true);
    draw_shadows(view);
    ModelLook look;
    look.camera = view.camera;
    look.sx = (view.mirrored ? -2.0 : 2.0) * view.scale_px / size.width;
    look.sy = -2.0 * view.scale_px / size.height;
    look.ox = view.centre_px.x * 2 / size.width - 1;
    look.oy = view.centre_px.y * 2 / size.height - 1;
    look.mirrored = view.mirrored;
    look.own_colours = view.own_colours;
    model_.draw(look);
    target_.resolve();
}

}  // namespace ui
