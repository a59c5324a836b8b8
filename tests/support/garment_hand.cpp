#include "tests/support/garment_hand.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "core/garment/wardrobe.hpp"

namespace test {

using Kind = ui::WindowEvent::Kind;

void GarmentHand::enter() {
    kiosk_.shell->open_sheet(kiosk_.now_us);
    kiosk_.wait(0.05);
    const ui::Rect modes = kiosk_.find->layout().mode_switch;
    kiosk_.tap(modes.x + modes.width * 0.75, modes.centre_y());
    kiosk_.garment->settle(kiosk_.now_us);
}

void GarmentHand::open(const char* design) {
    const core::Mannequin body = *core::make_mannequin(*core::measures_of_size("38"));
    const core::Result<void> opened = kiosk_.garment->open(*core::wardrobe_design(design, body));
    if (!opened) throw std::runtime_error(opened.error().sentence());
    kiosk_.garment->settle(kiosk_.now_us);
}

void GarmentHand::press(ui::GarmentAction action, std::size_t index) {
    const ui::GarmentScreen screen(kiosk_.fonts(), kiosk_.languages);
    const ui::GarmentState state = kiosk_.garment->state(kiosk_.now_us);
    for (const ui::BoardTouch::Target& target : screen.targets(state, kiosk_.garment->layout())) {
        if (target.control != ui::Control::Garment || target.item != ui::garment_item(action, index)) continue;
        kiosk_.tap(target.rect);
        kiosk_.wait(0.02);
        return;
    }
    throw std::runtime_error("no such control is on the board now");
}

void GarmentHand::tool(ui::GarmentTool tool) {
    for (std::size_t page = 0; page < ui::kGarmentPages; ++page) {
        for (const auto& slot : ui::tools_of_page(page)) {
            if (!slot || slot->action != ui::GarmentAction::Tool || slot->index != static_cast<std::size_t>(tool)) {
                continue;
            }
            if (kiosk_.garment->state(kiosk_.now_us).page != page) press(ui::GarmentAction::Page, page);
            press(ui::GarmentAction::Tool, slot->index);
            return;
        }
    }
}

void GarmentHand::view(ui::GarmentView view) {
    for (int i = 0; i < 3 && kiosk_.garment->views().view() != view; ++i) {
        press(ui::GarmentAction::View, ui::tile_of(view));
    }
}

core::Point GarmentHand::px(core::Point at_cm) const {
    const ui::FigureCamera& camera = kiosk_.garment->views().camera();
    return {camera.centre_px.x + at_cm.x * camera.scale_px, camera.centre_px.y - at_cm.y * camera.scale_px};
}

void GarmentHand::draw(const std::vector<core::Point>& through_cm, bool lift) {
    core::Point at = px(through_cm.front());
    kiosk_.event(Kind::Down, at.x, at.y);
    for (std::size_t i = 1; i < through_cm.size(); ++i) {
        const core::Point a = through_cm[i - 1], b = through_cm[i];
        const int steps = std::max(1, static_cast<int>(std::ceil(core::distance(a, b) * 2)));
        for (int k = 1; k <= steps; ++k) {
            at = px(a + (b - a) * (static_cast<double>(k) / steps));
            kiosk_.event(Kind::Move, at.x, at.y);
        }
    }
    if (lift) kiosk_.event(Kind::Up, at.x, at.y);
    kiosk_.wait(0.05);
}

void GarmentHand::draw_sampled(const std::vector<core::Point>& at_cm) {
    core::Point at;
    for (std::size_t i = 0; i < at_cm.size(); ++i) {
        at = px(at_cm[i]);
        kiosk_.event(i == 0 ? Kind::Down : Kind::Move, at.x, at.y);
    }
    kiosk_.event(Kind::Up, at.x, at.y);
    kiosk_.wait(0.05);
}

void GarmentHand::tap(core::Point at_cm) {
    const core::Point at = px(at_cm);
    kiosk_.tap(at.x, at.y);
    kiosk_.wait(0.02);
}

void GarmentHand::slide(const ui::Rect& slider, double share, bool lift) {
    const double reach = 24 * kiosk_.garment->layout().scale;
    const double x = slider.x + reach + (slider.width - 2 * reach) * share, y = slider.centre_y();
    kiosk_.event(Kind::Down, slider.centre_x(), y);
    for (int i = 1; i <= 6; ++i) kiosk_.event(Kind::Move, slider.centre_x() + (x - slider.centre_x()) * i / 6, y);
    if (lift) kiosk_.event(Kind::Up, x, y);
    kiosk_.wait(0.05);
}

void GarmentHand::number(double cm) {
    const ui::Rect& stepper = kiosk_.garment->layout().stepper;
    const double scale = kiosk_.garment->layout().scale;
    for (int i = 0; i < 100; ++i) {
        const std::optional<double> now = kiosk_.garment->state(kiosk_.now_us).stepper.cm;
        if (now && std::abs(*now - cm) < 0.05) return;
        const double off = now ? cm - *now : 0.1;
        if (std::abs(off) < 0.55) {
            press(off > 0 ? ui::GarmentAction::More : ui::GarmentAction::Less);
            continue;
        }
        // the drag grows with the square of its length (GarmentStepper::drag)
        const double px = (std::sqrt(0.0125 * 0.0125 + 4 * 0.0004 * std::abs(off)) - 0.0125) / (2 * 0.0004) * scale;
        const double x = stepper.centre_x(), y = stepper.centre_y();
        kiosk_.event(Kind::Down, x, y);
        for (int k = 1; k <= 4; ++k) kiosk_.event(Kind::Move, x + std::copysign(px * k / 4, off), y);
        kiosk_.event(Kind::Up, x + std::copysign(px, off), y);
        kiosk_.wait(0.02);
    }
    throw std::runtime_error("the stepper does not reach that number");
}

void GarmentHand::wheel(double doublings, core::Point at_px, core::Point shift_px) {
    kiosk_.event(Kind::Move, at_px.x, at_px.y);
    ui::WindowEvent event;
    event.kind = Kind::Zoom;
    event.x = event.y = -1;
    event.zoom = doublings;
    event.shift_x = shift_px.x;
    event.shift_y = shift_px.y;
    event.time_us = kiosk_.now_us;
    kiosk_.shell->pointer(event);
    kiosk_.wait(0.02);
}

void GarmentHand::zoom(double times, core::Point at_cm) {
    const ui::Rect& figure = kiosk_.garment->layout().figure;
    const core::Point middle{figure.centre_x(), figure.centre_y()};
    if (zoomed_ != 1) wheel(-std::log2(zoomed_), middle, {});
    zoomed_ = times;
    if (times == 1) return;
    wheel(std::log2(times), middle, {});
    wheel(0, middle, middle - px(at_cm));
}

core::Point GarmentHand::room_cm() const {
    const ui::GarmentLayout& layout = kiosk_.garment->layout();
    const double x = layout.figure.centre_x(), y = layout.figure.centre_y();
    const double half_x = std::min(x - layout.sheet.x, layout.sheet.right() - x);
    const double half_y = std::min(y - layout.sheet.y, layout.sheet.bottom() - y);
    const double margin = 40, scale = kiosk_.garment->views().camera().scale_px;
    return {(half_x - margin) / scale, (half_y - margin) / scale};
}

core::Point GarmentHand::seen(core::Vec3 place) const {
    const ui::FigureCamera& camera = kiosk_.garment->views().camera();
    return camera.to_drawing(camera.to_px(place));
}

core::Vec3 GarmentHand::vertex(std::size_t number) const {
    return kiosk_.garment->desk().network().vertices()[number].place;
}

void GarmentHand::skirt() {
    for (const bool front : {true, false}) {
        const double side = front ? 1 : -1;  // the back view shows the other side's x
        view(front ? ui::GarmentView::Front : ui::GarmentView::Back);
        tool(ui::GarmentTool::OnBody);
        const core::Point end = front ? core::Point{14, 106.8} : seen(vertex(1));
        draw({{0, 106}, {side * 5, 106}, {side * 10, 106.3}, end});
        tool(ui::GarmentTool::OnPlane);
        if (front) draw({seen(vertex(1)), {19, 92}, {26, 75}, {33, 58}});
        view(ui::GarmentView::Top);
        draw({seen(vertex(2)), {31, -side * 11}, {23, -side * 21}, {12, -side * 26.5}, {0, -side * 28}});
        // closes along the middle by itself
    }
    view(ui::GarmentView::Front);
}

void play(KioskStand& kiosk, const app::GarmentReplay& replay) {
    kiosk.shell->open_sheet(kiosk.now_us);
    kiosk.shell->open_garment(true, kiosk.now_us);
    const std::int64_t start_us = kiosk.now_us;
    std::size_t placed = 0;
    const auto place_before = [&](std::size_t event) {
        for (; placed < replay.placed.size() && replay.placed[placed].before <= event; ++placed)
            kiosk.garment->place(replay.placed[placed].object, kiosk.now_us);
    };
    for (std::size_t i = 0; i < replay.events.size(); ++i) {
        place_before(i);
        ui::WindowEvent event = replay.events[i];
        event.time_us += start_us;
        kiosk.shell->pointer(event);
        kiosk.now_us = event.time_us;
        kiosk.shell->update(kiosk.now_us);
    }
    place_before(replay.events.size());
}

}  // namespace test
