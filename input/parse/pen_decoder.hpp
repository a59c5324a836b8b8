#pragma once
// From the reports of one HID interface to pen reports. Pure: bytes in, values out; what a decoder remembers is said.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "input/parse/pen_layout.hpp"

namespace input {

class PenDecoder {
  public:
    virtual ~PenDecoder() = default;

    /// Whether the report is of a pen. `out` and `axes` (of the decoder, as long as it lives) are set only then.
    [[nodiscard]] virtual bool decode(std::span<const std::uint8_t> report, PenReport& out, const PenAxes*& axes) = 0;
    /// The widest axes of all its reports: what the device has.
    [[nodiscard]] virtual const PenAxes& axes() const = 0;
    /// Whether the device says when the pen leaves. Where it does not, silence must do.
    [[nodiscard]] virtual bool reports_range() const = 0;
    /// "descriptor", "fields", "wacom-intuos".
    [[nodiscard]] virtual std::string_view name() const = 0;
};

/// Layouts tried in order, the first that fits a report reads it. Remembers nothing. Never with no layouts.
[[nodiscard]] std::unique_ptr<PenDecoder> make_layout_decoder(std::vector<PenLayout> layouts, std::string name);

/// Wacom's Intuos, Intuos2 … Intuos5 and the Cintiqs of their time: packets that announce a pen with its serial number
/// and model, then packets with its state. Remembers the announced pen.
struct WacomIntuosOptions {
    PenAxes axes;      ///< x, y and pressure as the model has them
    bool fine = true;  ///< Intuos3 and later: one more bit of position; their 10th byte has it
    std::vector<std::uint8_t> report_ids{2, 16};
};
[[nodiscard]] std::unique_ptr<PenDecoder> make_wacom_intuos_decoder(WacomIntuosOptions options);

/// Whether Wacom's number of a pen's model is that of its eraser end, an airbrush, a lens cursor, a mouse.
[[nodiscard]] PenTool wacom_tool(std::uint32_t tool_id);

}  // namespace input
