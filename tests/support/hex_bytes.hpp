#pragma once
// Bytes as people write them: hex_bytes("05 0D 09 02").

#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "input/formats/text_lines.hpp"

namespace support {

inline std::vector<std::uint8_t> hex_bytes(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    if (!input::append_hex_bytes(text, bytes, 65536)) std::abort();  // the test itself is wrong
    return bytes;
}

/// A generic pen with everything: report 7, 12 bytes; tip, barrel, eraser, invert, in range; x and y of 32767 steps
/// over 254 by 152.4 mm; pressure to 8191; tilt in degrees from -60 to 60; a serial number would follow in real life.
inline std::vector<std::uint8_t> generic_pen_descriptor() {
    return hex_bytes(
        "05 0d 09 02 a1 01 85 07 09 20 a1 00 09 42 09 44 09 45 09 3c 09 32 09 5a 15 00 25 01 75 01 95 06 81 02 95 02 "
        "81 03 05 01 09 30 55 0d 65 13 35 00 46 10 27 26 ff 7f 75 10 95 01 81 02 09 31 46 70 17 81 02 05 0d 09 30 "
        "45 00 55 00 65 00 26 ff 1f 81 02 09 3d 09 3e 65 14 15 c4 25 3c 35 c4 45 3c 75 08 95 02 81 02 c0 c0");
}

}  // namespace support
