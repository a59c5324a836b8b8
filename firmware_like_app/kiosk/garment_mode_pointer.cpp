// What the pointer does on the figure and about it: presses, drags, taps, gestures, and what is taken back.

#include <algorithm>
#include <cmath>
#include <utility>

#include "firmware_like_app/kiosk/drawing_recorder.hpp"
#include "firmware_like_app/kiosk/garment_mode.hpp"
#include "ui/screens/widgets.hpp"

namespace app {
namespace {

constexpr double kTap_px = 6;      // of the design: a pen that moved less has tapped
constexpr double kGrasp_px = 32;   // half of what a handle takes
constexpr double kBeside_px = 60;  // of the design: nearer to the figure a pen in 3D draws
constexpr double kTurn_rad_per_px = 0.006;
constexpr std::int64_t kRepeatAfter_us = 400'000, kRepeatEvery_us = 125'000;

}  // namespace

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
    stepper_before_ = stepper_;
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
        erasing_ = false;
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
    if (held != Hold::None) stepper_ = stepper_before_;
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

}  // namespace app
