#pragma once
// Four floats worked on at once. Every lane is an IEEE operation in the order written, so results equal those of plain
// floats, on every machine: the compiler splits lanes up where there are no vector registers.

#include <cstddef>

namespace core {

using Lanes = float __attribute__((vector_size(16)));
inline constexpr std::size_t kLanes = 4;

/// Twice as many, where nothing is handed over by value: that would be done in another way where there is AVX2.
using WideLanes = float __attribute__((vector_size(32)));
inline constexpr std::size_t kWideLanes = 8;

/// Lanes in a container.
struct LaneGroup {
    Lanes v{};
};

/// How many groups hold n values.
[[nodiscard]] constexpr std::size_t lane_groups(std::size_t n) {
    return (n + kLanes - 1) / kLanes;
}

[[nodiscard]] inline Lanes all_lanes(float value) {
    return Lanes{value, value, value, value};
}

[[nodiscard]] inline Lanes least_of(Lanes a, Lanes b) {
    return a < b ? a : b;
}

/// Compiles a function a second time for processors with AVX2, which need fewer instructions for the same operations;
/// the one that fits is chosen when the program starts. No operation is fused or put into another order, so both give
/// the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define CROQUIS_LANES_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define CROQUIS_LANES_CLONES
#endif

}  // namespace core
