#pragma once
// From the station's settings to what each piece takes.

#include "firmware_like_app/config/config.hpp"
#include "firmware_like_app/kiosk/station.hpp"
#include "input/pipeline/options.hpp"
#include "ui/draw/palette.hpp"
#include "ui/screens/find_layout.hpp"

namespace app {

[[nodiscard]] StationTimes times_of(const Config& config);
/// Soft: a light hand draws full lines; firm: a heavy one has room.
[[nodiscard]] input::PressureOptions pressure_of(const Config& config);
[[nodiscard]] input::PipelineOptions pens_of(const Config& config);
[[nodiscard]] ui::Hand hand_of(const Config& config);
[[nodiscard]] ui::palette::PartPalette part_palette_of(const Config& config);

}  // namespace app
