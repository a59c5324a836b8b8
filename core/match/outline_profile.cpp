#include "core/match/outline_profile.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/polygon.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace core {

namespace {

constexpr std::size_t kBinWidth = kOutlineGrid / kHeightBins;
constexpr std::size_t kTangentReach = 3;    // grid points to either side that the tangent is taken over
constexpr std::uint32_t kComparisons = 64;  // places compared
constexpr float kComplexityFloor = 0.3F;    // keeps smooth outlines comparable: those of discs are near 0
constexpr std::uint32_t kTurn = 1U << 16U;  // once round, in places
constexpr int kLevel = 128;                 // a height of nought
constexpr double kHighest = 127.0;

using Heights = std::array<std::uint8_t, kHeightBins>;

double bin_weight(std::size_t bin) {
    return 1.0 / std::sqrt(static_cast<double>(std::min(bin + 1, kHeightBins - bin)));
}

/// Mean height of each stretch over the tangent at each point, in the ring's unit.
std::vector<std::array<double, kHeightBins>> raw_heights(const Polygon& grid) {
    // Mean of the points of the stretch that starts here, its ends left out: so a mirror image has the same stretches.
    std::vector<Point> stretch(kOutlineGrid);
    for (std::size_t i = 0; i < kOutlineGrid; ++i) {
        Point sum;
        for (std::size_t k = 1; k < kBinWidth; ++k) sum = sum + (grid[(i + k) % kOutlineGrid] - grid[0]);
        stretch[i] = sum * (1.0 / static_cast<double>(kBinWidth - 1));
    }
    std::vector<std::array<double, kHeightBins>> raw(kOutlineGrid);
    for (std::size_t i = 0; i < kOutlineGrid; ++i) {
        const Point along =
            grid[(i + kTangentReach) % kOutlineGrid] - grid[(i + kOutlineGrid - kTangentReach) % kOutlineGrid];
        const double long_ = length(along);
        const Point tangent = long_ > 0.0 ? along * (1.0 / long_) : Point{1.0, 0.0};
        for (std::size_t bin = 0; bin < kHeightBins; ++bin) {
            const Point there = stretch[(i + bin * kBinWidth) % kOutlineGrid];
            raw[i][bin] = cross(tangent, there - (grid[i] - grid[0]));
        }
    }
    return raw;
}

/// Adds up, place by place, the least difference at two grid points or with both moved against each other by the slack.
/// A point is given by the one kOutlineSlack before it.
class SlackSum {
  public:
    SlackSum(const OutlineProfile& a, const OutlineProfile& b) : a_(a.heights.data()), b_(b.heights.data()) {}
    [[nodiscard]] int sum() const { return sum_of(sum_); }
    void add(std::uint8_t before_a, std::uint8_t before_b) {
        constexpr std::size_t kOn = 2 * kOutlineSlack;
        const Heights *a = a_ + before_a, *b = b_ + before_b;
        add_least(differences(a[kOutlineSlack], b[kOutlineSlack]), differences(a[kOn], b[0]),
                  differences(a[0], b[kOn]));
    }

  private:
#if defined(__SSE2__)
    using Sum = __m128i;  // the same in both halves
    static int sum_of(Sum sum) {
        return _mm_cvtsi128_si32(sum);
    }
    static __m128i differences(const Heights& a, const Heights& b) {
        return _mm_sad_epu8(_mm_load_si128(reinterpret_cast<const __m128i*>(a.data())),
                            _mm_load_si128(reinterpret_cast<const __m128i*>(b.data())));
    }
    void add_least(__m128i p, __m128i q, __m128i r) {
        // Two half sums each; pairs of halves are laid side by side, so that one addition serves two candidates.
        const __m128i pq = _mm_add_epi64(_mm_unpacklo_epi64(p, q), _mm_unpackhi_epi64(p, q));
        const __m128i rr = _mm_add_epi64(r, _mm_shuffle_epi32(r, _MM_SHUFFLE(1, 0, 3, 2)));
        const __m128i least = _mm_min_epi16(pq, rr);  // sums are below 2^12
        sum_ = _mm_add_epi64(sum_, _mm_min_epi16(least, _mm_shuffle_epi32(least, _MM_SHUFFLE(1, 0, 3, 2))));
    }
    Sum sum_ = _mm_setzero_si128();
#else
    using Sum = int;
    static int sum_of(Sum sum) {
        return sum;
    }
    static int differences(const Heights& a, const Heights& b) {
        int sum = 0;
        for (std::size_t bin = 0; bin < kHeightBins; ++bin) sum += std::abs(int{a[bin]} - int{b[bin]});
        return sum;
    }
    void add_least(int p, int q, int r) {
        sum_ += std::min(p, std::min(q, r));
    }
    Sum sum_ = 0;
#endif
    const Heights *a_, *b_;
};

/// How far on from the first anchor, on both outlines: anchors never step back, and a full turn is not none.
struct Progress {
    std::uint32_t a = 0, b = 0;
    [[nodiscard]] std::uint32_t middle() const { return a + b; }  // twice the mean
};

std::uint32_t step_on(std::uint32_t before, OutlinePlace from_start) {
    if (from_start > before) return from_start;
    return from_start == 0 && before > 0 ? kTurn : before;
}

/// Walks along the anchors and says which grid points answer to each other.
class Alignment {
  public:
    explicit Alignment(std::span<const OutlineAnchor> anchors) : anchors_(anchors), start_(anchors.front()) {
        advance();
    }

    /// The grid points kOutlineSlack before the nearest ones.
    struct GridPoints {
        std::uint8_t before_a = 0, before_b = 0;
    };
    /// `place` grows from call to call and is below 2 kTurn.
    GridPoints at(std::uint32_t place) {
        while (until_ <= place && next_ < anchors_.size()) advance();
        const auto share = static_cast<std::uint32_t>((place - since_) * per_place_ >> 16U);
        return {a_.before(share), b_.before(share)};
    }

  private:
    /// A stretch of one outline.
    struct Stretch {
        std::uint32_t from = 0, length = 0;
        Stretch() = default;
        Stretch(OutlinePlace start, std::uint32_t since, std::uint32_t until)
            : from(start + since + kHalfPoint - (static_cast<std::uint32_t>(kOutlineSlack) << kPointBits)),
              length(until - since) {}
        /// So much of 2^15 of the way.
        [[nodiscard]] std::uint8_t before(std::uint32_t share) const {
            return static_cast<std::uint8_t>((from + (length * share >> 15U)) >> kPointBits);
        }
    };
    static constexpr std::uint32_t kPointBits = 8, kHalfPoint = 1U << (kPointBits - 1);  // places of a grid point
    static_assert(kOutlineGrid << kPointBits == kTurn && kOutlineGrid == 256);           // wraps round by itself

    void advance() {
        const Progress from = to_;
        ++next_;
        to_ = next_ >= anchors_.size()
                  ? Progress{kTurn, kTurn}
                  : Progress{step_on(from.a, static_cast<OutlinePlace>(anchors_[next_].a - start_.a)),
                             step_on(from.b, static_cast<OutlinePlace>(anchors_[next_].b - start_.b))};
        since_ = from.middle();
        until_ = to_.middle();
        per_place_ = (std::uint64_t{1} << 31U) / std::max(1U, until_ - since_);
        a_ = Stretch(start_.a, from.a, to_.a);
        b_ = Stretch(start_.b, from.b, to_.b);
    }

    std::span<const OutlineAnchor> anchors_;
    OutlineAnchor start_;
    Progress to_;
    std::size_t next_ = 0;  // the anchor at to_
    // The stretch before it, in twice the mean of both progresses.
    std::uint32_t since_ = 0, until_ = 0;
    std::uint64_t per_place_ = 0;  // 2^31 / length
    Stretch a_, b_;
};

}  // namespace

namespace {

void repeat_first(OutlineProfile& profile) {
    for (std::size_t i = kOutlineGrid; i < profile.heights.size(); ++i) {
        profile.heights[i] = profile.heights[i - kOutlineGrid];
    }
}

}  // namespace

OutlineProfile outline_profile(const Polygon& ring) {
    const auto raw = raw_heights(resample_ring(ring, static_cast<int>(kOutlineGrid)));
    OutlineProfile profile;
    double deviations = 0.0;
    for (std::size_t bin = 0; bin < kHeightBins; ++bin) {
        double highest = 0.0, sum = 0.0, squares = 0.0;
        for (const auto& from_point : raw) highest = std::max(highest, std::abs(from_point[bin]));
        const double unit = highest > 0.0 ? 1.0 / highest : 0.0;
        for (std::size_t i = 0; i < kOutlineGrid; ++i) {
            const double height = raw[i][bin] * unit;
            sum += height;
            squares += height * height;
            const long level = std::lround(kHighest * bin_weight(bin) * height);
            profile.heights[i][bin] = static_cast<std::uint8_t>(kLevel + level);
        }
        const double mean = sum / kOutlineGrid;
        deviations += std::sqrt(std::max(0.0, squares / kOutlineGrid - mean * mean));
    }
    profile.complexity = static_cast<float>(deviations / kHeightBins);
    repeat_first(profile);
    return profile;
}

OutlineProfile mirrored(const OutlineProfile& profile) {
    OutlineProfile out;
    out.complexity = profile.complexity;
    for (std::size_t i = 0; i < kOutlineGrid; ++i) {
        const Heights& from = profile.heights[(kOutlineGrid - i) % kOutlineGrid];
        std::reverse_copy(from.begin(), from.end(), out.heights[i].begin());
    }
    repeat_first(out);
    return out;
}

PairedHeights paired_heights(const OutlineProfile& profile) {
    PairedHeights out{};
    for (std::size_t i = 0; i < kOutlineGrid; ++i) {
        for (std::size_t pair = 0; pair < kHeightBins / 2; ++pair) {
            const int sum = profile.heights[i][2 * pair] + profile.heights[i][2 * pair + 1] - kLevel;
            out[i][pair] = static_cast<std::uint8_t>(std::clamp(sum, 0, UINT8_MAX));
        }
    }
    return out;
}

float outline_difference(const OutlineProfile& a, const OutlineProfile& b, std::span<const OutlineAnchor> anchors,
                         float give_up_at) {
    if (anchors.empty()) return kUnaligned;
    static const float kUnit = [] {
        double weights = 0.0;
        for (std::size_t bin = 0; bin < kHeightBins; ++bin) weights += bin_weight(bin);
        return static_cast<float>(1.0 / (kHighest * weights * kComparisons));
    }();
    const float unit = kUnit / (kComplexityFloor + (a.complexity + b.complexity));
    const float limit = give_up_at / unit;
    Alignment alignment(anchors);
    SlackSum sum(a, b);
    for (std::uint32_t i = 0; i < kComparisons; ++i) {
        const Alignment::GridPoints at = alignment.at(i * (2 * kTurn / kComparisons));
        sum.add(at.before_a, at.before_b);
        if (i % 8 == 7 && static_cast<float>(sum.sum()) >= limit) return give_up_at;
    }
    return static_cast<float>(sum.sum()) * unit;
}

namespace {

/// One anchor for all: b turned against a by the mean of what the anchors say.
OutlineAnchor mean_turn(std::span<const OutlineAnchor> anchors) {
    const auto turn_of = [](const OutlineAnchor& anchor) { return static_cast<OutlinePlace>(anchor.b - anchor.a); };
    const OutlinePlace first = turn_of(anchors.front());
    int sum = 0;
    for (const OutlineAnchor& anchor : anchors) sum += static_cast<std::int16_t>(turn_of(anchor) - first);
    const int mean = sum / static_cast<int>(anchors.size());
    return {anchors.front().a, static_cast<OutlinePlace>(anchors.front().a + first + mean)};
}

/// The difference of two outlines turned against each other, least near `turn`.
float turned_difference(const OutlineProfile& a, const OutlineProfile& b, OutlineAnchor turn) {
    float least = outline_difference(a, b, {&turn, 1});
    for (const int step : {6 << 8, 3 << 8, 1 << 8}) {
        const OutlineAnchor centre = turn;
        for (const int by : {-step, step}) {
            const OutlineAnchor tried{centre.a, static_cast<OutlinePlace>(centre.b + by)};
            const float difference = outline_difference(a, b, {&tried, 1}, least);
            if (difference >= least) continue;
            least = difference;
            turn = tried;
        }
    }
    return least;
}

}  // namespace

float aligned_difference(const OutlineProfile& a, const OutlineProfile& b, std::span<const OutlineAnchor> anchors,
                         float give_up_at) {
    const float along = outline_difference(a, b, anchors, std::max(give_up_at, kNearlyEqual));
    if (along >= kNearlyEqual) return along;
    return std::min(along, turned_difference(a, b, mean_turn(anchors)));
}

}  // namespace core
