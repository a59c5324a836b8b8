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

void set_vector(const Program& program, const char* uniform, const core::Vec3& v) {
    program.set(uniform, static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
}

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
    core::Result<Program> model = Program::load("model");
    if (!model) return core::unexpected(model.error());
    core::Result<Program> soft = Program::load("soft");
    if (!soft) return core::unexpected(soft.error());
    return ModelStage(std::move(*model), std::move(*soft));
}

ModelStage::ModelStage(Program model, Program soft)
    : model_program_(std::move(model)),
      soft_program_(std::move(soft)),
      corners_({3, 3, 3}, false),
      shadows_({4, 4}, true),
      no_parts_({1, 1}, PixelFormat::Colour),
      target_({1, 1}, PixelFormat::Colour, Target::Depth::Multisampled) {
    const std::array<std::uint8_t, 4> nothing{};
    no_parts_.upload(0, 0, {1, 1}, nothing);
}

void ModelStage::set_model(const ModelGeometry& geometry, std::vector<GroundContact> contacts) {
    corners_.fill(geometry.corners);
    corner_count_ = geometry.corner_count();
    contacts_ = std::move(contacts);
}

void ModelStage::clear_model() {
    corner_count_ = 0;
    contacts_.clear();
    corners_.fill({});
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
    soft_program_.use();
    soft_program_.set("viewport", static_cast<float>(size.width), static_cast<float>(size.height));
    soft_program_.set("flip", 1.0F);
    set_blend(Blend::Over);
    shadows_.fill(quads);
    shadows_.draw_quads(static_cast<int>(quads.size() / 8));
}

void ModelStage::draw(const StageView& view, SizePx size) {
    if (target_.size() != size) target_ = Target(size, PixelFormat::Colour, Target::Depth::Multisampled);
    target_.bind();
    clear(0, 0, 0, 0, true);
    draw_shadows(view);
    if (corner_count_ > 0) {
        set_blend(Blend::Off);
        set_depth_test(true);
        no_parts_.bind(0);
        const double sx = (view.mirrored ? -2.0 : 2.0) * view.scale_px / size.width;
        const double sy = -2.0 * view.scale_px / size.height;
        model_program_.use();
        model_program_.set("parts", 0);
        set_vector(model_program_, "right", view.camera.right());
        set_vector(model_program_, "up", view.camera.up);
        set_vector(model_program_, "toward", view.camera.direction);
        model_program_.set("fit", static_cast<float>(sx), static_cast<float>(sy),
                           static_cast<float>(view.centre_px.x * 2 / size.width - 1),
                           static_cast<float>(view.centre_px.y * 2 / size.height - 1));
        model_program_.set("mirror", view.mirrored ? -1.0F : 1.0F);
        model_program_.set("clay", palette::kClay.r, palette::kClay.g, palette::kClay.b);
        model_program_.set("part_share", 0.0F);
        model_program_.set("own_share", view.own_colours ? 1.0F : 0.0F);
        corners_.draw_triangles(corner_count_);
        set_depth_test(false);
    }
    target_.resolve();
}

}  // namespace ui
