#pragma once
// Everything about the way from a device's samples to strokes that can be set, in one place.

#include <array>
#include <cstdint>
#include <optional>

namespace input {

/// Quarter turns of the tablet against the screen, clockwise, as the visitor sees it.
enum class Turn : std::uint8_t { None, Right, Half, Left };

/// Which part of the tablet is the sheet, and how it lies.
struct CalibrationOptions {
    /// Left, top, right and bottom edge of the used area, shares of the active area before it is turned. Left < right,
    /// top < bottom.
    std::array<double, 4> area{0.0, 0.0, 1.0, 1.0};
    /// Width by height of the sheet: the used area is cut down around its middle until it has the same shape, so that a
    /// circle stays a circle. Nothing: the area is stretched over the sheet. Needs a tablet that tells its size.
    std::optional<double> keep_aspect{};
    Turn turn = Turn::None;
    /// Then, in shares of the sheet, x' = a x + b y + c and y' = d x + e y + f: what aligning pen and screen found.
    std::array<double, 6> align{1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
    bool left_handed = false;  ///< the tablet lies upside down, its keys at the other hand: half a turn more
};

/// When a pen that presses is a pen that draws.
struct TipOptions {
    double down = 0.05;  ///< share of full pressure that begins a stroke, where libinput begins one
    double up = 0.01;    ///< share below which it ends; up < down, so that a light hand does not make dots
};

struct ProximityOptions {
    /// A pen that does not say that it leaves is gone after this time without a report.
    std::int64_t silence_ns = 100'000'000;
    /// The same for pens that do say it: their report may be lost, with the cable or the battery.
    std::int64_t lost_ns = 2'000'000'000;
};

/// The 1 € filter: Casiez, Roussel, Vogel, "1 € Filter: A Simple Speed-based Low-pass Filter for Noisy Input in
/// Interactive Systems" (CHI 2012). With these values a still pen's jitter falls to a third, and at 100 mm/s the line
/// lags by 4 ms.
struct SmoothingOptions {
    bool on = true;
    double least_cutoff_hz = 8.0;     ///< of a pen that stands still; lower is calmer and later
    double cutoff_per_mm_s = 0.3;     ///< added for each mm/s; higher follows fast strokes sooner
    double speed_cutoff_hz = 10.0;    ///< of the speed itself
    double unsized_width_mm = 200.0;  ///< how wide a tablet without a size counts as
};

/// From the device's pressure to the line's: 0 up to `low`, 1 from `high`, between them a power.
struct PressureOptions {
    double low = 0.0;
    double high = 1.0;   ///< low < high
    double power = 1.0;  ///< above 1 a light hand gets finer lines
};

/// Only for the ink that is shown before it is drawn; never part of a stroke.
struct PredictionOptions {
    bool on = true;
    std::int64_t ahead_ns = 16'000'000;  ///< one frame of 60 a second; two is the most that looks right
    double longest_mm = 8.0;             ///< a prediction never goes farther than this
};

/// A hand that rests on the screen while its pen draws.
struct PalmOptions {
    std::int64_t before_ns = 200'000'000;  ///< a touch that began so shortly before the pen came is the hand's
    std::int64_t after_ns = 500'000'000;   ///< and so is one that begins so shortly after it left
};

struct PipelineOptions {
    CalibrationOptions calibration;
    TipOptions tip;
    ProximityOptions proximity;
    SmoothingOptions smoothing;
    PressureOptions pressure;
    PredictionOptions prediction;
};

}  // namespace input
