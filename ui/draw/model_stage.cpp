#include "ui/draw/model_stage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "ui/draw/damage.hpp"
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

ModelStage::ModelStage(LitModel model) : model_(std::move(model)) {}

void ModelStage::set_model(const ModelGeometry& geometry, std::vector<GroundContact> contacts) {
    model_.set_corners(geometry.corners);
    contacts_ = std::move(contacts);
    empty_ = geometry.corners.empty();
    low_ = {1e9, 1e9, 1e9};
    high_ = {-1e9, -1e9, -1e9};
    for (int i = 0; i < geometry.corner_count(); ++i) {
        const core::Vec3 p = corner_at(geometry, i);
        low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y), std::min(low_.z, p.z)};
        high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y), std::max(high_.z, p.z)};
    }
}

void ModelStage::clear_model() {
    contacts_.clear();
    model_.set_corners({});
    empty_ = true;
    whole_ = Canvas();
    draft_ = Canvas();
    shows_draft_ = false;
}

std::vector<float> ModelStage::shadows(const StageView& view) const {
    if (contacts_.empty()) return {};
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
    return quads;
}

/// Whole pixels.
Rect ModelStage::box_of(const StageView& view, const std::vector<float>& shadows, SizePx size) const {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (int i = 0; i < 8 && !empty_; ++i) {
        const core::Point p = view.to_px(
            {(i & 1) != 0 ? high_.x : low_.x, (i & 2) != 0 ? high_.y : low_.y, (i & 4) != 0 ? high_.z : low_.z});
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    for (std::size_t i = 0; i + 7 < shadows.size(); i += 8) {
        left = std::min<double>(left, shadows[i]);
        right = std::max<double>(right, shadows[i] + shadows[i + 2]);
        top = std::min<double>(top, shadows[i + 1]);
        bottom = std::max<double>(bottom, shadows[i + 1] + shadows[i + 3]);
    }
    left = std::clamp(std::floor(left) - 1, 0.0, size.width + 0.0);
    right = std::clamp(std::ceil(right) + 1, left, size.width + 0.0);
    top = std::clamp(std::floor(top) - 1, 0.0, size.height + 0.0);
    bottom = std::clamp(std::ceil(bottom) + 1, top, size.height + 0.0);
    return {left, top, right - left, bottom - top};
}

void ModelStage::fit(Canvas& canvas, SizePx size) {
    if (canvas.target.size() == size) return;
    canvas = Canvas{Target(size, PixelFormat::Colour, Target::Depth::Multisampled), true, {}};
    canvas.target.bind();
    clear(0, 0, 0, 0, true);
    canvas.target.resolve();
}

void ModelStage::make_picture(SizePx size) {
    fit(whole_, size);
}

void ModelStage::warm_up() {
    ModelGeometry triangle;
    for (const float x : {-1.0F, 0.0F, 1.0F}) {
        triangle.corners.insert(triangle.corners.end(), {x, 1 - std::abs(x), 0, 0, 0, 1, 1, 1, 1});
    }
    set_model(triangle, {{{0, 0, 0}, 0.5}});
    StageView view;
    view.scale_px = 16;
    view.centre_px = {32, 32};
    view.own_colours = true;
    draw(view, {64, 64});
    finish();
    clear_model();
}

void ModelStage::draw(const StageView& view, SizePx size) {
    begin(view, size);
    (void)draw_piece(triangles());
}

void ModelStage::draw_draft(const StageView& view, SizePx size, double share) {
    StageView smaller = view;
    smaller.scale_px *= share;
    smaller.centre_px = view.centre_px * share;
    const auto scaled = [&](int px) { return std::max(1, static_cast<int>(px * share)); };
    fit(draft_, {scaled(size.width), scaled(size.height)});
    begin(draft_, smaller);
    (void)draw_piece(draft_, triangles());
}

void ModelStage::begin(const StageView& view, SizePx size) {
    fit(whole_, size);
    begin(whole_, view);
}

bool ModelStage::draw_piece(int triangles) {
    return draw_piece(whole_, triangles);
}

void ModelStage::begin(Canvas& canvas, const StageView& view) {
    const SizePx size = canvas.target.size();
    const std::vector<float> shadow = shadows(view);
    view_ = view;
    next_triangle_ = 0;
    box_ = box_of(view, shadow, size);
    const Rect whole{0, 0, size.width + 0.0, size.height + 0.0};
    part_ = canvas.fresh ? whole : (canvas.drawn.width > 0 ? around(canvas.drawn, box_) : box_);
    canvas.drawn = part_;  // a picture that is not drawn to its end may have left something anywhere in it
    if (part_.width <= 0 || part_.height <= 0) return;
    canvas.target.bind();
    set_scissor(static_cast<int>(part_.x), static_cast<int>(part_.y),
                {static_cast<int>(part_.width), static_cast<int>(part_.height)});
    clear(0, 0, 0, 0, true);
    model_.draw_shadows(shadow, size);
    set_scissor(0, 0, {});
}

bool ModelStage::draw_piece(Canvas& canvas, int triangles) {
    const SizePx size = canvas.target.size(), part{static_cast<int>(part_.width), static_cast<int>(part_.height)};
    const int count = std::min(triangles, model_.triangles() - next_triangle_);
    if (part.width > 0 && part.height > 0) {
        ModelLook look;
        look.camera = view_.camera;
        look.sx = (view_.mirrored ? -2.0 : 2.0) * view_.scale_px / size.width;
        look.sy = -2.0 * view_.scale_px / size.height;
        look.ox = view_.centre_px.x * 2 / size.width - 1;
        look.oy = view_.centre_px.y * 2 / size.height - 1;
        look.mirrored = view_.mirrored;
        look.own_colours = view_.own_colours;
        canvas.target.bind();
        set_scissor(static_cast<int>(part_.x), static_cast<int>(part_.y), part);
        model_.draw(look, next_triangle_, count);
        set_scissor(0, 0, {});
    }
    next_triangle_ += std::max(count, 0);
    if (next_triangle_ < model_.triangles()) return false;
    if (part.width > 0 && part.height > 0)
        canvas.target.resolve(static_cast<int>(part_.x), static_cast<int>(part_.y), part);
    const bool another = canvas.fresh || shows_draft_ != (&canvas == &draft_);
    changed_ = another ? Rect{} : part_;
    shows_draft_ = &canvas == &draft_;
    canvas.fresh = false;
    canvas.drawn = box_;
    return true;
}

}  // namespace ui
