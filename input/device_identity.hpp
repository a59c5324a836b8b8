#pragma once
// Which tablet this is.

#include <cstdint>
#include <string>

namespace input {

struct DeviceIdentity {
    std::string name;           ///< as the device or a capture says it; may be empty
    std::uint16_t bus = 0;      ///< as Linux numbers them: 3 USB, 5 Bluetooth, 0x18 I2C; 0 unknown
    std::uint16_t vendor = 0;   ///< 0 unknown
    std::uint16_t product = 0;  ///< 0 unknown
    std::uint16_t version = 0;
    int interface = -1;    ///< of a USB device; -1 unknown
    std::string serial;    ///< of the tablet, not of a pen
    std::string firmware;  ///< of a Huion or UC-Logic tablet: string 201, which tells models apart

    [[nodiscard]] bool known() const { return vendor != 0 || product != 0; }
    friend bool operator==(const DeviceIdentity&, const DeviceIdentity&) = default;
};

/// "256c:006e", lower case.
[[nodiscard]] std::string vendor_product(const DeviceIdentity& device);

}  // namespace input
