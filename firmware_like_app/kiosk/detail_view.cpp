#include "firmware_like_app/kiosk/detail_view.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "firmware_like_app/kiosk/card_pictures.hpp"
#include "firmware_like_app/kiosk/placing.hpp"
#include "ui/draw/coverage.hpp"
#include "ui/draw/tag_place.hpp"

namespace app {
namespace {

constexpr ui::PictureId kModel{100}, kInk{101}, kStill{102};
constexpr int kFirstWash = 110, kFirstSimilar = 130;
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kGreeting = 24 * kDegree, kRaised = 12 * kDegree;
constexpr double kLeastElevation = -10 * kDegree, kMostElevation = 75 * kDegree;
constexpr double kLeastZoom = 0.6, kMostZoom = 4, kZoomStep = 1.3;
constexpr std::int64_t kSlowFrame_us = 26'000;
constexpr int kSlowEnough = 2;
constexpr double kDraft = 0.5;
constexpr int kPieceTriangles = 2'500;  // of a whole picture that takes several frames: 5 to 10 ms of two cores
constexpr double kDrawingMargin = 0.11;
constexpr double kStillShare = 0.4;   // of the model's place: its picture has twice the pixels each way
constexpr double kTagsApart_px = 38;  // of the design: a number on the drawing and its edge

ui::PictureId wash_id(std::size_t i) {
    return ui::PictureId{kFirstWash + static_cast<int>(i)};
}
ui::PictureId similar_id(std::size_t i) {
    return ui::PictureId{kFirstSimilar + static_cast<int>(i)};
}

ui::SizePx whole(const ui::Rect& rect) {
    return {std::max(1, static_cast<int>(rect.width)), std::max(1, static_cast<int>(rect.height))};
}

/// Fast off, slow on: the cubic of the design, (.2, 0, 0, 1), as close as needs be.
double eased(double t) {
    t = std::clamp(t, 0.0, 1.0);
    const double s = 1 - t;
    return 1 - s * s * s;
}

std::vector<ui::PartRegion> regions_of(const FoundModel& model) {
    std::vector<ui::PartRegion> regions;
    for (const FoundPart& part : model.parts) regions.push_back({part.colour, part.on_view});
    return regions;
}

/// Whether some of the surface stands between the point and a viewer in that direction (Moeller, Trumbore 1997).
/// Linear.
bool is_covered(const ui::ModelGeometry& surface, core::Vec3 point, core::Vec3 toward) {
    constexpr double kItself = 0.05;  // nearer than this it is the part's own surface
    const auto corner = [&](std::size_t i) {
        const float* f = surface.corners.data() + i * 9;
        return core::Vec3{f[0], f[1], f[2]};
    };
    for (std::size_t i = 0; i + 2 < static_cast<std::size_t>(surface.corner_count()); i += 3) {
        const core::Vec3 a = corner(i), ab = corner(i + 1) - a, ac = corner(i + 2) - a;
        const core::Vec3 p = core::cross(toward, ac);
        const double det = core::dot(ab, p);
        if (std::abs(det) < 1e-12) continue;
        const core::Vec3 from = point - a;
        const double u = core::dot(from, p) / det;
        if (u < 0 || u > 1) continue;
        const core::Vec3 q = core::cross(from, ab);
        const double v = core::dot(toward, q) / det;
        if (v >= 0 && u + v <= 1 && core::dot(ac, q) / det > kItself) return true;
    }
    return false;
}

bool cross(const ui::DetailTag& a, const ui::DetailTag& b) {
    const auto side = [](core::Point p, core::Point q, core::Point r) { return core::cross(q - p, r - p) > 0; };
    return side(a.anchor, a.place, b.anchor) != side(a.anchor, a.place, b.place) &&
           side(b.anchor, b.place, a.anchor) != side(b.anchor, b.place, a.place);
}

/// Two numbers whose lines cross change places; each change makes the lines shorter together, so it ends.
void uncross(std::vector<ui::DetailTag>& tags) {
    bool changed = true;
    for (int pass = 0; changed && pass < 20; ++pass) {
        changed = false;
        for (std::size_t i = 0; i < tags.size(); ++i) {
            for (std::size_t k = i + 1; k < tags.size(); ++k) {
                if (!cross(tags[i], tags[k])) continue;
                std::swap(tags[i].place, tags[k].place);
                changed = true;
            }
        }
    }
}

}  // namespace

core::Result<DetailView> DetailView::create(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages) {
    core::Result<ui::ModelStage> stage = ui::ModelStage::create();
    if (!stage) return core::unexpected(stage.error());
    stage->warm_up();
    core::Result<ui::ModelPainter> cards = ui::ModelPainter::create();
    if (!cards) return core::unexpected(cards.error());
    core::Result<ui::InkLayer> ink = ui::InkLayer::create({1, 1});
    if (!ink) return core::unexpected(ink.error());
    return DetailView(fonts, languages, std::move(*stage), std::move(*cards), std::move(*ink));
}

DetailView::DetailView(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages, ui::ModelStage stage,
                       ui::ModelPainter cards, ui::InkLayer ink)
    : screen_(fonts, languages), stage_(std::move(stage)), card_painter_(std::move(cards)), ink_(std::move(ink)) {}

void DetailView::open(std::shared_ptr<const PreparedAnswer> answer, std::size_t index, core::Drawing drawing,
                      const ui::Rect& from, ui::SizePx screen, ui::Hand hand, std::int64_t now_us,
                      ui::Painter& painter) {
    answer_ = std::move(answer);
    cards_ = index < answer_->cards.size() ? answer_->cards : preparer_.prepare(answer_->answer);
    drawing_ = std::move(drawing);
    from_ = from;
    layout_ = ui::detail_layout(screen, hand);
    show(std::min(index, answer_->answer.best.size() - 1), now_us, painter);
}

void DetailView::show(std::size_t index, std::int64_t now_us, ui::Painter& painter) {
    index_ = index;
    opened_us_ = last_us_ = now_us;
    azimuth_ = 0;
    elevation_ = 0;
    zoom_ = 1;
    touched_ = turning_ = draft_ = at_rest_ = false;
    focus_.reset();
    touch_.cancel();
    lifted_ = {};
    covered_.clear();
    model_ = Model::None;
    model_since_us_.reset();
    painter.set_picture(kModel, nullptr);
    stage_.clear_model();
    surface_ = card() != nullptr ? card()->geometry : nullptr;
    if (surface_) ask_for_model();
    similar_.clear();
    for (std::size_t i = 0; i < answer_->answer.best.size() && similar_.size() < ui::kSimilarCount; ++i) {
        if (i != index_ && i < cards_.size()) similar_.push_back(i);
    }
    lay_out(painter);
    make_still(painter);
}

const ui::CardModel* DetailView::card() const {
    return index_ < cards_.size() ? cards_[index_].get() : nullptr;
}

/// The model as on its card, to be seen until it can turn.
void DetailView::make_still(ui::Painter& painter) {
    painter.set_picture(kStill, nullptr);
    still_.reset();
    if (card() == nullptr) return;
    ui::ModelPictureOptions options;
    options.size = whole({0, 0, layout_.model.width * kStillShare, layout_.model.height * kStillShare});
    still_ = card_painter_.paint(*card(), options);
    still_place_ = ui::picture_place(*card(), options);
    painter.set_picture(kStill, &*still_);
}

void DetailView::ask_for_model() {
    DetailJob job{++ticket_, surface_, found().camera, regions_of(found())};
    model_ = Model::Asked;
    if (worker_) return worker_->start(std::move(job));
    take_model(prepare_detail(job));
    upload_model();
    model_ = Model::Drawn;  // by draw_model, before the frame
}

void DetailView::take_model(PreparedDetail ready) {
    if (model_ != Model::Asked || ready.ticket != ticket_) return;  // of a result that was left
    lifted_ = std::move(ready.lifted);
    contacts_ = std::move(ready.contacts);
    if (focus_) ui::recolour(lifted_, focus_);
    model_ = Model::Lifted;
    view_.reset();
}

void DetailView::upload_model() {
    stage_.set_model(lifted_.geometry, contacts_);
    model_ = Model::Uploaded;
}

void DetailView::set_frames_are_seen(bool seen) {
    frames_are_seen_ = seen;
    worker_.reset();
    if (seen)
        worker_ = std::make_unique<NewestWorker<DetailJob, PreparedDetail>>(
            [](const DetailJob& job, const std::stop_token& /*stop*/) { return prepare_detail(job); });
}

void DetailView::use_spare_time(ui::Painter& painter) {
    if (!is_open()) return;
    if (model_ == Model::Lifted) {
        upload_model();
    } else if (model_ == Model::Uploaded) {
        stage_.make_picture(whole(layout_.stage));
        model_ = Model::Pictured;
    } else if (model_ == Model::Pictured && view_) {
        if (!drawn_view_) begin_whole();
        if (draw_piece(painter)) model_ = Model::Drawn;
    } else {
        paint_similar(1, painter);
    }
}

void DetailView::resize(ui::SizePx screen, ui::Hand hand, ui::Painter& painter) {
    layout_ = ui::detail_layout(screen, hand);
    lay_out(painter);
}

/// What depends on the size of the screen.
void DetailView::lay_out(ui::Painter& painter) {
    core::Point low, high;
    if (card() != nullptr) {
        low = {card()->left, card()->bottom};
        high = {card()->right, card()->top};
    }
    ground_ = low.y;
    plane_middle_ = (low.x + high.x) / 2;
    wide_ = std::max(high.x - low.x, 0.05);
    tall_ = std::max(high.y - low.y, 0.05);
    // room to turn: no more than the whole sphere in the sheet's width
    fit_scale_ =
        std::min({layout_.model.width / wide_, layout_.model.height * 0.94 / tall_, layout_.sheet.width * 0.47});
    view_.reset();
    drawn_view_.reset();
    make_drawing(painter);
    make_similar(painter);
}

void DetailView::make_drawing(ui::Painter& painter) {
    const ui::SizePx box = whole(layout_.drawing);
    frame_ = fit_drawing(drawing_, box.width, box.height, kDrawingMargin);
    ink_.resize(box);
    ink_.update({drawing_.strokes, false, 1, frame_, std::max(2.0, layout_.scale.scale * 4.5)});
    painter.set_picture(kInk, &ink_.texture());
    for (std::size_t i = 0; i < wash_.size(); ++i) painter.set_picture(wash_id(i), nullptr);
    wash_.clear();
    drawing_tags_.clear();
    for (int colour = 0; colour < ui::palette::kPartCount; ++colour) {
        for (const FoundPart& part : found().parts) {
            if (part.colour != colour || part.on_drawing.empty()) continue;
            core::Polygon ring;
            for (const core::Point& p : part.on_drawing) ring.push_back(frame_.to_px(p));
            if (drawing_tags_.empty() || drawing_tags_.back().colour != colour) {
                const core::Point place = ui::tag_place(ring);
                drawing_tags_.push_back({colour, place, place, false});
            }
            const ui::CoverageImage fill = ui::fill_polygon(ring, box.width, box.height);
            if (fill.coverage.pixels.empty()) continue;
            ui::Texture texture({fill.coverage.width, fill.coverage.height}, ui::PixelFormat::Coverage);
            texture.upload(0, 0, texture.size(), fill.coverage.pixels);
            wash_.push_back({std::move(texture),
                             {static_cast<double>(fill.x), static_cast<double>(fill.y),
                              static_cast<double>(fill.coverage.width), static_cast<double>(fill.coverage.height)},
                             colour});
        }
    }
    for (std::size_t i = 0; i < wash_.size(); ++i) painter.set_picture(wash_id(i), &wash_[i].coverage);
    std::vector<core::Point> places;
    for (const ui::DetailTag& tag : drawing_tags_) places.push_back(tag.place);
    ui::spread_tags(places, layout_.scale.px(kTagsApart_px));
    for (std::size_t i = 0; i < places.size(); ++i) drawing_tags_[i].place = drawing_tags_[i].anchor = places[i];
}

void DetailView::make_similar(ui::Painter& painter) {
    for (std::size_t i = 0; i < ui::kSimilarCount; ++i) painter.set_picture(similar_id(i), nullptr);
    similar_pictures_.clear();
    similar_pictures_.reserve(similar_.size());
    if (!frames_are_seen_) paint_similar(similar_.size(), painter);
}

void DetailView::paint_similar(std::size_t count, ui::Painter& painter) {
    for (; count > 0 && similar_pictures_.size() < similar_.size(); --count) {
        const std::size_t i = similar_pictures_.size();
        const auto& card = cards_[similar_[i]];
        ui::ModelPictureOptions options;
        const ui::Rect& r = layout_.similar[i];
        options.size = whole({0, 0, r.width - layout_.scale.px(12), r.height - layout_.scale.px(46)});
        similar_pictures_.push_back(card ? card_painter_.paint(*card, options)
                                         : ui::Texture({1, 1}, ui::PixelFormat::Colour));
        if (card) painter.set_picture(similar_id(i), &similar_pictures_.back());
    }
}

void DetailView::close(ui::Painter& painter) {
    for (const ui::PictureId id : {kModel, kInk, kStill}) painter.set_picture(id, nullptr);
    for (std::size_t i = 0; i < wash_.size(); ++i) painter.set_picture(wash_id(i), nullptr);
    for (std::size_t i = 0; i < ui::kSimilarCount; ++i) painter.set_picture(similar_id(i), nullptr);
    wash_.clear();
    similar_pictures_.clear();
    similar_.clear();
    stage_.clear_model();
    model_ = Model::None;
    if (worker_) worker_->forget();
    still_.reset();
    ink_.resize({1, 1});
    lifted_ = {};
    contacts_.clear();
    surface_.reset();
    covered_.clear();
    drawing_ = {};
    cards_.clear();
    answer_.reset();
    view_.reset();
    drawn_view_.reset();
    touch_.cancel();
}

void DetailView::set_focus(std::optional<int> focus) {
    if (focus == focus_) return;
    focus_ = focus;
    recolour();
}

void DetailView::recolour() {
    ui::recolour(lifted_, focus_);
    if (model_ > Model::Lifted) stage_.set_model(lifted_.geometry, contacts_);
    view_.reset();
    drawn_view_.reset();
}

void DetailView::zoom_by(double factor) {
    zoom_ = std::clamp(zoom_ * factor, kLeastZoom, kMostZoom);
}

std::optional<ui::Control> DetailView::pointer(const ui::WindowEvent& event, ui::Painter& painter) {
    using Kind = ui::WindowEvent::Kind;
    if (!is_open()) return std::nullopt;
    switch (event.kind) {
        case Kind::Zoom:
            touched_ = true;
            zoom_by(std::exp2(event.zoom));
            break;
        case Kind::Down: {
            const ui::DetailState now = state(0, event.time_us);
            (void)touch_.press(screen_.targets(now, layout_), event.x, event.y);
            if (touch_.pressed() == ui::Control::Tag) set_focus(static_cast<int>(touch_.pressed_item()));
            if (touch_.active() || !layout_.sheet.contains(event.x, event.y)) break;
            turning_ = touched_ = true;
            grip_ = {event.x, event.y};
            break;
        }
        case Kind::Move:
            touch_.move(event.x, event.y);
            if (turning_) {
                const double radian_px = layout_.ring_radius;
                azimuth_ += (found().mirrored ? 1 : -1) * (event.x - grip_.x) / radian_px;
                elevation_ = std::clamp(elevation_ + (event.y - grip_.y) / radian_px, kLeastElevation, kMostElevation);
                grip_ = {event.x, event.y};
            }
            break;
        case Kind::Up: {
            touch_.move(event.x, event.y);
            turning_ = false;
            set_focus(std::nullopt);
            const std::optional<ui::Intent> intent = touch_.release();
            if (!intent) break;
            if (intent->control == ui::Control::KeepDrawing || intent->control == ui::Control::Wear) {
                return intent->control;
            }
            act(*intent, event.time_us, painter);
            break;
        }
        default:
            cancel_pointer();
            break;
    }
    return std::nullopt;
}

void DetailView::act(const ui::Intent& intent, std::int64_t now_us, ui::Painter& painter) {
    if (intent.control == ui::Control::Card && intent.item < similar_.size()) {
        from_ = layout_.similar[intent.item];
        show(similar_[intent.item], now_us, painter);
    }
    if (intent.control == ui::Control::Larger) zoom_by(kZoomStep);
    if (intent.control == ui::Control::Smaller) zoom_by(1 / kZoomStep);
}

void DetailView::cancel_pointer() {
    touch_.cancel();
    turning_ = false;
    if (is_open()) set_focus(std::nullopt);
}

double DetailView::opened(std::int64_t now_us) const {
    return eased(static_cast<double>(now_us - opened_us_) / static_cast<double>(kOpen_us));
}

void DetailView::settle(std::int64_t now_us) {
    opened_us_ = std::min(opened_us_, now_us - kOpen_us);
}

void DetailView::update(std::int64_t now_us) {
    if (!is_open()) return;
    // drafts tell nothing of whether whole pictures would be fast enough: only those that were drawn in one go count
    if (drew_whole_) slow_frames_ = std::clamp(slow_frames_ + (now_us - last_us_ > kSlowFrame_us ? 1 : -1), 0, 4);
    last_us_ = now_us;
    if (worker_) {
        if (auto ready = worker_->take()) take_model(std::move(*ready));
    }
    if (model_ == Model::Drawn && !model_since_us_ && (opened(now_us) >= 1 || touched_)) model_since_us_ = now_us;
    if (!touched_) {
        // the greeting: once to the side and back, while the view rises to where the ground is seen; not before the
        // model has grown to its place, so that its picture need not be drawn anew meanwhile
        const std::int64_t age_us = model_since_us_ ? now_us - *model_since_us_ : 0;
        const double t = std::clamp(static_cast<double>(age_us) / static_cast<double>(kGreeting_us), 0.0, 1.0);
        azimuth_ = kGreeting * (1 - std::cos(2 * std::numbers::pi * t)) / 2;
        const double risen = static_cast<double>(age_us) / static_cast<double>(kRise_us);
        elevation_ = kRaised * eased(risen);
    }
    azimuth_ = std::remainder(azimuth_, 2 * std::numbers::pi);
    const ui::StageView now = view();
    if (view_ && *view_ == now) return;
    view_ = now;
    ++view_number_;
    covered_.clear();
    for (const ui::LiftedAnchor& anchor : lifted_.anchors) {
        covered_.push_back(is_covered(*surface_, anchor.place, now.camera.direction));
    }
}

void DetailView::draw_model(ui::Painter& painter) {
    drew_whole_ = false;
    if (!is_open() || !view_ || model_ != Model::Drawn) return;
    if (!drawn_view_ || !(*drawn_view_ == *view_)) {
        drawn_view_ = view_;
        at_rest_ = false;
        draft_ = frames_are_seen_ && slow_frames_ >= kSlowEnough;
        drew_whole_ = !draft_;
        const ui::SizePx size = whole(layout_.stage);
        if (draft_) {
            stage_.draw_draft(*view_, size, kDraft);
        } else {
            stage_.draw(*view_, size);
        }
        show_stage(painter);
    } else if (draft_) {
        if (!at_rest_) begin_whole();
        at_rest_ = true;
        draft_ = !draw_piece(painter);
    }
}

void DetailView::begin_whole() {
    drawn_view_ = view_;
    stage_.begin(*view_, whole(layout_.stage));
    whole_us_ = 0;
}

/// True with the last one. A model that is slow to draw is a draft from its next turn on.
bool DetailView::draw_piece(ui::Painter& painter) {
    const auto start = std::chrono::steady_clock::now();
    const bool ended = stage_.draw_piece(kPieceTriangles);
    ui::finish();
    const auto took = std::chrono::steady_clock::now() - start;
    whole_us_ += std::chrono::duration_cast<std::chrono::microseconds>(took).count();
    if (!ended) return false;
    slow_frames_ = whole_us_ > kSlowFrame_us ? kSlowEnough : 0;
    ++view_number_;
    show_stage(painter);
    return true;
}

void DetailView::show_stage(ui::Painter& painter) {
    if (stage_.changed().width > 0) {
        painter.picture_changed(kModel, stage_.changed());
    } else {
        painter.set_picture(kModel, &stage_.texture());
    }
}

ui::StageView DetailView::view() const {
    ui::StageView v;
    const FoundModel& model = found();
    v.camera = ui::orbited(model.camera, azimuth_, elevation_);
    v.mirrored = model.mirrored;
    v.ground_up = model.camera.up;
    v.own_colours = true;
    v.scale_px = fit_scale_ * zoom_;
    // the ground under the middle of the model stays in the middle of the ring
    const core::Vec3 foot = model.camera.up * ground_ + model.camera.right() * plane_middle_;
    const core::Point at = v.camera.project(foot);
    v.centre_px = {layout_.ring.x - layout_.stage.x - (v.mirrored ? -at.x : at.x) * v.scale_px,
                   layout_.ring.y - layout_.stage.y + at.y * v.scale_px};
    return v;
}

/// Where the still picture is: its model grows from the card to where the stage shows it.
ui::Rect DetailView::still_rect(double opened) const {
    const double side = found().mirrored ? -1 : 1;
    const auto mix = [&](double a, double b) { return a + (b - a) * opened; };
    const double on_card = std::min(from_.width * 0.9 / wide_, from_.height * 0.87 / tall_);
    const double scale = mix(on_card, fit_scale_);  // px a unit of the plane
    const core::Point foot{mix(from_.centre_x(), layout_.ring.x),
                           mix(from_.bottom() - from_.height * 0.08, layout_.ring.y)};
    const double k = scale / still_place_.scale_px;
    const core::Point origin{foot.x - side * plane_middle_ * scale, foot.y + ground_ * scale};
    const ui::SizePx size = still_ ? still_->size() : ui::SizePx{};  // twice that of its place
    return {origin.x - still_place_.origin_px.x * k, origin.y - still_place_.origin_px.y * k, size.width * k / 2,
            size.height * k / 2};
}

double DetailView::still_opacity(std::int64_t now_us) const {
    if (!still_) return 0;
    if (!model_since_us_) return 1;
    return std::clamp(1 - static_cast<double>(now_us - *model_since_us_) / static_cast<double>(kFade_us), 0.0, 1.0);
}

std::vector<ui::DetailTag> DetailView::model_tags() const {
    std::vector<ui::DetailTag> tags;
    if (lifted_.anchors.empty()) return tags;
    const ui::StageView v = view();
    const double half_width = wide_ * fit_scale_ / 2, half_height = tall_ * fit_scale_ / 2;
    const core::Point centre{layout_.ring.x, layout_.ring.y - half_height};
    const double rx = std::min(half_width + layout_.scale.px(72), layout_.sheet.width / 2 - layout_.scale.px(40));
    const double ry = half_height + layout_.scale.px(60);
    std::vector<double> angles;
    for (const ui::LiftedAnchor& anchor : lifted_.anchors) {
        ui::DetailTag tag;
        tag.colour = anchor.colour;
        const core::Point p = v.to_px(anchor.place);
        tag.anchor = {p.x + layout_.stage.x, p.y + layout_.stage.y};
        const std::size_t place = tags.size();
        tag.hidden =
            core::dot(anchor.normal, v.camera.direction) < 0.05 || (place < covered_.size() && covered_[place]);
        angles.push_back(std::atan2((tag.anchor.y - centre.y) / ry, (tag.anchor.x - centre.x) / rx));
        tags.push_back(tag);
    }
    // round the model in the order of their anchors, so that no two lines cross, and far enough apart
    std::vector<std::size_t> order(tags.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return angles[a] < angles[b]; });
    const double apart = std::min(0.30, 2 * std::numbers::pi / static_cast<double>(tags.size()) * 0.9);
    for (int pass = 0; pass < 40; ++pass) {
        for (std::size_t k = 0; k < order.size() && order.size() > 1; ++k) {
            double& a = angles[order[k]];
            double& b = angles[order[(k + 1) % order.size()]];
            const double gap = b - a + (k + 1 == order.size() ? 2 * std::numbers::pi : 0);
            if (gap >= apart) continue;
            a -= (apart - gap) / 2;
            b += (apart - gap) / 2;
        }
    }
    for (std::size_t i = 0; i < tags.size(); ++i) {
        tags[i].place = {centre.x + rx * std::cos(angles[i]), centre.y + ry * std::sin(angles[i])};
    }
    uncross(tags);
    return tags;
}

ui::DetailState DetailView::state(std::size_t language, std::int64_t now_us) const {
    ui::DetailState s;
    s.language = language;
    s.name = readable_name(found().name);
    s.caption = readable_name(found().class_name);
    s.wear = wear_offered_ && found().mesh != nullptr && !found().mesh->vertices.empty();
    if (s.caption == s.name) s.caption.clear();
    s.opened = opened(now_us);
    if (model_since_us_) s.model = kModel;
    s.still = kStill;
    s.still_opacity = still_opacity(now_us);
    if (s.still_opacity > 0) s.still_rect = still_rect(s.opened);
    s.ink = kInk;
    s.inked = ink_.inked();
    const ui::Rect& box = layout_.drawing;
    for (std::size_t i = 0; i < wash_.size(); ++i) {
        const ui::Rect& r = wash_[i].in_box;
        s.wash.push_back({wash_id(i), {r.x + box.x, r.y + box.y, r.width, r.height}, wash_[i].colour, 1});
    }
    s.drawing_tags = drawing_tags_;
    for (ui::DetailTag& tag : s.drawing_tags) {
        tag.place = tag.place + core::Point{box.x, box.y};
        tag.anchor = tag.place;
    }
    s.model_tags = model_tags();
    for (std::size_t i = 0; i < similar_.size(); ++i) {
        const FoundModel& model = answer_->answer.best[similar_[i]];
        const bool pictured = cards_[similar_[i]] != nullptr && i < similar_pictures_.size();
        const bool to_come = cards_[similar_[i]] != nullptr && !pictured;
        s.similar.push_back({readable_name(model.name), pictured ? similar_id(i) : ui::PictureId{}, to_come});
    }
    s.azimuth = found().mirrored ? -azimuth_ : azimuth_;
    s.elevation = elevation_;
    s.view = view_number_;
    s.touched = touched_;
    s.focus = focus_;
    s.pressed = touch_.pressed();
    s.pressed_item = touch_.pressed_item();
    return s;
}

}  // namespace app
