#pragma once
// The decoder for one HID interface: what its descriptor says, bettered by the data file that claims the device.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "input/devices/device_file.hpp"
#include "input/parse/pen_decoder.hpp"

namespace input {

/// String descriptors by index, as the device sends them, length and type in front.
using UsbStrings = std::map<std::uint8_t, std::vector<std::uint8_t>>;

/// Layouts of the file first, then the pens of the descriptor, for reports that the file does not name. The ranges of a
/// layout are, in this order, those of the file, those of string 200 or 100 where the layout says so, those of the
/// descriptor for the same report; resolution comes from the file's size where it has one. Null when neither file nor
/// descriptor has a pen. `file` may be null.
[[nodiscard]] std::unique_ptr<PenDecoder> make_decoder(const DeviceFile* file,
                                                       const std::optional<ReportDescriptor>& descriptor,
                                                       const UsbStrings& strings);

/// The layouts that make_decoder would use, for callers who have to fill in ranges that nobody knows.
[[nodiscard]] std::vector<PenLayout> make_layouts(const DeviceFile* file,
                                                  const std::optional<ReportDescriptor>& descriptor,
                                                  const UsbStrings& strings);

}  // namespace input
