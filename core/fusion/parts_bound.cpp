#include "core/fusion/parts_bound.hpp"

#include <algorithm>
#include <cmath>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace core {

namespace {

constexpr std::size_t kPlaces = 64;  // of outline_difference
constexpr std::size_t kStep = 2 * kOutlineGrid / kPlaces;
constexpr float kRounding = 1.0001F;  // far above what sums of floats are rounded by

/// A profile of one height everywhere.
OutlineProfile flat(std::uint8_t height, float complexity) {
    OutlineProfile profile;
    for (auto& point : profile.heights) point.fill(height);
    profile.complexity = complexity;
    return profile;
}

}  // namespace

PartsBound::PartsBound(const MatchableShape& shape) : level_(flat(0, shape.forwards.outline.complexity)) {
    const PairedHeights backwards = paired_heights(shape.backwards.outline);
    for (std::size_t t = 0; t < 2 * kOutlineGrid; ++t) {
        const std::size_t point = (2 * kOutlineGrid - t) % kOutlineGrid;
        forwards_[t] = shape.paired[point];
        backwards_[t] = backwards[point];
    }
}

#if defined(__SSE2__)

namespace {

using Turning = std::array<PairedHeights::value_type, 2 * kOutlineGrid>;
using Least = std::array<int, kOutlineGrid>;

constexpr std::size_t kAtOnce = 4;  // sums i + j worked on at once

__attribute__((target("avx2"))) __m256i load_avx2(const std::uint8_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
}

/// least(r) … least(r + 3), four pairs of points at a time. A difference is below 2^12, so that 16 of
/// the 64 bits that it comes in can be compared.
__attribute__((target("avx2"))) void fill_least_avx2(const PairedHeights& b, const Turning& a, std::size_t r,
                                                     Least& least) {
    __m256i found[kAtOnce];
#pragma GCC unroll 4
    for (__m256i& f : found) f = _mm256_set1_epi64x(INT16_MAX);
    for (std::size_t j = 0; j < kOutlineGrid; j += 4) {
        const __m256i here = load_avx2(b[j].data());
#pragma GCC unroll 4
        for (std::size_t k = 0; k < kAtOnce; ++k) {
            const std::size_t t = j + kOutlineGrid - r - k;
            found[k] = _mm256_min_epi16(found[k], _mm256_sad_epu8(here, load_avx2(a[t].data())));
        }
    }
#pragma GCC unroll 4
    for (std::size_t k = 0; k < kAtOnce; ++k) {
        alignas(32) std::array<std::int64_t, 4> lanes{};
        _mm256_store_si256(reinterpret_cast<__m256i*>(lanes.data()), found[k]);
        least[r + k] = static_cast<int>(*std::min_element(lanes.begin(), lanes.end()));
    }
}

__m128i load_sse2(const std::uint8_t* from) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

/// The same two pairs at a time.
void fill_least_sse2(const PairedHeights& b, const Turning& a, std::size_t r, Least& least) {
    __m128i found[kAtOnce];
#pragma GCC unroll 4
    for (__m128i& f : found) f = _mm_set1_epi64x(INT16_MAX);
    for (std::size_t j = 0; j < kOutlineGrid; j += 2) {
        const __m128i here = load_sse2(b[j].data());
#pragma GCC unroll 4
        for (std::size_t k = 0; k < kAtOnce; ++k) {
            const std::size_t t = j + kOutlineGrid - r - k;
            found[k] = _mm_min_epi16(found[k], _mm_sad_epu8(here, load_sse2(a[t].data())));
        }
    }
#pragma GCC unroll 4
    for (std::size_t k = 0; k < kAtOnce; ++k) {
        alignas(16) std::array<std::int64_t, 2> lanes{};
        _mm_store_si128(reinterpret_cast<__m128i*>(lanes.data()), found[k]);
        least[r + k] = static_cast<int>(std::min(lanes[0], lanes[1]));
    }
}

/// sum(s) of the header.
int sum_of(const Least& least, std::size_t s) {
    int sum = 0;
    for (std::size_t k = 0; k < kOutlineGrid / kStep; ++k) {
        const std::size_t r = s + kStep * k + kOutlineGrid;
        sum += std::min({least[(r - 1) % kOutlineGrid], least[r % kOutlineGrid], least[(r + 1) % kOutlineGrid]});
    }
    return 2 * sum;
}

/// The least of sum(0) … sum(7).
int least_sum(const PairedHeights& b, const Turning& a) {
    static const auto fill_least = __builtin_cpu_supports("avx2") != 0 ? fill_least_avx2 : fill_least_sse2;
    Least least;
    for (std::size_t r = 0; r < kOutlineGrid; r += kAtOnce) fill_least(b, a, r, least);
    int sum = sum_of(least, 0);
    for (std::size_t s = 1; s < kStep; ++s) sum = std::min(sum, sum_of(least, s));
    return sum;
}

}  // namespace

LeastOutlines PartsBound::least_outlines(const MatchableShape& other) const {
    const OutlineProfile& profile = other.forwards.outline;
    // What differences of one in every bin at every place come to, these two shapes being as complex as they are.
    const OutlineAnchor start;
    const float ones = outline_difference(level_, flat(1, profile.complexity), {&start, 1});
    const float unit = ones / static_cast<float>(kPlaces * kHeightBins) / kRounding;
    // A configuration without matched parts has no alignment.
    return {std::min(kUnaligned, unit * static_cast<float>(least_sum(other.paired, forwards_))),
            std::min(kUnaligned, unit * static_cast<float>(least_sum(other.paired, backwards_)))};
}

#else

LeastOutlines PartsBound::least_outlines(const MatchableShape& /*other*/) const {
    return {};
}

#endif

}  // namespace core
