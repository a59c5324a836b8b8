#include "firmware_like_app/kiosk/garment_mode.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "firmware_like_app/garment/design_sources.hpp"
#include "firmware_like_app/kiosk/drawing_recorder.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

constexpr double kTap_px = 6;      // of the design: a pen that moved less has tapped
constexpr double kGrasp_px = 32;   // half of what a handle takes
constexpr double kBeside_px = 60;  // of the design: nearer to the figure a pen in 3D draws
constexpr double kTurn_rad_per_px = 0.006;
constexpr std::int64_t kRepeatAfter_us = 400'000, kRepeatEvery_us = 125'000;
constexpr std::int64_t kClearedOffer_us = 8'000'000;

core::Result<core::GarmentDesk> empty_desk(const std::string& size, const core::FormSource& bodies) {
    core::Design design;
    const core::Result<core::BodyMeasures> measures = core::measures_of_size(size);
    if (!measures) return core::unexpected(measures.error());
    design.body = *measures;
    core::Result<core::Mannequin> body = core::make_mannequin(design.body);
    if (!body) return core::unexpected(body.error());
    return core::GarmentDesk::open(std::move(design), core::dress_form(*body), bodies);
}

}  // namespace

core::Result<std::unique_ptr<GarmentMode>> GarmentMode::create(const ui::FontSet& fonts,
                                                               const std::vector<ui::Strings>& languages,
                                                               const GarmentOptions& options, ui::SizePx screen) {
    core::Result<ui::Painter> painter = ui::Painter::create(fonts);
    if (!painter) return core::unexpected(painter.error());
    core::Result<FigureViews> views = FigureViews::create();
    if (!views) return core::unexpected(views.error());
    return std::unique_ptr<GarmentMode>(
        new GarmentMode(fonts, languages, options, screen, std::move(*painter), std::move(*views)));
}

GarmentMode::GarmentMode(const ui::FontSet& fonts, const std::vector<ui::Strings>& languages,
                         const GarmentOptions& options, ui::SizePx screen, ui::Painter painter, FigureViews views)
    : fonts_(fonts),
      languages_(languages),
      options_(options),
      layout_(ui::garment_layout(screen, options.hand)),
      screen_(fonts, languages),
      painter_(std::move(painter)),
      views_(std::move(views)),
      builder_(options.every_frame_seen),
      drape_(options.every_frame_seen),
      objects_(options.model_source     ? options.model_source
               : options.models.empty() ? ModelSource{}
                                        : models_of_index(options.models)),
      body_files_(options.bodies, options.every_frame_seen),
      own_fabrics_(read_own_fabrics(options.fabrics)),
      keeper_(options.designs) {
    views_.lay_out(layout_, painter_);
    views_.set_quads(quads_);
    make_fabric_tiles();
}

GarmentMode::~GarmentMode() = default;

// ---- the desk

void GarmentMode::prepare() {
    if (desk_ || coming_.valid() || !failure_.empty()) return;
    coming_ = std::async(std::launch::async,
                         [make = options_.first_desk, size = options_.size, source = body_files_.source()] {
                             return make ? make(size) : empty_desk(size, source);
                         });
}

/// Waits for the body of an empty design, when it is needed before it is there.
void GarmentMode::ready_desk() {
    if (desk_) return;
    prepare();
    if (!coming_.valid()) return;
    core::Result<core::GarmentDesk> desk = coming_.get();
    if (!desk) {
        failure_ = desk.error().sentence();
        return;
    }
    desk_.emplace(std::move(*desk));
    body_.set(desk_->state().settings().body);
    stepper_.set_quads(desk_->network().options().edge_cm);
    drawing_due_ = true;
    request_cloth();
    show_cloth();
}

core::GarmentDesk& GarmentMode::desk() {
    ready_desk();
    return *desk_;
}

core::Design GarmentMode::design() {
    return desk().design();
}

namespace {

/// Whether a design begins on the body that is worn now.
bool is_worn(const core::Design& design, const core::DesignRunner& now) {
    const std::optional<core::BodyMeasures>& worn = now.worn()->form.measures;
    return worn && worn->figure == design.body.figure && worn->cm == design.body.cm;
}

core::Result<core::GarmentDesk> desk_of(const core::Design& design, const core::GarmentDesk* now,
                                        core::FormSource source) {
    if (now != nullptr && is_worn(design, now->state())) return core::GarmentDesk::open(design, now->state());
    const core::Result<core::Mannequin> body = core::make_mannequin(design.body);
    if (!body) return core::unexpected(body.error());
    return core::GarmentDesk::open(design, core::dress_form(*body), std::move(source));
}

}  // namespace

core::Result<void> GarmentMode::open(const core::Design& design) {
    core::Result<core::GarmentDesk> desk = desk_of(design, desk_ ? &*desk_ : nullptr, body_files_.source());
    if (!desk) return core::unexpected(desk.error());
    put_back();
    builder_.forget();
    coming_ = {};
    desk_.emplace(std::move(*desk));
    body_.set(desk_->state().settings().body);
    stepper_.set_quads(desk_->network().options().edge_cm);
    textured_.clear();
    choose_piece();
    objects_.choose("");
    line_.clear();
    notes_.clear();
    problem_.clear();
    drawing_due_ = true;
    request_cloth();
    show_cloth();
    return {};
}

void GarmentMode::request_cloth() {
    if (!desk_ || hold_ == Hold::Measure) return;  // a body that is tried on stays until the slider is let go
    if (std::optional<core::BuildRequest> request = desk_->build_request()) {
        builder_.submit({std::move(*request), woven_layers()});
    }
}

void GarmentMode::take_cloth() {
    std::optional<BuiltGarment> built = builder_.take();
    if (!built || !desk_) return;
    if (!desk_->accept(std::move(built->result))) return;
    textured_ = std::move(built->textured);
    show_cloth();
}

ui::FabricLook GarmentMode::look_of(const std::string& piece, int layer) const {
    ui::FabricLook look;
    look.colour = ui::Colour::hex(ui::kSwatches[static_cast<std::size_t>(layer) % 5]);
    const auto& materials = desk_->state().look().materials;
    const auto found = materials.find(piece);
    if (found == materials.end()) return look;
    look.colour = ui::colour_of(found->second.colour, look.colour);
    look.fabric = ui::fabric_of(found->second.fabric);
    for (const OwnFabric& own : own_fabrics_.fabrics) {
        if (own.picture == found->second.fabric) look.picture = own.picture;
    }
    return look;
}

/// Layers with a patterned piece.
std::vector<int> GarmentMode::woven_layers() const {
    std::vector<int> layers;
    for (const core::NetworkRegion& region : desk_->network().regions()) {
        if (!region.alive) continue;
        const ui::FabricLook look = look_of(region.name, region.layer);
        if (look.fabric != ui::Fabric::Plain || !look.picture.empty()) {
            layers.push_back(region.layer);
        }
    }
    return layers;
}

/// The cloth as the desk has it, in its fabrics, on the figure it is worn by.
void GarmentMode::show_cloth() {
    FigureDress dress;
    dress.body_shown = body_shown_;
    dress.form = desk_->form();
    const core::DesignLook& look = desk_->state().look();
    const std::vector<core::BuiltLayer>& layers = desk_->cloth();
    for (std::size_t i = 0; i < layers.size(); ++i) {
        FigureDress::Layer layer;
        layer.layer = layers[i].layer;
        layer.cloth = layers[i].cloth;
        const auto number = static_cast<std::size_t>(layer.layer);
        layer.shown = number >= look.layers.size() || look.layers[number].shown;
        if (i < textured_.size()) layer.textured = textured_[i];
        if (layer.cloth) {
            const std::vector<core::ClothPiece>& pieces = layer.cloth->fitted.pieces;
            for (const core::ClothPiece& piece : pieces) {
                const std::string& name =
                    piece.mirror_of >= 0 ? pieces[static_cast<std::size_t>(piece.mirror_of)].name : piece.name;
                layer.looks.push_back(look_of(name, layer.layer));
            }
        }
        dress.layers.push_back(std::move(layer));
    }
    views_.set_dress(std::move(dress));
    if (drape_.on()) views_.set_places(hanging_);
    show_objects();
    live_due_ = true;
    drawing_due_ = true;
}

/// Cloth that follows the pen or the slider.
void GarmentMode::follow_live() {
    if (!live_due_ || !desk_ || drape_.on()) return;
    live_due_ = false;
    const std::optional<core::GarmentDesk::Live> live = desk_->live();
    if (live && live->places != nullptr) {
        views_.set_places(live->layer, live->places);
    } else {
        views_.set_places(-1, nullptr);
    }
}

namespace {

const char* words_key(core::DeskNote::Key key) {
    using Key = core::DeskNote::Key;
    switch (key) {
        case Key::OutlineOpen:
            return "note_open";
        case Key::OpenMiddle:
            return "note_middle";
        case Key::OffBody:
            return "off_the_figure";
        case Key::NoPoint:
            return "no_point";
        case Key::PlaneEdgeOn:
            return "edge_on";
        case Key::TooShort:
            return "stroke_too_short";
        case Key::NotAcross:
            return "not_across";
        case Key::NotFilled:
            return "note_not_filled";
        case Key::LayersTouch:
            return "note_touch";
        case Key::NoRegion:
        case Key::NothingHere:
            return "nothing_here";
        case Key::BodyUnfit:
            return "body_unfit";
        case Key::Refused:
            break;
    }
    return "not_done";
}

}  // namespace

void GarmentMode::note(const core::DeskNote& note) {
    using Key = core::DeskNote::Key;
    const bool at_place = note.key == Key::OutlineOpen || note.key == Key::OpenMiddle || note.key == Key::NotFilled ||
                          note.key == Key::LayersTouch;
    if (at_place)
        notes_.emplace_back(note, words_key(note.key));
    else
        problem_ = words()[words_key(note.key)];
}

/// The slider changes the piece that was chosen; where there is none on this layer, the newest.
void GarmentMode::choose_piece() {
    if (!piece_for_folds().empty()) return;
    piece_.clear();
    for (const core::NetworkRegion& region : desk_->network().regions()) {
        if (region.alive && region.layer == desk_->layer()) piece_ = region.name;
    }
}

/// Between two ends on the middle plane: straight, and outside of the body where that bulges. False where there is no
/// other end on this side.
bool GarmentMode::close_middle(const core::DeskNote& from, std::int64_t now_us) {
    const core::DeskNote* to = nullptr;
    const std::vector<core::DeskNote> middles = open_middles(*desk_);
    for (const core::DeskNote& other : middles) {
        const double apart = core::length(other.place - from.place);
        const bool same_side = other.place.z * from.place.z >= 0;
        if (apart < 1 || !same_side) continue;
        if (to == nullptr || apart < core::length(to->place - from.place)) to = &other;
    }
    if (to == nullptr) return false;
    const core::DrawingView side = *core::named_view("left");
    core::DeskSettings& settings = desk_->settings();
    settings.tool = core::DeskTool::DrawOnPlane;
    settings.plane_cm = 0.0;
    const int steps = std::max(4, static_cast<int>(core::length(to->place - from.place)));
    for (int i = 0; i <= steps; ++i) {
        core::Vec3 place = from.place + (to->place - from.place) * (static_cast<double>(i) / steps);
        if (i > 0 && i < steps) {
            const core::FieldSample field = desk_->state().obstacle().sample(place);
            const double off = stepper_.offset_cm() - field.distance;
            if (off > 0) place = place + field.gradient * off;
        }
        place.x = 0;
        if (i == 0) {
            desk_->begin(side, side.project(place));
        } else {
            desk_->extend(side, side.project(place));
        }
    }
    const core::DeskReply reply = desk_->end();
    settings.plane_cm.reset();
    take_reply(reply, now_us);
    return true;
}

/// What an act brought: notes, a tape, another design.
void GarmentMode::take_reply(const core::DeskReply& reply, std::int64_t now_us) {
    (void)now_us;
    notes_.clear();
    problem_.clear();
    tape_ = reply.tape;
    for (const core::DeskNote& n : reply.notes) note(n);
    if (reply.changed) {
        cleared_ = false;
        stepper_.set_quads(desk_->network().options().edge_cm);
        choose_piece();
        keeper_.take(*desk_);
        request_cloth();
        show_cloth();
    }
    drawing_due_ = true;
    live_due_ = true;
}

// ---- the pointer

core::DeskTool GarmentMode::desk_tool() const {
    using T = ui::GarmentTool;
    if (erasing_) return core::DeskTool::Erase;
    switch (tool_) {
        case T::OnPlane:
            return core::DeskTool::DrawOnPlane;
        case T::OnBody:
        case T::Mirror:
            return core::DeskTool::DrawOnBody;
        case T::TemporaryPlane:
            return core::DeskTool::DrawTemporary;
        case T::Corner:
            return core::DeskTool::Corner;
        case T::Cut:
            return core::DeskTool::Cut;
        case T::Add:
            return core::DeskTool::Add;
        case T::Eraser:
            return core::DeskTool::Erase;
        case T::Move:
            return core::DeskTool::Move;
        case T::Smooth:
            return core::DeskTool::Smooth;
        case T::Bump:
            return core::DeskTool::Bump;
        case T::Weld:
            return core::DeskTool::Weld;
        case T::Hole:
            return core::DeskTool::Hole;
        case T::Remove:
            return core::DeskTool::RemoveRegion;
        case T::Measure:
            return core::DeskTool::Tape;
    }
    return core::DeskTool::Select;
}

/// What pointed, for drawing the same again. A folder that is full costs the recording, never the drawing.
void GarmentMode::record(const ui::WindowEvent& event) {
    if (ready_recorder(event.time_us)) recorder_->record(event);
}

bool GarmentMode::ready_recorder(std::int64_t now_us) {
    if (options_.record.empty() || recording_failed_) return false;
    if (recorder_) return true;
    const GarmentStart start{layout_.screen, words().code(), options_.hand};
    core::Result<std::unique_ptr<GarmentRecorder>> recorder =
        GarmentRecorder::create(next_free(options_.record, "garment"), start, now_us);
    recording_failed_ = !recorder.has_value();
    if (recording_failed_) return false;
    recorder_ = std::move(*recorder);
    return true;
}

/// Two fingers, or the wheel. What one finger drew until the second came is taken back: it was never meant as a line.
void GarmentMode::gesture(const ui::WindowEvent& event) {
    if (drawer_ != ui::GarmentDrawer::None) return;
    if (event.finger && hold_ == Hold::Drawing && desk_) {
        desk_->cancel();
        stroke_px_.clear();
        drawing_due_ = live_due_ = true;
        hold_ = Hold::Gesture;
    }
    if (event.finger && (hold_ == Hold::Turning || hold_ == Hold::Moving)) hold_ = Hold::Gesture;
    if (hold_ != Hold::None && hold_ != Hold::Gesture) return;
    const core::Point middle{layout_.figure.centre_x(), layout_.figure.centre_y()};
    const core::Point at = event.x >= 0 && event.finger ? core::Point{event.x, event.y} : pointer_px_.value_or(middle);
    if (event.zoom != 0) views_.zoom(event.zoom, layout_.sheet.contains(at.x, at.y) ? at : middle);
    if (event.shift_x == 0 && event.shift_y == 0) return;
    if (views_.view() == ui::GarmentView::Solid) {
        views_.turn(-event.shift_x * kTurn_rad_per_px / layout_.scale,
                    event.shift_y * kTurn_rad_per_px / layout_.scale);
    } else {
        views_.move_by({event.shift_x, event.shift_y});
    }
}

void GarmentMode::pointer(const ui::WindowEvent& seen) {
    using Kind = ui::WindowEvent::Kind;
    ui::WindowEvent event = seen;
    event.x = whole_64ths(seen.x);
    event.y = whole_64ths(seen.y);
    record(event);
    ready_desk();
    if (gallery_open_) return gallery_pointer(event);
    if (event.kind != Kind::Zoom) pointer_px_ = core::Point{event.x, event.y};
    eraser_near_ = event.pen && event.eraser && event.kind != Kind::Leave;
    switch (event.kind) {
        case Kind::Down:
            press(event);
            break;
        case Kind::Move:
            drag(event);
            break;
        case Kind::Up:
            drag(event);
            release(event);
            if (event.finger) pointer_px_.reset();
            break;
        case Kind::Zoom:
            gesture(event);
            break;
        case Kind::TakeBack:
            take_back();
            break;
        case Kind::Leave:
            pointer_px_.reset();
            break;
        default:
            break;
    }
    pen_hovers_ = event.pen && hold_ == Hold::None && pointer_px_.has_value();
}

void GarmentMode::press(const ui::WindowEvent& event) {
    drop_hold(event.time_us);
    down_px_ = last_px_ = {event.x, event.y};
    moved_ = repeated_ = false;
    if (layout_.sheet.contains(event.x, event.y)) {
        touch_sheet(event);
        return;
    }
    const ui::GarmentState now = state(event.time_us);
    const std::vector<ui::BoardTouch::Target> targets = screen_.targets(now, layout_);
    if (const auto intent = touch_.press(targets, event.x, event.y)) act(*intent, event.time_us);
    hold_ = Hold::Board;
    if (const auto control = touch_.pressed(); control == ui::Control::Garment) {
        hold_slider({*control, touch_.pressed_item()}, event);
    }
    if (layout_.list.contains(event.x, event.y) && hold_ == Hold::Board) scroll_start_px_ = scroll_px_;
}

void GarmentMode::hold_slider(const ui::Intent& intent, const ui::WindowEvent& event) {
    const ui::GarmentIntent what = ui::garment_intent(intent.item);
    if (what.action == ui::GarmentAction::Folds) {
        put_back();
        hold_ = Hold::Folds;
        folds_piece_ = piece_for_folds();
        slide(event.x);
    } else if (what.action == ui::GarmentAction::Measure) {
        hold_ = Hold::Measure;
        slider_ = what.index;
        slide(event.x);
    } else if (what.action == ui::GarmentAction::Less || what.action == ui::GarmentAction::More) {
        repeat_by_ = what.action == ui::GarmentAction::More ? 1 : -1;
        repeats_ = 0;
        repeat_us_ = event.time_us + kRepeatAfter_us;
    } else if (what.action == ui::GarmentAction::Number) {
        hold_ = Hold::Number;
        number_start_cm_ = stepper_.cm(stepper_of()).value_or(last_place_cm(stepper_of()));
    }
}

/// In 3D, a pen that comes down beside the figure turns it; a pen's or the mouse's other button does so everywhere.
bool GarmentMode::pen_turns(const ui::WindowEvent& event) {
    if (event.button) return true;
    if (views_.view() != ui::GarmentView::Solid) return false;
    if (hanging_wanted_) return true;  // to look at it from all sides; where it hangs must not matter for a replay
    for (const core::NetworkVertex& vertex : desk_->network().vertices()) {
        if (!vertex.alive || vertex.layer != desk_->layer()) continue;
        const core::Point px = views_.camera().to_px(vertex.place);
        if (core::distance(px, {event.x, event.y}) < layout_.px(kGrasp_px)) return false;
    }
    return !views_.near_figure({event.x, event.y}, layout_.px(kBeside_px));
}

void GarmentMode::touch_sheet(const ui::WindowEvent& event) {
    if (!desk_) return;
    erasing_ = event.eraser;
    if (!erasing_ && hold_object(event)) return;
    if (!erasing_ && pen_turns(event)) {
        hold_ = views_.view() == ui::GarmentView::Solid ? Hold::Turning : Hold::Moving;
        return;
    }
    put_back();
    hold_ = Hold::Drawing;
    core::DeskSettings& settings = desk_->settings();
    settings.tool = desk_tool();
    stepper_.set(settings, views_.camera().view);
    const double scale = views_.camera().scale_px;
    const bool grasps = tool_ == ui::GarmentTool::Move || tool_ == ui::GarmentTool::Weld ||
                        tool_ == ui::GarmentTool::Corner || erasing_ || tool_ == ui::GarmentTool::Eraser;
    settings.reach_cm = (grasps ? layout_.px(kGrasp_px) : layout_.px(kGrasp_px) * 0.5) / scale;
    stroke_px_ = {{event.x, event.y}};
    problem_.clear();
    tape_.reset();
    desk_->begin(views_.camera().view, views_.camera().to_drawing({event.x, event.y}));
    live_due_ = true;
}

void GarmentMode::drag(const ui::WindowEvent& event) {
    const core::Point at{event.x, event.y};
    if (core::distance(at, down_px_) > layout_.px(kTap_px)) moved_ = true;
    switch (hold_) {
        case Hold::Drawing:
            if (at == stroke_px_.back()) break;
            stroke_px_.push_back(at);
            desk_->extend(views_.camera().view, views_.camera().to_drawing(at));
            live_due_ = true;
            break;
        case Hold::Turning:
            views_.turn(-(at.x - last_px_.x) * kTurn_rad_per_px / layout_.scale,
                        (at.y - last_px_.y) * kTurn_rad_per_px / layout_.scale);
            break;
        case Hold::Moving:
            views_.move_by(at - last_px_);
            break;
        case Hold::Object:
            objects_.drag(at);
            show_objects();
            break;
        case Hold::Folds:
        case Hold::Measure:
            slide(event.x);
            break;
        case Hold::Number:
            if (moved_) stepper_.drag(stepper_of(), number_start_cm_, (at.x - down_px_.x) / layout_.scale);
            break;
        case Hold::Board:
            touch_.move(event.x, event.y);
            if (!touch_.pressed()) repeat_us_.reset();
            if (layout_.list.contains(down_px_.x, down_px_.y) && moved_ &&
                ui::GarmentScreen::most_scroll_px(state(event.time_us), layout_) > 0) {
                hold_ = Hold::List;
                touch_.cancel();
            }
            break;
        case Hold::List: {
            const double most = ui::GarmentScreen::most_scroll_px(state(event.time_us), layout_);
            const double wanted = std::clamp(scroll_start_px_ + down_px_.y - at.y, 0.0, most);
            scroll_px_ = std::round(wanted / layout_.row_pitch) * layout_.row_pitch;
            break;
        }
        case Hold::None:
        case Hold::Gesture:
            break;
    }
    last_px_ = at;
}

void GarmentMode::slide(double x) {
    if (hold_ == Hold::Folds) {
        folds_ = ui::slider_share(layout_.slider, x, layout_.scale);
        if (!folds_piece_.empty()) desk_->slide_alpha(folds_piece_, core::kClosedFlowAlpha * folds_);
        live_due_ = true;
    } else if (hold_ == Hold::Measure) {
        body_.slide(slider_, ui::slider_share(layout_.drawer_sliders[slider_], x, layout_.scale));
        body_due_ = true;
    }
}

void GarmentMode::release(const ui::WindowEvent& event) {
    const Hold held = std::exchange(hold_, Hold::None);
    repeat_until(event.time_us);
    repeat_us_.reset();
    if (held == Hold::Drawing) {
        end_stroke(event);
    } else if (held == Hold::Object) {
        let_object_go(event.time_us);
    } else if (held == Hold::Folds) {
        touch_.cancel();
        if (!folds_piece_.empty())
            take_reply(desk_->set_alpha(folds_piece_, core::kClosedFlowAlpha * folds_), event.time_us);
    } else if (held == Hold::Measure) {
        touch_.cancel();
        keep_body(event.time_us);
    } else if (held == Hold::Number) {
        touch_.cancel();
        if (!moved_) stepper_.toggle(stepper_of(), number_start_cm_);
    } else if (held == Hold::Board) {
        touch_.move(event.x, event.y);
        if (const auto intent = touch_.release()) act(*intent, event.time_us);
    }
    keep_quads(event.time_us);
}

void GarmentMode::end_stroke(const ui::WindowEvent& event) {
    stroke_px_.clear();
    drawing_due_ = live_due_ = true;
    if (!moved_ && core::goes_on_with(desk_->settings().tool)) return end_tap(event);
    take_reply(desk_->end(), event.time_us);
    erasing_ = false;
}

/// With a tool that draws lines: the line that goes on gets a point; an end, or a corner, begins one that does; what
/// else is touched is chosen.
void GarmentMode::end_tap(const ui::WindowEvent& event) {
    if (desk_->goes_on()) return take_reply(desk_->end_tapped(), event.time_us);
    desk_->cancel();
    const bool from_side = views_.view() == ui::GarmentView::Side || views_.view() == ui::GarmentView::OtherSide;
    for (const core::DeskNote& middle : open_middles(*desk_)) {  // seen from the side it is drawn
        const core::Point at = views_.camera().to_px(middle.place);
        const bool met = !from_side && core::distance(at, {event.x, event.y}) < layout_.px(kGrasp_px);
        if (met && close_middle(middle, event.time_us)) return;
    }
    if (desk_->go_on(views_.camera().view, views_.camera().to_drawing({event.x, event.y}))) {
        problem_.clear();
        notes_.clear();
        return;
    }
    select_at({event.x, event.y});
}

void GarmentMode::select_at(core::Point px) {
    const core::Pick pick = desk_->pick(views_.camera().view, views_.camera().to_drawing(px));
    objects_.choose(objects_.at(px, objects(), views_.camera()));
    line_ = pick.kind == core::Pick::Kind::Line ? pick.name.substr(0, pick.name.find('/')) : "";
    if (pick.kind == core::Pick::Kind::Region) piece_ = pick.name;
    problem_.clear();
    notes_.clear();
}

void GarmentMode::drop_hold(std::int64_t now_us) {
    (void)now_us;
    touch_.cancel();
    repeat_us_.reset();
    const Hold held = std::exchange(hold_, Hold::None);
    if (held == Hold::Drawing) {
        stroke_px_.clear();
        take_reply(desk_->end(), now_us);
    }
    if (held == Hold::Folds) desk_->drop_live();
    if (held == Hold::Object) let_object_go(now_us);
    if (held == Hold::Measure) keep_body(now_us);
    keep_quads(now_us);
    live_due_ = true;
}

/// What was held is as if it had never been touched.
void GarmentMode::take_back() {
    touch_.cancel();
    repeat_us_.reset();
    const Hold held = std::exchange(hold_, Hold::None);
    if (desk_ && held == Hold::Drawing) desk_->cancel();
    if (desk_ && held == Hold::Folds) desk_->drop_live();
    if (desk_ && held == Hold::Object) {
        (void)objects_.let_go();
        show_objects();
    }
    if (desk_ && held == Hold::Measure) body_.set(desk_->state().worn()->form.measures.value_or(body_.measures()));
    if (desk_) stepper_.set_quads(desk_->network().options().edge_cm);
    body_due_ = erasing_ = false;
    stroke_px_.clear();
    pointer_px_.reset();
    drawing_due_ = live_due_ = true;
}

void GarmentMode::cancel_pointer(std::int64_t now_us) {
    if (hold_ != Hold::None) {
        ui::WindowEvent cancelled;
        cancelled.kind = ui::WindowEvent::Kind::Cancel;
        cancelled.time_us = now_us;
        record(cancelled);
        drop_hold(now_us);
    }
    pointer_px_.reset();
    pen_hovers_ = eraser_near_ = false;
}

// ---- frames

/// A stepper that is held goes on stepping: as often as its time allows, whenever frames come.
void GarmentMode::repeat_until(std::int64_t now_us) {
    while (repeat_us_ && now_us >= *repeat_us_) {
        step_number(repeat_by_);
        ++repeats_;
        repeat_us_ = *repeat_us_ + kRepeatEvery_us;
        repeated_ = true;
    }
}

void GarmentMode::update(std::int64_t now_us) {
    if (!desk_) {
        // the body of an empty design is made meanwhile; who draws waits for it, who looks does not
        if (!coming_.valid() || coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        ready_desk();
        if (!desk_) return;
    }
    repeat_until(now_us);
    if (cleared_ && now_us - cleared_us_ > kClearedOffer_us) cleared_ = false;  // Undo still brings it back
    if (gallery_open_) {
        gallery_->update(now_us);
        for (auto& [id, picture] : gallery_->take_pictures()) {
            ui::Texture texture({picture.width, picture.height}, ui::PixelFormat::Colour);
            texture.upload(0, 0, texture.size(), picture.pixels);
            painter_.set_picture(id, &gallery_pictures_.insert_or_assign(id, std::move(texture)).first->second);
        }
    }
    if (std::exchange(body_due_, false)) try_body();
    request_cloth();
    take_cloth();
    take_own_body(now_us);
    follow_drape(now_us);
    follow_live();
}

int GarmentMode::update_ink() {
    if (!desk_) return 0;
    follow_live();
    const bool moves = (hold_ != Hold::None && hold_ != Hold::Board) || (drape_.on() && drape_.moving());
    views_.set_moving(options_.every_frame_seen && moves);
    if (views_.draw()) painter_.set_picture(FigureViews::kFigure, &views_.figure_texture());
    project();
    return 0;
}

void GarmentMode::settle(std::int64_t now_us) {
    ready_desk();
    if (!desk_) return;
    request_cloth();
    builder_.wait();
    update(now_us);
    follow_live();
    views_.set_moving(false);
    views_.draw_all();
    painter_.set_picture(FigureViews::kFigure, &views_.figure_texture());
    project();
}

void GarmentMode::project() {
    if (!drawing_due_ && projected_geometry_ == views_.geometry()) return;
    drawing_due_ = false;
    projected_geometry_ = views_.geometry();
    using T = ui::GarmentTool;
    SheetWishes wishes;
    wishes.shaping =
        tool_ == T::Move || tool_ == T::Weld || tool_ == T::Corner || tool_ == T::Smooth || tool_ == T::Bump;
    const core::LineGoingOn* going = desk_->line_going_on();
    wishes.selected_line = going != nullptr ? going->name : line_;
    drawing_ = hanging_wanted_ ? SheetDrawing{} : draw_sheet(*desk_, views_, wishes);
    make_washes();
}

bool GarmentMode::changed(std::int64_t now_us) const {
    return views_.due() || drawing_due_ || projected_geometry_ != views_.geometry() || !shown_ ||
           !(shown_at(now_us) == *shown_);
}

GarmentMode::Shown GarmentMode::shown_at(std::int64_t now_us) const {
    Shown shown{state(now_us), std::nullopt, layout_.screen, layout_.hand};
    if (gallery_open_) {
        shown.gallery = gallery_->state();
        if (touch_.pressed()) shown.gallery->pressed = touch_.pressed_item();
    }
    return shown;
}

void GarmentMode::draw(std::int64_t now_us, bool flip) {
    shown_ = shown_at(now_us);
    if (shown_->gallery) {
        painter_.paint(gallery_->page(layout_.screen, shown_->gallery->pressed).list, layout_.screen, flip);
        return;
    }
    painter_.paint(screen_.draw(shown_->state, layout_), layout_.screen, flip);
}

// ---- around visitors

bool GarmentMode::has_work() const {
    return desk_ && (desk_->can_undo() || desk_->can_redo() || desk_->is_open() || put_away_);
}

void GarmentMode::wipe(std::size_t language, ui::Hand hand) {
    put_back();
    objects_.forget();
    body_files_.forget();
    typed_.reset();
    recorder_.reset();
    recording_failed_ = false;
    keep_picture();
    (void)keeper_.end();
    if (gallery_open_) leave_gallery();
    export_no_place_ = false;
    touch_.cancel();
    hold_ = Hold::None;
    pointer_px_.reset();
    stroke_px_.clear();
    const bool worked = desk_ && (has_work() || desk_->state().settings().body.cm != GarmentBody().measures().cm);
    tool_ = ui::GarmentTool::OnBody;
    page_ = 0;
    stepper_ = GarmentStepper();
    quads_ = body_shown_ = true;
    history_shown_ = false;
    drawer_ = ui::GarmentDrawer::None;
    body_ = GarmentBody();
    body_problem_.clear();
    problem_.clear();
    notes_.clear();
    tape_.reset();
    piece_.clear();
    line_.clear();
    cleared_ = find_wanted_ = erasing_ = eraser_near_ = false;
    repeat_us_.reset();
    put_away_.reset();
    scroll_px_ = 0;
    drawing_ = {};
    washes_.clear();
    options_.language = language;
    views_.reset_cameras();
    views_.show(ui::GarmentView::Front);
    views_.set_quads(quads_);
    if (worked) {
        builder_.forget();
        textured_.clear();
        desk_.reset();
        prepare();
        views_.set_objects({});
        views_.set_dress({});
    } else if (desk_) {
        show_cloth();  // the body, where the last visitor hid it
    }
    set_hand(hand);
    shown_.reset();
    drawing_due_ = true;
}

void GarmentMode::resize(ui::SizePx screen) {
    if (screen.width < 1 || screen.height < 1 || screen == layout_.screen) return;
    relayout(screen, options_.hand);
}

void GarmentMode::set_hand(ui::Hand hand) {
    if (hand != options_.hand) relayout(layout_.screen, hand);
}

void GarmentMode::relayout(ui::SizePx screen, ui::Hand hand) {
    options_.hand = hand;
    layout_ = ui::garment_layout(screen, hand);
    views_.lay_out(layout_, painter_);
    scroll_px_ = 0;
    drawing_due_ = true;
}

}  // namespace app
