#pragma once
// What every PNG begins with.

#include <array>
#include <cstddef>
#include <cstring>
#include <span>

namespace db {

/// Only looks at the first bytes.
[[nodiscard]] inline bool is_png(std::span<const std::byte> bytes) {
    constexpr std::array<unsigned char, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    return bytes.size() > kSignature.size() && std::memcmp(bytes.data(), kSignature.data(), kSignature.size()) == 0;
}

}  // namespace db
