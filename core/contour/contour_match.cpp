#include "core/contour/contour_match.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <tuple>

#include "core/match/lanes.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace core {

namespace {

constexpr int kLeftOut = 85;  // about a seventh of kGreatestHeight in every channel
constexpr std::size_t kStray = 7;
constexpr double kPlainness = 0.5;  // keeps the complexity of two discs from dividing by next to nothing
constexpr double kAlignmentWeight = 5.34;
constexpr double kCoverWeight = 2.67;

// Whole numbers worked on at once; they are equal on every machine.
using Shorts = std::int16_t __attribute__((vector_size(32)));
using Bytes = std::uint8_t __attribute__((vector_size(32)));
using Half = std::uint8_t __attribute__((vector_size(16)));
constexpr std::size_t kShorts = 16, kBytes = 32;
constexpr std::size_t kBlocks = kFramePoints / kShorts;              // of turns, in the dynamic program
constexpr std::size_t kRowBlocks = MatchableContour::kRow / kBytes;  // of points
constexpr std::size_t kBand = 2 * kStray + 1;
constexpr std::int16_t kNever = 30'000;  // above every cost of an alignment, and no overflow when a step is added
/// A pair that costs more is better left out on both sides.
constexpr int kMostOfPair = 2 * kLeftOut;

static_assert(kFramePoints % kShorts == 0 && kFrameChannels == kShorts && MatchableContour::kRow % kBytes == 0);
static_assert((2 * kFramePoints + kStray) * kLeftOut < kNever && kNever + kMostOfPair <= INT16_MAX);
static_assert(kMostOfPair <= UINT8_MAX && kGreatestHeight < MatchableContour::kZero &&
              kGreatestAhead < MatchableContour::kZero);
static_assert(2 * kFramePoints + kBytes <= ContourMatcher::kRow);

using Points = MatchableContour::Points;
using Channels = MatchableContour::Channels;
using TurnBounds = ContourMatcher::TurnBounds;
using Spared = ContourMatcher::Spared;

/// They in an array, wherever it lies.
template <class V>
void load(V& v, const void* from) {
    std::memcpy(&v, from, sizeof v);
}
template <class V>
void store(void* to, const V& v) {
    std::memcpy(to, &v, sizeof v);
}
// By reference: a vector that is handed over by value would be so in another way where there is AVX2.
template <class V>
void keep_least(V& a, const V& b) {
    a = a < b ? a : b;
}
template <class V>
void keep_most(V& a, const V& b) {
    a = a > b ? a : b;
}
int least_of(const Shorts& v) {
    std::int16_t least = v[0];
    for (std::size_t s = 1; s < kShorts; ++s) least = std::min(least, v[s]);
    return least;
}
/// Leaves 0 where it would come below it.
template <class V>
void take_off(V& a, const V& b) {
    keep_most(a, b);
    a -= b;
}

constexpr std::size_t kRounds = ContourMatcher::kRounds, kRound = kFramePoints / kRounds;

/// Writes what pairing one frame of A with each of B spares. A row holds B's points twice and a little, so that every
/// turn is a run in it.
__attribute__((always_inline)) inline void store_row(const Bytes (&spared)[kRowBlocks], std::uint8_t* row) {
#pragma GCC unroll 3
    for (std::size_t g = 0; g < kRowBlocks; ++g) {
        store(row + g * kBytes, spared[g]);
        store(row + kFramePoints + g * kBytes, spared[g]);
    }
    store(row + 2 * kFramePoints, spared[0]);
}

/// Of a round of frames of A and all of B: kMostOfPair less their difference, or nought.
void fill_spared_plain(const Points& low_a, const Points& high_a, const Channels& low_b, const Channels& high_b,
                       std::size_t round, Spared& out) {
    for (std::size_t i = round * kRound; i < (round + 1) * kRound; ++i) {
        Bytes left[kRowBlocks];  // of kMostOfPair
        for (Bytes& l : left) l = Bytes{} + static_cast<std::uint8_t>(kMostOfPair);
        for (std::size_t k = 0; k < kFrameChannels; ++k) {
            const Bytes low = Bytes{} + low_a[i][k], high = Bytes{} + high_a[i][k];
            for (std::size_t g = 0; g < kRowBlocks; ++g) {
                Bytes upper, lower;
                load(upper, &low_b[k][g * kBytes]);
                load(lower, &high_b[k][g * kBytes]);
                keep_most(upper, low);
                keep_least(lower, high);
                take_off(upper, lower);
                take_off(left[g], upper);
            }
        }
        store_row(left, out[i].data());
    }
}

#if defined(__x86_64__)
/// The same in half the instructions, by subtractions that stop at nought.
__attribute__((target("avx2"))) void fill_spared_avx2(const Points& low_a, const Points& high_a, const Channels& low_b,
                                                      const Channels& high_b, std::size_t round, Spared& out) {
    const auto at = [](const std::uint8_t* from) { return reinterpret_cast<const __m256i*>(from); };
    for (std::size_t i = round * kRound; i < (round + 1) * kRound; ++i) {
        __m256i left[kRowBlocks];
        for (__m256i& l : left) l = _mm256_set1_epi8(static_cast<char>(kMostOfPair));
        for (std::size_t k = 0; k < kFrameChannels; ++k) {
            const __m256i low = _mm256_set1_epi8(static_cast<char>(low_a[i][k]));
            const __m256i high = _mm256_set1_epi8(static_cast<char>(high_a[i][k]));
#pragma GCC unroll 3
            for (std::size_t g = 0; g < kRowBlocks; ++g) {
                const __m256i upper = _mm256_max_epu8(low, _mm256_loadu_si256(at(&low_b[k][g * kBytes])));
                const __m256i lower = _mm256_min_epu8(high, _mm256_loadu_si256(at(&high_b[k][g * kBytes])));
                left[g] = _mm256_subs_epu8(left[g], _mm256_subs_epu8(upper, lower));
            }
        }
        Bytes bytes[kRowBlocks];
        std::memcpy(bytes, left, sizeof left);
        store_row(bytes, out[i].data());
    }
}
#endif

void fill_spared(const Points& low_a, const Points& high_a, const Channels& low_b, const Channels& high_b,
                 std::size_t round, Spared& out) {
#if defined(__x86_64__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (has_avx2) return fill_spared_avx2(low_a, high_a, low_b, high_b, round, out);
#endif
    fill_spared_plain(low_a, high_a, low_b, high_b, round, out);
}

/// What alignments by each turn cost at least up to the end of a round of points, from what they did up to its start:
/// every point of A has a partner within the band, or is left out, and so is one of B.
CROQUIS_LANES_CLONES int fill_turn_bounds(const Spared& spared, std::size_t round, const TurnBounds& before,
                                          TurnBounds& bounds) {
    Shorts sums[2 * kRowBlocks];
    std::memcpy(sums, before.data(), sizeof sums);
    for (Shorts& sum : sums) sum += static_cast<std::int16_t>(kRound * kMostOfPair);
    for (std::size_t i = round * kRound; i < (round + 1) * kRound; ++i) {
#pragma GCC unroll 3
        for (std::size_t g = 0; g < kRowBlocks; ++g) {
            const std::uint8_t* run = &spared[i][i + g * kBytes];
            Bytes nearest, next;
            load(nearest, run);
#pragma GCC unroll 20
            for (std::size_t d = 1; d < kBand; ++d) {
                load(next, run + d);
                keep_most(nearest, next);
            }
            Half halves[2];
            std::memcpy(halves, &nearest, sizeof nearest);
            for (std::size_t h = 0; h < 2; ++h) sums[2 * g + h] -= __builtin_convertvector(halves[h], Shorts);
        }
    }
    std::memcpy(bounds.data(), sums, sizeof sums);
    Shorts least = sums[0];
    for (std::size_t g = 1; g < kBlocks; ++g) keep_least(least, sums[g]);
    return least_of(least);
}

/// The least cost of an alignment by the turns of one block, or something not below `limit`. `until` is what the points
/// before each round cost at least.
///
/// cost[d] is that of the best alignment of the points of A so far with the same number of points of B and `further` =
/// d - kStray more, less kLeftOut for each of these and kMostOfPair for each point of A: so leaving out one more of
/// either costs nothing here, a pair costs less what it spares, and the least of all is the last. One lane for every
/// turn.
CROQUIS_LANES_CLONES int least_alignment(const Spared& spared, std::size_t block,
                                         const std::array<TurnBounds, kRounds + 1>& until, int limit) {
    const Shorts never = Shorts{} + kNever;
    Shorts cost[kBand];
    for (std::size_t d = 0; d < kBand; ++d) cost[d] = d < kStray ? never : Shorts{};
    int result = 0;
    for (std::size_t round = 0; round < kRounds && result < limit; ++round) {
        for (std::size_t i = round * kRound; i < (round + 1) * kRound; ++i) {
            const std::uint8_t* row = &spared[i][i + block * kShorts];
            Shorts before = never;
#pragma GCC unroll 20
            for (std::size_t d = 0; d < kBand; ++d) {
                Half pair;
                std::memcpy(&pair, row + d, sizeof pair);
                Shorts best = cost[d] - __builtin_convertvector(pair, Shorts);
                if (d + 1 < kBand) keep_least(best, cost[d + 1]);
                keep_least(before, best);
                cost[d] = before;
            }
        }
        // Where B is ahead, as many points of A can still be left out without one of B; where A is, B's must be.
        Shorts until_end, until_here;
        load(until_end, &until[kRounds][block * kShorts]);
        load(until_here, &until[round + 1][block * kShorts]);
        const Shorts least = cost[kBand - 1] + (until_end - until_here);
        result = least_of(least) + static_cast<int>((round + 1) * kRound) * kMostOfPair;
    }
    return result < limit ? least_of(cost[kStray]) + static_cast<int>(kFramePoints) * kMostOfPair : result;
}

/// The cover of B twice over, so that every turn is a run in it, and that of its mirror image.
struct TurningCover {
    std::array<std::array<std::uint8_t, 2 * kPolarSectors>, kPolarRings> straight, mirrored;
};

CROQUIS_LANES_CLONES void fill_turning(const ContourDescriptor& b, TurningCover& out) {
    static_assert(kPolarSectors == sizeof(Bytes));
    Bytes sectors;
    for (std::size_t r = 0; r < kPolarRings; ++r) {
        load(sectors, b.cover[r].data());
        const Bytes turned =
            __builtin_shufflevector(sectors, sectors, 31, 30, 29, 28, 27, 26, 25, 24, 23, 22, 21, 20, 19, 18, 17, 16,
                                    15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
        for (std::size_t twice = 0; twice < 2; ++twice) {
            store(&out.straight[r][twice * kPolarSectors], sectors);
            store(&out.mirrored[r][twice * kPolarSectors], turned);
        }
    }
}

CROQUIS_LANES_CLONES int least_cover_difference_plain(const ContourDescriptor& a, const TurningCover& b) {
    int least = std::numeric_limits<int>::max();
    for (const auto* cover : {&b.straight, &b.mirrored}) {
        for (std::size_t turn = 0; turn < kPolarSectors; ++turn) {
            Shorts sum{};
            for (std::size_t r = 0; r < kPolarRings; ++r) {
                for (std::size_t s = 0; s < kPolarSectors; s += kShorts) {
                    Half here, there;
                    load(here, &a.cover[r][s]);
                    load(there, &(*cover)[r][turn + s]);
                    const Half d = (here > there ? here : there) - (here < there ? here : there);
                    sum += __builtin_convertvector(d, Shorts);
                }
            }
            int whole = 0;
            for (std::size_t s = 0; s < kShorts; ++s) whole += sum[s];
            least = std::min(least, whole);
        }
    }
    return least;
}

#if defined(__x86_64__)
/// The same by sums of absolute differences.
__attribute__((target("avx2"))) int least_cover_difference_avx2(const ContourDescriptor& a, const TurningCover& b) {
    static_assert(kPolarSectors == sizeof(__m256i));
    const auto at = [](const std::uint8_t* from) { return reinterpret_cast<const __m256i*>(from); };
    int least = std::numeric_limits<int>::max();
    for (const auto* cover : {&b.straight, &b.mirrored}) {
        for (std::size_t turn = 0; turn < kPolarSectors; ++turn) {
            __m256i sum = _mm256_setzero_si256();
            for (std::size_t r = 0; r < kPolarRings; ++r) {
                const __m256i here = _mm256_loadu_si256(at(a.cover[r].data()));
                const __m256i there = _mm256_loadu_si256(at(&(*cover)[r][turn]));
                sum = _mm256_add_epi64(sum, _mm256_sad_epu8(here, there));
            }
            const __m128i half = _mm_add_epi64(_mm256_castsi256_si128(sum), _mm256_extracti128_si256(sum, 1));
            least = std::min(least, _mm_cvtsi128_si32(_mm_add_epi64(half, _mm_unpackhi_epi64(half, half))));
        }
    }
    return least;
}
#endif

/// Over all turns and both directions.
int least_cover_difference(const ContourDescriptor& a, const ContourDescriptor& b) {
    TurningCover turning;
    fill_turning(b, turning);
#if defined(__x86_64__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
    if (has_avx2) return least_cover_difference_avx2(a, turning);
#endif
    return least_cover_difference_plain(a, turning);
}

/// The frames of the mirror image: stretches from the other end, and ahead is behind, so that the lowest becomes the
/// highest.
CROQUIS_LANES_CLONES void mirror_points(const Points& low, const Points& high, Points& mirrored_low,
                                        Points& mirrored_high) {
    static_assert(sizeof(Half) == kFrameChannels && kFrameStretches == kFrameChannels / 2);
    constexpr std::uint8_t kTwice = 2 * MatchableContour::kZero;
    Half of_low, of_high;
    for (std::size_t i = 0; i < kFramePoints; ++i) {
        load(of_low, low[kFramePoints - 1 - i].data());
        load(of_high, high[kFramePoints - 1 - i].data());
        const Half behind_low = kTwice - of_high, behind_high = kTwice - of_low;
        const Half out_low =
            __builtin_shufflevector(of_low, behind_low, 7, 6, 5, 4, 3, 2, 1, 0, 31, 30, 29, 28, 27, 26, 25, 24);
        const Half out_high =
            __builtin_shufflevector(of_high, behind_high, 7, 6, 5, 4, 3, 2, 1, 0, 31, 30, 29, 28, 27, 26, 25, 24);
        store(mirrored_low[i].data(), out_low);
        store(mirrored_high[i].data(), out_high);
    }
}

/// One formula for distances and bounds; it never falls when a sum grows.
double combined(const MatchableContour& a, const MatchableContour& b, int alignment, int cover) {
    const double complexity =
        static_cast<double>(a.descriptor.complexity) + static_cast<double>(b.descriptor.complexity);
    constexpr double kUnit = 1.0 / (static_cast<double>(kFramePoints * kFrameChannels) * kGreatestHeight);
    constexpr double kCoverUnit = 1.0 / (255.0 * kPolarRings * kPolarSectors);
    return kAlignmentWeight * kUnit * alignment / (kPlainness + complexity) + kCoverWeight * kCoverUnit * cover;
}

/// The least alignment with which the distance is not below `give_up_at`; kNever if there is none.
int useless_from(const MatchableContour& a, const MatchableContour& b, int cover, double give_up_at) {
    int useless = 0;
    for (int step = 1 << 14; step > 0; step /= 2) {
        if (useless + step <= kNever && combined(a, b, useless + step - 1, cover) < give_up_at) useless += step;
    }
    return useless;
}

/// Sums of the heights of a frame, and of its distances ahead, with signs by which each tells something else about it
/// (Walsh functions): sign of stretch m in sum k.
int walsh_sign(std::size_t k, std::size_t m) {
    return std::popcount(k % kFrameStretches & m) % 2 == 0 ? 1 : -1;
}

/// Reading the stretches from the other end keeps sums of an even number of factors; ahead becomes behind.
bool mirror_keeps(std::size_t k) {
    const bool even = std::popcount(k % kFrameStretches) % 2 == 0;
    return even == (k < kFrameStretches);
}

/// For lower_bound: no sum of one frame differs from that of another by more than the frames do, and cut off at
/// kLeftOut it is no more than leaving the point out costs. So no alignment costs less than what the sums over all
/// points differ by.
void fill_sums(MatchableContour& contour) {
    for (std::size_t k = 0; k < kFrameChannels; ++k) {
        const std::size_t first = k < kFrameStretches ? 0 : kFrameStretches;
        for (std::size_t i = 0; i < kFramePoints; ++i) {
            int low = 0, high = 0;
            for (std::size_t m = 0; m < kFrameStretches; ++m) {
                const int lowest = contour.low_at[i][first + m] - MatchableContour::kZero;
                const int highest = contour.high_at[i][first + m] - MatchableContour::kZero;
                const bool plus = walsh_sign(k, m) > 0;
                low += plus ? lowest : -highest;
                high += plus ? highest : -lowest;
            }
            contour.low_sums[k] += std::clamp(low, -kLeftOut, kLeftOut);
            contour.high_sums[k] += std::clamp(high, -kLeftOut, kLeftOut);
        }
    }
}

/// A fixed order of the two shapes, the same for mirrored ones.
bool in_order(const MatchableContour& a, const MatchableContour& b) {
    const auto key = [](const MatchableContour& c) { return std::tie(c.descriptor.complexity, c.ring_sums); };
    if (key(a) != key(b)) return key(a) < key(b);
    const auto less = [](const ContourDescriptor& x, const ContourDescriptor& y) { return x.frames < y.frames; };
    return !less(std::min(b.descriptor, mirrored(b.descriptor), less),
                 std::min(a.descriptor, mirrored(a.descriptor), less));
}

/// Rounded alike on both sides of 0, so that mirroring changes signs alone.
int quarter(int step) {
    return step < 0 ? -((2 - step) / 4) : (2 + step) / 4;
}

}  // namespace

MatchableContour matchable(const ContourDescriptor& descriptor) {
    MatchableContour out;
    out.descriptor = descriptor;
    for (std::size_t k = 0; k < kFrameChannels; ++k) {
        const auto& channel = descriptor.frames[k];
        for (std::size_t i = 0; i < kFramePoints; ++i) {
            const int own = channel[i];
            const int before = own + quarter(channel[(i + kFramePoints - 1) % kFramePoints] - own);
            const int after = own + quarter(channel[(i + 1) % kFramePoints] - own);
            constexpr int kZero = MatchableContour::kZero;
            out.low[k][i] = out.low_at[i][k] = static_cast<std::uint8_t>(kZero + std::min({own, before, after}));
            out.high[k][i] = out.high_at[i][k] = static_cast<std::uint8_t>(kZero + std::max({own, before, after}));
        }
        for (std::size_t i = kFramePoints; i < MatchableContour::kRow; ++i) {
            out.low[k][i] = out.low[k][i - kFramePoints];
            out.high[k][i] = out.high[k][i - kFramePoints];
        }
    }
    fill_sums(out);
    for (std::size_t r = 0; r < kPolarRings; ++r) {
        for (const std::uint8_t cell : descriptor.cover[r]) out.ring_sums[r] += cell;
    }
    return out;
}

double lower_bound(const MatchableContour& a, const MatchableContour& b) {
    int cover = 0;
    for (std::size_t r = 0; r < kPolarRings; ++r) cover += std::abs(a.ring_sums[r] - b.ring_sums[r]);
    int straight = 0, turned = 0;
    for (std::size_t k = 0; k < kFrameChannels; ++k) {
        straight = std::max({straight, a.low_sums[k] - b.high_sums[k], b.low_sums[k] - a.high_sums[k]});
        // Of the mirror image the sum is the same, or it has the other sign.
        const bool same = mirror_keeps(k);
        const int low = same ? b.low_sums[k] : -b.high_sums[k], high = same ? b.high_sums[k] : -b.low_sums[k];
        turned = std::max({turned, a.low_sums[k] - high, low - a.high_sums[k]});
    }
    return combined(a, b, std::min(straight, turned), cover);
}

/// Fills spared_, until_ and blocks_ for A in one direction, or stops where no turn can stay below `limit`.
void ContourMatcher::bound_turns(std::size_t direction, const MatchableContour::Points& low,
                                 const MatchableContour::Points& high, const MatchableContour& b, int limit) {
    auto& until = until_[direction];
    for (std::size_t round = 0; round < kRounds; ++round) {
        fill_spared(low, high, b.low, b.high, round, spared_[direction]);
        if (fill_turn_bounds(spared_[direction], round, until[round], until[round + 1]) >= limit) return;
    }
    for (std::size_t k = 0; k < kBlocks; ++k) {
        const std::int16_t* first = &until[kRounds][k * kShorts];
        blocks_[block_count_++] = {*std::min_element(first, first + kShorts), direction, k};
    }
}

double ContourMatcher::distance(const MatchableContour& a, const MatchableContour& b, double give_up_at) {
    if (!in_order(a, b)) return distance(b, a, give_up_at);
    double least = lower_bound(a, b);
    if (least >= give_up_at) return least;
    const int cover = least_cover_difference(a.descriptor, b.descriptor);
    least = combined(a, b, 0, cover);
    if (least >= give_up_at) return least;
    const int limit = useless_from(a, b, cover, give_up_at);
    mirror_points(a.low_at, a.high_at, mirrored_low_, mirrored_high_);
    block_count_ = 0;
    bound_turns(0, a.low_at, a.high_at, b, limit);
    bound_turns(1, mirrored_low_, mirrored_high_, b, limit);
    std::sort(blocks_.begin(), blocks_.begin() + static_cast<std::ptrdiff_t>(block_count_),
              [](const Block& x, const Block& y) { return x.bound < y.bound; });
    int alignment = limit;
    if (block_count_ > 0) ++aligned_pairs_;
    for (std::size_t k = 0; k < block_count_ && blocks_[k].bound < alignment; ++k) {
        const auto [of_block, direction, block] = blocks_[k];
        alignment = std::min(alignment, least_alignment(spared_[direction], block, until_[direction], alignment));
    }
    return combined(a, b, alignment, cover);
}

}  // namespace core
