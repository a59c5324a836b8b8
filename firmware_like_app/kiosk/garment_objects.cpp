#include "firmware_like_app/kiosk/garment_objects.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/geometry/turn.hpp"
#include "firmware_like_app/garment/worn_object.hpp"

namespace app {
namespace {

constexpr double kNearest_px = 12;  // to the middle, from which turning and scaling are measured

core::Vec3 half_box(const core::TriangleMesh& mesh) {
    if (mesh.vertices.empty()) return {};
    core::Vec3 low = mesh.vertices.front(), high = low;
    for (const core::Vec3& v : mesh.vertices) {
        low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
        high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
    }
    return (high - low) * 0.5;
}

}  // namespace

void GarmentObjects::keep(const std::string& model, std::shared_ptr<const core::TriangleMesh> mesh) {
    if (!mesh) return;
    const core::Vec3 half = half_box(*mesh);
    models_[model] = {std::move(mesh), half, {}};
}

void GarmentObjects::forget() {
    models_.clear();
    in_place_.clear();
    problem_.clear();
    chosen_.clear();
    grip_ = Grip::None;
}

const GarmentObjects::Model& GarmentObjects::model_of(const std::string& name) {
    const auto known = models_.find(name);
    if (known != models_.end()) return known->second;
    core::Result<core::TriangleMesh> mesh =
        source_ ? source_(name) : core::unexpected(core::ErrorCode::FileMissing, "there is no collection");
    if (mesh) {
        keep(name, std::make_shared<const core::TriangleMesh>(std::move(*mesh)));
    } else {
        models_[name] = {nullptr, {}, mesh.error().sentence()};
    }
    return models_[name];
}

const core::PlacedObject* GarmentObjects::now(const std::vector<core::PlacedObject>& objects,
                                              const std::string& name) const {
    if (held() && dragged_.name == name) return &dragged_;
    for (const core::PlacedObject& object : objects)
        if (object.name == name) return &object;
    return nullptr;
}

std::vector<std::shared_ptr<const core::TriangleMesh>> GarmentObjects::shown(
    const std::vector<core::PlacedObject>& objects) {
    problem_.clear();
    std::vector<std::shared_ptr<const core::TriangleMesh>> out;
    decltype(in_place_) kept;
    for (const core::PlacedObject& object : objects) {
        const core::PlacedObject& placed = *now(objects, object.name);
        const Model& model = model_of(placed.model);
        if (!model.mesh) {
            problem_ = model.problem;
            out.push_back(nullptr);
            continue;
        }
        const auto known = in_place_.find(object.name);
        if (known != in_place_.end() && known->second.first == placed) {
            kept[object.name] = known->second;
        } else {
            kept[object.name] = {placed, std::make_shared<const core::TriangleMesh>(placed_mesh(placed, *model.mesh))};
        }
        out.push_back(kept[object.name].second);
    }
    in_place_ = std::move(kept);
    return out;
}

/// Of the turned box of its model: a little larger than what is seen.
std::optional<ui::Rect> GarmentObjects::box_px(const core::PlacedObject& object, const ui::FigureCamera& camera) {
    const Model& model = model_of(object.model);
    if (!model.mesh) return std::nullopt;
    core::Point low{1e9, 1e9}, high{-1e9, -1e9};
    for (int corner = 0; corner < 8; ++corner) {
        const core::Vec3 local{(corner & 1) != 0 ? model.half.x : -model.half.x,
                               (corner & 2) != 0 ? model.half.y : -model.half.y,
                               (corner & 4) != 0 ? model.half.z : -model.half.z};
        const core::Point px = camera.to_px(object.at + core::turned(local * object.scale, object.turn));
        low = {std::min(low.x, px.x), std::min(low.y, px.y)};
        high = {std::max(high.x, px.x), std::max(high.y, px.y)};
    }
    return ui::Rect{low.x, low.y, high.x - low.x, high.y - low.y};
}

std::optional<ui::ObjectHandles> GarmentObjects::handles(const std::vector<core::PlacedObject>& objects,
                                                         const ui::FigureCamera& camera, double margin_px,
                                                         const ui::Rect& reach) {
    const core::PlacedObject* object = chosen_.empty() ? nullptr : now(objects, chosen_);
    if (object == nullptr) return std::nullopt;
    const std::optional<ui::Rect> box = box_px(*object, camera);
    if (!box) return std::nullopt;
    ui::ObjectHandles out;
    const double least = 4 * margin_px;  // of a side, where most of it is out of reach
    const double left = std::clamp(box->x - margin_px, reach.x, reach.right() - least);
    const double top = std::clamp(box->y - margin_px, reach.y, reach.bottom() - least);
    const double right = std::clamp(box->right() + margin_px, left + least, reach.right());
    const double bottom = std::clamp(box->bottom() + margin_px, top + least, reach.bottom());
    out.box = {left, top, right - left, bottom - top};
    out.scale = {out.box.right(), out.box.bottom()};
    out.turn = {out.box.right(), out.box.y};
    out.scaling = grip_ == Grip::Scale;
    out.turning = grip_ == Grip::Turn;
    return out;
}

std::string GarmentObjects::at(core::Point px, const std::vector<core::PlacedObject>& objects,
                               const ui::FigureCamera& camera) {
    std::string found;
    double nearest = 0;
    for (const core::PlacedObject& object : objects) {
        const std::optional<ui::Rect> box = box_px(object, camera);
        if (!box || !box->contains(px.x, px.y)) continue;
        const double near = camera.nearness(object.at);
        if (!found.empty() && near <= nearest) continue;
        found = object.name;
        nearest = near;
    }
    return found;
}

GarmentObjects::Grip GarmentObjects::grip_at(const ui::ObjectHandles& handles, core::Point px, double reach_px) {
    const double to_turn = core::distance(px, handles.turn), to_scale = core::distance(px, handles.scale);
    if (std::min(to_turn, to_scale) <= reach_px) return to_turn < to_scale ? Grip::Turn : Grip::Scale;
    return handles.box.contains(px.x, px.y) ? Grip::Move : Grip::None;
}

void GarmentObjects::hold(Grip grip, core::Point px, const std::vector<core::PlacedObject>& objects,
                          const ui::FigureCamera& camera) {
    const core::PlacedObject* object = now(objects, chosen_);
    if (object == nullptr) return;
    start_ = dragged_ = *object;
    grip_ = grip;
    from_px_ = px;
    camera_ = camera;
}

void GarmentObjects::drag(core::Point px) {
    const core::Point middle = camera_.to_px(start_.at);
    const core::Point before = from_px_ - middle, after = px - middle;
    dragged_ = start_;
    switch (grip_) {
        case Grip::Move: {
            const core::Point moved = px - from_px_;
            dragged_.at = start_.at + camera_.view.right * (moved.x / camera_.scale_px) -
                          camera_.view.up * (moved.y / camera_.scale_px);
            break;
        }
        case Grip::Scale: {
            const double side = 2 * std::max({models_[start_.model].half.x, models_[start_.model].half.y,
                                              models_[start_.model].half.z});
            if (side <= 0) break;
            const double grown = core::length(after) / std::max(core::length(before), kNearest_px);
            dragged_.scale = std::clamp(start_.scale * grown, kLeastObject_cm / side, kMostObject_cm / side);
            break;
        }
        case Grip::Turn: {
            if (core::length(before) < kNearest_px || core::length(after) < kNearest_px) break;
            // y grows down: what is clockwise in pixels is so for the viewer
            const double angle = std::atan2(after.y, after.x) - std::atan2(before.y, before.x);
            dragged_.turn = core::turned_further(start_.turn, camera_.view.toward, -angle);
            break;
        }
        case Grip::None:
            break;
    }
}

std::optional<core::PlacedObject> GarmentObjects::let_go() {
    if (std::exchange(grip_, Grip::None) == Grip::None || dragged_ == start_) return std::nullopt;
    return dragged_;
}

}  // namespace app
