#pragma once
// A designer's hand at the Garment screen: presses on the board's controls and strokes on the sheet, given in
// centimetres of the view that is large.

#include <vector>

#include "firmware_like_app/kiosk/garment_trace.hpp"
#include "tests/support/kiosk_stand.hpp"

namespace test {

class GarmentHand {
  public:
    explicit GarmentHand(KioskStand& kiosk) : kiosk_(kiosk) {}

    /// From any of the visitor's screens to an empty figure.
    void enter();
    /// Opens a worked design of core/garment/wardrobe instead.
    void open(const char* design);

    void press(ui::GarmentAction action, std::size_t index = 0);
    void tool(ui::GarmentTool tool);
    /// The tile, and again until it shows this view.
    void view(ui::GarmentView view);
    /// Through these places of the view, a sample every half centimetre. `lift` false: the pen stays down.
    void draw(const std::vector<core::Point>& through_cm, bool lift = true);
    /// The same with a sample at each place alone.
    void draw_sampled(const std::vector<core::Point>& at_cm);
    void tap(core::Point at_cm);
    /// Along a slider to a share of it; `lift` false: it stays held.
    void slide(const ui::Rect& slider, double share, bool lift = true);
    /// The stepper's number, by dragging and pressing: how far off the body, or where the plane of the view lies.
    void number(double cm);
    /// The wheel, and a drag with the other button: this place of the view comes to the middle, `times` as large as
    /// when the figure is framed. 1: the figure as it was.
    void zoom(double times, core::Point at_cm = {});
    /// In the middle of what lines may be drawn on, this many centimetres to each side and up and down are seen.
    [[nodiscard]] core::Point room_cm() const;
    /// The front of a skirt and its back, as a beginner draws them.
    void skirt();

    /// A place of the figure in the view's centimetres.
    [[nodiscard]] core::Point seen(core::Vec3 place) const;
    [[nodiscard]] core::Vec3 vertex(std::size_t number) const;

  private:
    [[nodiscard]] core::Point px(core::Point at_cm) const;
    void wheel(double doublings, core::Point at_px, core::Point shift_px);
    KioskStand& kiosk_;
    double zoomed_ = 1;
};

/// Opens Garment and does again what was recorded there.
void play(KioskStand& kiosk, const app::GarmentReplay& replay);

}  // namespace test
