#pragma once
// Pens, tablets and strokes as the JSON that commands print.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "input/parse/report_descriptor.hpp"
#include "input/pipeline/stroke_builder.hpp"
#include "input/trace/trace.hpp"

namespace app {

/// Axes that the device lacks are left out.
[[nodiscard]] nlohmann::ordered_json sample_json(const input::PenSample& sample);
[[nodiscard]] nlohmann::ordered_json samples_json(const std::vector<input::PenSample>& samples);
[[nodiscard]] nlohmann::ordered_json axes_json(const input::PenAxes& axes);
[[nodiscard]] nlohmann::ordered_json identity_json(const input::DeviceIdentity& identity);
/// Its reports and pens; {"malformed": …} for one that cannot be read, {} for none.
[[nodiscard]] nlohmann::ordered_json descriptor_json(const std::vector<std::uint8_t>& bytes);
[[nodiscard]] nlohmann::ordered_json strokes_json(const std::vector<input::PenStroke>& strokes);
[[nodiscard]] const char* tool_name(input::PenTool tool);

/// "stroke 2: 48 samples in 0.24 s, 31.5 mm, pressure 0.12 to 0.80, eraser"
[[nodiscard]] std::string stroke_line(std::size_t number, const input::PenStroke& stroke);

}  // namespace app
