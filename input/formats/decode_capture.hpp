#pragma once
// From a recording to pen samples.

#include <optional>
#include <string>
#include <vector>

#include "input/formats/surroundings.hpp"

namespace input {

struct DecodedCapture {
    DeviceIdentity device;
    std::string parser;  ///< "descriptor", "fields (huion.json)", "wacom-intuos (…)", "evdev"
    PenAxes axes;
    bool ranges_from_recording =
        false;                        ///< nobody says how far the axes go: the largest value seen counts as their end
    std::vector<std::uint16_t> keys;  ///< of an event node, those of a pen
    std::vector<PenSample> samples;   ///< device 1; times as recorded
    std::size_t reports = 0;          ///< reports, or frames of events
    std::size_t other_reports = 0;    ///< that are not of a pen
    std::optional<std::string> malformed;  ///< the recording's own report descriptor is, in a sentence
    std::optional<std::string> why_none;   ///< with no samples: what stands in the way, in a sentence
};

/// Reads a recording with all that is known. Always gives a result; without samples it says why. Linear time.
[[nodiscard]] DecodedCapture decode_capture(const Capture& capture, const Surroundings& around);

/// How often the device reports: the mean step between samples in range, steps above 100 ms left out, in Hz; 0 for
/// fewer than three samples or times that do not grow.
[[nodiscard]] double report_rate_hz(const std::vector<PenSample>& samples);

}  // namespace input
