#include "firmware_like_app/kiosk/settings.hpp"

#include <algorithm>

namespace app {
namespace {

std::int64_t us(double seconds) {
    return static_cast<std::int64_t>(seconds * 1e6);
}

}  // namespace

StationTimes times_of(const Config& config) {
    StationTimes times;
    times.ask = us(config.idle.ask_s);
    times.ask_garment = us(config.idle.ask_garment_s);
    times.countdown = us(config.idle.countdown_s);
    times.empty = us(config.idle.empty_s);
    times.still_pen = us(config.idle.still_pen_s);
    return times;
}

input::PressureOptions pressure_of(const Config& config) {
    input::PressureOptions pressure;
    if (config.tablet.pressure == "soft") {
        pressure.high = 0.8;
        pressure.power = 0.65;
    } else if (config.tablet.pressure == "firm") {
        pressure.power = 1.6;
    }
    return pressure;
}

input::PipelineOptions pens_of(const Config& config) {
    input::PipelineOptions pens;
    pens.pressure = pressure_of(config);
    const std::string& turn = config.tablet.turn;
    if (turn == "right") pens.calibration.turn = input::Turn::Right;
    if (turn == "half") pens.calibration.turn = input::Turn::Half;
    if (turn == "left") pens.calibration.turn = input::Turn::Left;
    const std::vector<double>& area = config.tablet.area;
    if (area.size() == 4) pens.calibration.area = {area[0], area[1], area[2], area[3]};
    const std::vector<double>& align = config.tablet.align;
    if (align.size() == 6) std::copy(align.begin(), align.end(), pens.calibration.align.begin());
    return pens;
}

ui::Hand hand_of(const Config& config) {
    return config.visitors.hand == "left" ? ui::Hand::Left : ui::Hand::Right;
}

ui::palette::PartPalette part_palette_of(const Config& config) {
    return config.visitors.part_colours == "strong" ? ui::palette::PartPalette::Strong : ui::palette::PartPalette::Soft;
}

}  // namespace app
