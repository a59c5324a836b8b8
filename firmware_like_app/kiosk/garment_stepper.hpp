#pragma once
// The stepper below Garment's tools: how far from the body lines lie, where the planes lie that they are drawn in, and,
// on the page of the design as a whole, how large its quads are.

#include <array>
#include <optional>

#include "core/garment/desk/desk_tool.hpp"
#include "ui/screens/garment_screen.hpp"

namespace app {

/// One number for each thing that it sets, kept while others are set. Planes begin where lines put them; a tap on the
/// number lets a plane be there again.
class GarmentStepper {
  public:
    /// What the tool draws in: the plane across an axis, or another.
    [[nodiscard]] static ui::StepperOf of(ui::GarmentTool tool, const core::DrawingView& view);
    /// As the design has it.
    void set_quads(double cm) { quads_cm_ = cm; }

    [[nodiscard]] double offset_cm() const { return offset_cm_; }
    /// None: through what a stroke starts at.
    [[nodiscard]] std::optional<double> cm(ui::StepperOf what) const;
    [[nodiscard]] ui::Stepper shown(ui::StepperOf what) const;
    /// For a stroke in this view.
    void set(core::DeskSettings& settings, const core::DrawingView& view) const;

    /// By so many tenths of a centimetre. `start_cm`: where a plane is stepped from that was nowhere.
    void step(ui::StepperOf what, int tenths, double start_cm);
    /// How many tenths the next step of a stepper takes that is held, after `repeats` of them: planes have far to go.
    [[nodiscard]] static int tenths_of_step(ui::StepperOf what, int repeats);
    /// Dragged by so many pixels of the design from where it stood at `from_cm`: fine near, far quickly.
    void drag(ui::StepperOf what, double from_cm, double design_px);
    /// A tap on the number.
    void toggle(ui::StepperOf what, double start_cm);

  private:
    [[nodiscard]] std::optional<double>& plane(ui::StepperOf what);
    void put(ui::StepperOf what, double cm);

    double offset_cm_ = 1.2, temporary_cm_ = 0.0, quads_cm_ = core::NetworkOptions{}.edge_cm;
    std::array<std::optional<double>, 3> planes_cm_;  // by axis
    std::array<std::optional<double>, 3> put_aside_;  // what a tap let go
};

}  // namespace app
