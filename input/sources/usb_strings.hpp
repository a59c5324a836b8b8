#pragma once
// String descriptors of a USB device by number, asked from the kernel without taking the device from its driver.

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.hpp"

namespace input {

/// The string as the device sends it, length and type in front, in English (United States), which is what tablets
/// answer to. FileUnreadable when the node may not be opened, BadFormat when the device has no such string. Waits 0.3 s
/// at most.
[[nodiscard]] core::Result<std::vector<std::uint8_t>> read_usb_string(const std::string& usb_node, std::uint8_t index);

}  // namespace input
