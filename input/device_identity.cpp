#include "input/device_identity.hpp"

#include <array>
#include <cstdio>

namespace input {

std::string vendor_product(const DeviceIdentity& device) {
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "%04x:%04x", device.vendor, device.product);
    return text.data();
}

}  // namespace input
