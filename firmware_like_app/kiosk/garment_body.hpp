#pragma once
// The measures that the body drawer changes, and what it shows of them.

#include <optional>
#include <string>
#include <vector>

#include "core/mannequin/body_measures.hpp"
#include "ui/screens/garment_screen.hpp"

namespace app {

class GarmentBody {
  public:
    /// "36" … "44", "m".
    [[nodiscard]] static const std::vector<std::string>& sizes();

    GarmentBody();
    /// Starts with these measures, as a design has them.
    void set(const core::BodyMeasures& measures);
    void choose_size(std::size_t size);
    /// Back to the size that was chosen last.
    void reset() { choose_size(last_size_); }
    /// A slider at a share of its way. Rounded to tenths of a centimetre. The under bust keeps its share of the bust.
    void slide(std::size_t slider, double share);

    /// A slider's measure as it was written; nothing changes, and false, where the slider does not reach it.
    [[nodiscard]] bool write(std::size_t slider, double cm);

    [[nodiscard]] const core::BodyMeasures& measures() const { return measures_; }
    /// The size whose measures these are.
    [[nodiscard]] std::optional<std::size_t> size() const;
    [[nodiscard]] ui::BodyDrawer drawer() const;

  private:
    void set_measure(std::size_t slider, double wanted_cm);
    core::BodyMeasures measures_;
    std::size_t last_size_ = 0;
};

}  // namespace app
