#pragma once
// Checksums of byte ranges: a 64-bit FNV-1a for "is this still what was written" and for content identity.

#include <cstddef>
#include <cstdint>
#include <span>

namespace core {

/// FNV-1a, 64 bits, of a byte range, continued from `seed`. Not for adversaries. Linear time.
[[nodiscard]] inline std::uint64_t fnv1a64(std::span<const std::byte> bytes,
                                           std::uint64_t seed = 0xcbf29ce484222325ULL) {
    std::uint64_t hash = seed;
    for (const std::byte b : bytes) {
        hash ^= static_cast<std::uint64_t>(b);
        hash *= 0x100000001b3ULL;
    }
    return hash;
}

}  // namespace core
