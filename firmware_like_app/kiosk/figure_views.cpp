#include "firmware_like_app/kiosk/figure_views.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace app {
namespace {

constexpr double kMostZoom = 8;
constexpr double kSlow_ms = 14;   // of a picture: more than a frame has
constexpr int kSlowPictures = 2;  // in a row, before drafts are drawn
constexpr double kMostElevation = 1.2;
constexpr double kDefaultAzimuth = 0.5, kDefaultElevation = 0.1;
constexpr double kHeadRoom_cm = 2;
constexpr ui::Colour kObjectColour = ui::Colour::hex(0x8F7F6B);  // leather, darker than the figure

ui::SizePx whole(const ui::Rect& rect) {
    return {std::max(1, static_cast<int>(rect.width)), std::max(1, static_cast<int>(rect.height))};
}

double height_of(const core::TriangleMesh& mesh) {
    double top = 0;
    for (const core::Vec3& v : mesh.vertices) top = std::max(top, v.y);
    return top;
}

}  // namespace

core::Result<FigureViews> FigureViews::create() {
    core::Result<ui::FigureStage> stage = ui::FigureStage::create();
    if (!stage) return core::unexpected(stage.error());
    return FigureViews(std::move(*stage));
}

FigureViews::FigureViews(ui::FigureStage stage)
    : stage_(std::move(stage)),
      large_(ui::FigureStage::make_target({1, 1})),
      draft_(ui::FigureStage::make_target({1, 1})) {
    for (int i = 0; i < ui::kGarmentTiles; ++i) small_.push_back(ui::FigureStage::make_target({1, 1}));
}

void FigureViews::lay_out(const ui::GarmentLayout& layout, ui::Painter& painter) {
    layout_ = layout;
    large_ = ui::FigureStage::make_target(whole(layout.sheet));
    draft_ = ui::FigureStage::make_target(whole({0, 0, layout.sheet.width / 2, layout.sheet.height / 2}));
    drawn_draft_ = false;
    painter.set_picture(kFigure, &large_.texture());
    for (std::size_t i = 0; i < small_.size(); ++i) {
        small_[i] = ui::FigureStage::make_target(whole(layout.tile_pictures[i]));
        painter.set_picture(tile_picture(i), &small_[i].texture());
    }
    reset_cameras();
    tile_due_.fill(true);
}

void FigureViews::set_dress(FigureDress dress) {
    dress_ = std::move(dress);
    if (dress_.form) height_cm_ = height_of(dress_.form->mesh);
    live_.clear();
    upload();
    surfaces_changed();
}

void FigureViews::upload() {
    if (dress_.form != uploaded_form_) {
        stage_.set_body(dress_.form ? ui::corners_of_body(dress_.form->mesh) : ui::FigureCorners{});
        uploaded_form_ = dress_.form;
        aim();
    }
    stage_.set_layer_count(dress_.layers.size() + objects_.size());
    for (std::size_t i = 0; i < dress_.layers.size(); ++i) upload_layer(i);
    for (std::size_t i = 0; i < objects_.size(); ++i) upload_object(i);
}

/// Objects are drawn as layers beyond those of cloth.
void FigureViews::upload_object(std::size_t i) {
    ui::ClothCorners corners;
    if (objects_[i]) {
        corners.corners = ui::corners_of_body(*objects_[i]);
        ui::FabricLook look;
        look.colour = kObjectColour;
        corners.runs.push_back({look, 0, corners.corners.count()});
    }
    stage_.set_layer(dress_.layers.size() + i, corners);
}

void FigureViews::set_objects(std::vector<std::shared_ptr<const core::TriangleMesh>> objects) {
    if (objects == objects_) return;
    const std::vector<std::shared_ptr<const core::TriangleMesh>> before = std::exchange(objects_, std::move(objects));
    stage_.set_layer_count(dress_.layers.size() + objects_.size());
    for (std::size_t i = 0; i < objects_.size(); ++i) {
        if (i >= before.size() || before[i] != objects_[i]) upload_object(i);
    }
    surfaces_changed();
}

void FigureViews::upload_layer(std::size_t i) {
    const FigureDress::Layer& layer = dress_.layers[i];
    if (!layer.cloth) {
        stage_.set_layer(i, {});
        return;
    }
    const core::Cloth& cloth = layer.textured ? *layer.textured : layer.cloth->fitted;
    const std::vector<core::Vec3>* live = places_of(layer.layer);
    if (live != nullptr && live->size() != cloth.mesh.vertices.size()) live = nullptr;
    stage_.set_layer(i, ui::corners_of_cloth(cloth, layer.looks, live));
}

const std::vector<core::Vec3>* FigureViews::places_of(int layer) const {
    const auto found = live_.find(layer);
    return found == live_.end() ? nullptr : &found->second;
}

/// Where a layer's vertices are shown.
const std::vector<core::Vec3>& FigureViews::vertices_of(const FigureDress::Layer& layer) const {
    const std::vector<core::Vec3>& own = layer.cloth->fitted.mesh.vertices;
    const std::vector<core::Vec3>* live = places_of(layer.layer);
    return live != nullptr && live->size() == own.size() ? *live : own;
}

void FigureViews::set_places(int layer, const std::vector<core::Vec3>* places) {
    std::map<int, std::vector<core::Vec3>> one;
    if (places != nullptr) one.emplace(layer, *places);
    set_places(std::move(one));
}

void FigureViews::set_places(std::map<int, std::vector<core::Vec3>> places) {
    if (places.empty() && live_.empty()) return;  // nothing moved, nothing is put back
    const std::map<int, std::vector<core::Vec3>> before = std::exchange(live_, std::move(places));
    for (std::size_t i = 0; i < dress_.layers.size(); ++i) {
        const int layer = dress_.layers[i].layer;
        if (live_.count(layer) + before.count(layer) > 0) upload_layer(i);
    }
    surfaces_changed();
}

void FigureViews::set_quads(bool quads) {
    if (quads == quads_) return;
    quads_ = quads;
    large_due_ = true;
}

void FigureViews::set_moving(bool moving) {
    moving_ = moving;
    if (!moving && drawn_draft_) large_due_ = true;
}

void FigureViews::set_own_fabric(const std::string& name, const core::RgbaImage& picture) {
    stage_.set_own_fabric(name, picture);
}

void FigureViews::surfaces_changed() {
    large_due_ = true;
    tile_due_.fill(true);
    depth_fresh_ = false;
    ++geometry_;
}

core::DrawingView FigureViews::view_of(ui::GarmentView view) const {
    switch (view) {
        case ui::GarmentView::Side:
            return *core::named_view("left");
        case ui::GarmentView::OtherSide:
            return *core::named_view("right");
        case ui::GarmentView::Back:
            return *core::named_view("back");
        case ui::GarmentView::Top:
            return *core::named_view("top");
        case ui::GarmentView::Solid:
            return ui::solid_view(azimuth_, elevation_, height_cm_);
        case ui::GarmentView::Front:
            break;
    }
    return *core::named_view("front");
}

void FigureViews::aim() {
    camera_ = ui::framed(view_of(view_), layout_.figure, height_cm_ + kHeadRoom_cm);
    const Place& place = places_[static_cast<std::size_t>(view_)];
    const core::Point middle{layout_.figure.centre_x(), layout_.figure.centre_y()};
    camera_.scale_px *= place.zoom;
    camera_.centre_px = middle + (camera_.centre_px - middle) * place.zoom + place.moved_px;
    large_due_ = true;
    depth_fresh_ = false;
    ++geometry_;
}

void FigureViews::show(ui::GarmentView view) {
    view_ = view;
    const std::size_t tile = ui::tile_of(view);
    if (tiles_[tile] != view) {
        tiles_[tile] = view;
        tile_due_[tile] = true;
    }
    aim();
}

void FigureViews::turn(double azimuth_rad, double elevation_rad) {
    azimuth_ += azimuth_rad;
    elevation_ = std::clamp(elevation_ + elevation_rad, -kMostElevation, kMostElevation);
    tile_due_[ui::tile_of(ui::GarmentView::Solid)] = true;
    aim();
}

void FigureViews::move_by(core::Point px) {
    Place& place = places_[static_cast<std::size_t>(view_)];
    place.moved_px = place.moved_px + px;
    aim();
}

void FigureViews::zoom(double doublings, core::Point about_px) {
    Place& place = places_[static_cast<std::size_t>(view_)];
    const double before = place.zoom;
    place.zoom = std::clamp(before * std::exp2(doublings), 1.0, kMostZoom);
    if (place.zoom <= 1) {
        place = {};
    } else {  // what is under the pointer stays there
        const core::Point middle{layout_.figure.centre_x(), layout_.figure.centre_y()};
        const core::Point from = about_px - middle - place.moved_px;
        place.moved_px = place.moved_px + from * (1 - place.zoom / before);
    }
    aim();
}

void FigureViews::reset_cameras() {
    places_ = {};
    tiles_ = {ui::GarmentView::Front, ui::GarmentView::Side, ui::GarmentView::Back, ui::GarmentView::Solid};
    tile_due_.fill(true);
    azimuth_ = kDefaultAzimuth;
    elevation_ = kDefaultElevation;
    aim();
}

void FigureViews::fill_depth() {
    if (depth_fresh_) return;
    depth_fresh_ = true;
    ui::FigureCamera camera = camera_;
    camera.centre_px = camera.centre_px - core::Point{layout_.sheet.x, layout_.sheet.y};
    depth_.clear(camera, whole(layout_.sheet));
    if (dress_.form && dress_.body_shown) depth_.add(dress_.form->mesh.vertices, dress_.form->mesh.triangles);
    for (const auto& object : objects_) {
        if (object) depth_.add(object->vertices, object->triangles);
    }
    for (const FigureDress::Layer& layer : dress_.layers) {
        if (!layer.shown || !layer.cloth) continue;
        depth_.add(vertices_of(layer), layer.cloth->fitted.mesh.quads);
    }
}

bool FigureViews::near_figure(core::Point px, double reach_px) {
    fill_depth();
    return depth_.covered({px.x - layout_.sheet.x, px.y - layout_.sheet.y}, reach_px);
}

bool FigureViews::hides(core::Vec3 place) {
    fill_depth();
    return depth_.hides(place);
}

ui::FigureStage::Look FigureViews::look(bool quads) const {
    ui::FigureStage::Look look;
    look.quads = quads;
    look.body = dress_.body_shown;
    look.shadow = dress_.form != nullptr;
    for (const FigureDress::Layer& layer : dress_.layers) look.shown.push_back(layer.shown);
    return look;
}

void FigureViews::draw_large() {
    ui::FigureCamera camera = camera_;
    camera.centre_px = camera.centre_px - core::Point{layout_.sheet.x, layout_.sheet.y};
    drawn_draft_ = moving_ && slow_pictures_ >= kSlowPictures;
    if (drawn_draft_) {
        camera.scale_px /= 2;
        camera.centre_px = camera.centre_px * 0.5;
    }
    const auto start = std::chrono::steady_clock::now();
    stage_.draw(camera, look(quads_), drawn_draft_ ? draft_ : large_);
    if (moving_ && !drawn_draft_) {
        ui::finish();
        const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        slow_pictures_ = ms > kSlow_ms ? slow_pictures_ + 1 : 0;
    }
    large_due_ = false;
    ++revision_;
}

ui::FigureCamera FigureViews::tile_camera(std::size_t tile) const {
    const ui::Rect& r = layout_.tile_pictures[tile];
    const double top = std::round(layout_.px(10)), foot = std::round(layout_.px(8));
    const ui::Rect box{r.x + 4, r.y + top, r.width - 8, r.height - top - foot};
    return ui::framed(view_of(tiles_[tile]), box, height_cm_ + kHeadRoom_cm);
}

void FigureViews::draw_tile(std::size_t tile) {
    ui::FigureCamera camera = tile_camera(tile);
    camera.centre_px = camera.centre_px - core::Point{layout_.tile_pictures[tile].x, layout_.tile_pictures[tile].y};
    stage_.draw(camera, look(false), small_[tile]);
    tile_due_[tile] = false;
    ++revision_;
}

core::RgbaImage FigureViews::thumbnail() {
    ui::Target target = ui::FigureStage::make_target({240, 320});
    stage_.draw(ui::framed(view_of(ui::GarmentView::Front), {6, 10, 228, 302}, height_cm_ + kHeadRoom_cm), look(false),
                target);
    core::RgbaImage image = target.read_back();
    const std::array<float, 3> paper{ui::palette::kSheet.r, ui::palette::kSheet.g, ui::palette::kSheet.b};
    for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {  // premultiplied, over paper
        const float rest = 1.0F - static_cast<float>(image.pixels[i + 3]) / 255.0F;
        for (std::size_t c = 0; c < 3; ++c) {
            const float v = static_cast<float>(image.pixels[i + c]) + rest * paper[c] * 255.0F;
            image.pixels[i + c] = static_cast<std::uint8_t>(std::lround(std::min(v, 255.0F)));
        }
        image.pixels[i + 3] = 255;
    }
    return image;
}

bool FigureViews::due() const {
    return large_due_ || std::find(tile_due_.begin(), tile_due_.end(), true) != tile_due_.end();
}

bool FigureViews::draw() {
    if (large_due_) {
        draw_large();
        return true;
    }
    for (std::size_t i = 0; i < tile_due_.size(); ++i) {
        if (!tile_due_[i]) continue;
        draw_tile(i);
        return true;
    }
    return false;
}

void FigureViews::draw_all() {
    while (draw()) {
    }
}

}  // namespace app
