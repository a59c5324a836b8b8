#include "core/contour/contour_match.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <tuple>

#include "core/match/lanes.hpp"

namespace core {

namespace {

constexpr int kLeftOut = 118;  // a fifth of kGreatestHeight in every channel
constexpr std::size_t kStray = 7;
constexpr double kPlainness = 0.5;  // keeps the complexity of two discs from dividing by next to nothing
constexpr double kAlignmentWeight = 5.34;
constexpr double kCoverWeight = 2.67;

// Sixteen short integers worked on at once; whole numbers are equal on every machine.
using Shorts = std::int16_t __attribute__((vector_size(32)));
/// They in an array of short integers, wherever it lies.
struct __attribute__((packed, may_alias)) LooseShorts {
    Shorts v;
};
using Bytes = std::uint8_t __attribute__((vector_size(16)));
constexpr std::size_t kWide = 16;
constexpr std::size_t kBlocks = kFramePoints / kWide;
constexpr std::int16_t kNever = 30'000;  // above every cost of an alignment, and no overflow when a step is added

static_assert(kFramePoints % kWide == 0 && kFrameChannels == kWide);
static_assert((2 * kFramePoints + kStray) * kLeftOut < kNever);
static_assert(kNever + 2 * kFrameStretches * (kGreatestHeight + kGreatestAhead) <= INT16_MAX);
static_assert(2 * kFramePoints + 2 * kStray < ContourMatcher::kRow);

using Points = std::array<std::array<std::int16_t, kFrameChannels>, kFramePoints>;
using Channels = std::array<std::array<std::int16_t, kFramePoints>, kFrameChannels>;
using Differences = std::array<std::array<std::int16_t, ContourMatcher::kRow>, kFramePoints>;

/// Differences of all frames of A and B. Gives a sum that no alignment of them costs less than: every point of B has
/// its nearest of A, or is left out, and so is one of A.
CROQUIS_LANES_CLONES int fill_differences(const Points& low_a, const Points& high_a, const Channels& low_b,
                                          const Channels& high_b, Differences& out) {
    Shorts nearest[kBlocks];
    for (Shorts& n : nearest) n = Shorts{} + static_cast<std::int16_t>(2 * kLeftOut);
    for (std::size_t i = 0; i < kFramePoints; ++i) {
        Shorts sum[kBlocks] = {};
        for (std::size_t k = 0; k < kFrameChannels; ++k) {
            const Shorts low = Shorts{} + low_a[i][k], high = Shorts{} + high_a[i][k];
            for (std::size_t g = 0; g < kBlocks; ++g) {
                const Shorts above = reinterpret_cast<const LooseShorts*>(&low_b[k][g * kWide])->v - high;
                const Shorts below = low - reinterpret_cast<const LooseShorts*>(&high_b[k][g * kWide])->v;
                const Shorts gap = above > below ? above : below;
                sum[g] += gap > 0 ? gap : Shorts{};
            }
        }
        for (std::size_t g = 0; g < kBlocks; ++g) {
            nearest[g] = sum[g] < nearest[g] ? sum[g] : nearest[g];
            reinterpret_cast<LooseShorts*>(&out[i][g * kWide])->v = sum[g];
            reinterpret_cast<LooseShorts*>(&out[i][(kBlocks + g) * kWide])->v = sum[g];
        }
        reinterpret_cast<LooseShorts*>(&out[i][2 * kBlocks * kWide])->v = sum[0];
    }
    int bound = 0;
    for (const Shorts& n : nearest) {
        for (std::size_t s = 0; s < kWide; ++s) bound += n[s];
    }
    return bound;
}

/// The least cost of an alignment. cost[d] is that of the best one of the points of A so far with the same number of
/// points of B, plus d - kStray, in one lane for every turn.
CROQUIS_LANES_CLONES int least_alignment(const Differences& differences) {
    constexpr std::size_t kBand = 2 * kStray + 1;
    const Shorts never = Shorts{} + kNever, left_out = Shorts{} + static_cast<std::int16_t>(kLeftOut);
    Shorts least = never;
    for (std::size_t g = 0; g < kBlocks; ++g) {
        Shorts cost[kBand];
        for (std::size_t d = 0; d < kBand; ++d) {
            cost[d] =
                d < kStray
                    ? never
                    : Shorts{} + static_cast<std::int16_t>((static_cast<int>(d) - static_cast<int>(kStray)) * kLeftOut);
        }
        for (std::size_t i = 0; i < kFramePoints; ++i) {
            const std::int16_t* row = &differences[i][i + g * kWide];
            Shorts before = never;
#pragma GCC unroll 20
            for (std::size_t d = 0; d < kBand; ++d) {
                const Shorts paired = cost[d] + reinterpret_cast<const LooseShorts*>(row + d)->v;
                const Shorts above = d + 1 < kBand ? cost[d + 1] : never;
                const Shorts left = (before < above ? before : above) + left_out;
                before = paired < left ? paired : left;
                cost[d] = before;
            }
        }
        least = cost[kStray] < least ? cost[kStray] : least;
    }
    int result = kNever;
    for (std::size_t s = 0; s < kWide; ++s) result = std::min<int>(result, least[s]);
    return result;
}

CROQUIS_LANES_CLONES int least_cover_difference(const ContourDescriptor& a, const ContourDescriptor& b) {
    constexpr std::size_t kHalves = kPolarSectors / kWide;
    static_assert(kPolarSectors % kWide == 0);
    alignas(32) std::int16_t own[kPolarRings][kPolarSectors];
    alignas(32) std::int16_t other[2][kPolarRings][2 * kPolarSectors];
    for (std::size_t r = 0; r < kPolarRings; ++r) {
        for (std::size_t h = 0; h < kHalves; ++h) {
            Bytes from_a, from_b;
            std::memcpy(&from_a, &a.cover[r][h * kWide], kWide);
            std::memcpy(&from_b, &b.cover[r][h * kWide], kWide);
            const Shorts wide = __builtin_convertvector(from_b, Shorts);
            const Shorts turned =
                __builtin_shufflevector(wide, wide, 15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
            reinterpret_cast<LooseShorts*>(&own[r][h * kWide])->v = __builtin_convertvector(from_a, Shorts);
            for (std::size_t twice = 0; twice < 2; ++twice) {
                reinterpret_cast<LooseShorts*>(&other[0][r][(twice * kHalves + h) * kWide])->v = wide;
                reinterpret_cast<LooseShorts*>(&other[1][r][(twice * kHalves + kHalves - 1 - h) * kWide])->v = turned;
            }
        }
    }
    int least = std::numeric_limits<int>::max();
    for (std::size_t turn = 0; turn < 2 * kPolarSectors; ++turn) {
        Shorts sum{};
        for (std::size_t r = 0; r < kPolarRings; ++r) {
            const std::int16_t* row = &other[turn / kPolarSectors][r][turn % kPolarSectors];
            for (std::size_t h = 0; h < kHalves; ++h) {
                const Shorts d = reinterpret_cast<const LooseShorts*>(&own[r][h * kWide])->v -
                                 reinterpret_cast<const LooseShorts*>(row + h * kWide)->v;
                sum += d < 0 ? -d : d;
            }
        }
        int whole = 0;
        for (std::size_t s = 0; s < kWide; ++s) whole += sum[s];
        least = std::min(least, whole);
    }
    return least;
}

/// The frames of the mirror image; ahead is behind, so that the lowest becomes the highest.
void mirror_points(const Points& low, const Points& high, Points& mirrored_low, Points& mirrored_high) {
    for (std::size_t i = 0; i < kFramePoints; ++i) {
        const std::size_t from = kFramePoints - 1 - i;
        for (std::size_t m = 0; m < kFrameStretches; ++m) {
            const std::size_t height = kFrameStretches - 1 - m, ahead = kFrameChannels - 1 - m;
            mirrored_low[i][m] = low[from][height];
            mirrored_high[i][m] = high[from][height];
            mirrored_low[i][kFrameStretches + m] = static_cast<std::int16_t>(-high[from][ahead]);
            mirrored_high[i][kFrameStretches + m] = static_cast<std::int16_t>(-low[from][ahead]);
        }
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
                const int least = contour.low_at[i][first + m], most = contour.high_at[i][first + m];
                const bool plus = walsh_sign(k, m) > 0;
                low += plus ? least : -most;
                high += plus ? most : -least;
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
            out.low[k][i] = out.low_at[i][k] = static_cast<std::int16_t>(std::min({own, before, after}));
            out.high[k][i] = out.high_at[i][k] = static_cast<std::int16_t>(std::max({own, before, after}));
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

double ContourMatcher::distance(const MatchableContour& a, const MatchableContour& b, double give_up_at) {
    if (!in_order(a, b)) return distance(b, a, give_up_at);
    double least = lower_bound(a, b);
    if (least >= give_up_at) return least;
    const int cover = least_cover_difference(a.descriptor, b.descriptor);
    least = combined(a, b, 0, cover);
    if (least >= give_up_at) return least;
    const int bound = fill_differences(a.low_at, a.high_at, b.low, b.high, differences_);
    double straight = combined(a, b, bound, cover);
    if (straight < give_up_at) straight = combined(a, b, least_alignment(differences_), cover);
    mirror_points(a.low_at, a.high_at, mirrored_low_, mirrored_high_);
    const double limit = std::min(give_up_at, straight);
    double turned = combined(a, b, fill_differences(mirrored_low_, mirrored_high_, b.low, b.high, differences_), cover);
    if (turned < limit) turned = combined(a, b, least_alignment(differences_), cover);
    return std::min(straight, turned);
}

}  // namespace core
