#include "core/match/decision_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace core {

namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// How many groups hold the members, rounded up to whole wide lanes.
std::size_t row_length(const OpenedRing& open) {
    constexpr std::size_t kInWide = kWideLanes / kLanes;
    return (lane_groups(open.members.size()) + kInWide - 1) / kInWide * kInWide;
}

float least_lane(Lanes v) {
    return std::min(std::min(v[0], v[1]), std::min(v[2], v[3]));
}

Lanes greatest_of(Lanes a, float b) {
    const Lanes other = all_lanes(b);
    return a > other ? a : other;
}

float inter_cost(const InterDistance& a, const InterDistance& b) {
    const float e = a.d_e - b.d_e, be = a.d_be - b.d_be, angle = a.d_a - b.d_a;
    return e * e + be * be + angle * angle;
}

Lanes square_root(Lanes v) {
    for (std::size_t i = 0; i < kLanes; ++i) v[i] = std::sqrt(v[i]);
    return v;
}

/// Root of the weighted feature differences of one part and a group of them.
Lanes feature_distances(const RingPart& x, const PartGroup& y) {
    Lanes sum{};
    for (std::size_t k = 0; k < kFeatureCount; ++k) {
        const Lanes d = x.weighted[k] - y.weighted[k].v;
        sum += d * d;
    }
    return square_root(sum);
}

/// Squared distance of the signature of one part and those of a group, read as they are or from their ends.
template <bool kReversed>
Lanes signature_distances(const RingPart& x, const PartGroup& y) {
    Lanes sum{};
    for (std::size_t k = 0; k < kSignatureSize; ++k) {
        const Lanes d = x.signature[k] - y.signature[kReversed ? kSignatureSize - 1 - k : k].v;
        sum += d * d;
    }
    return sum;
}

}  // namespace

/// Both readings of b at once: its features are the same, its signatures turn round.
void DecisionMatrix::set_rings(const PartRing& a, const PartRing& b) {
    own_row_ = b.groups.size();
    own_.resize(a.parts.size() * own_row_);
    own_reversed_.resize(own_.size());
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        const RingPart& x = a.parts[i];
        for (std::size_t g = 0; g < own_row_; ++g) {
            const PartGroup& y = b.groups[g];
            const Lanes features = feature_distances(x, y);
            own_[i * own_row_ + g].v = features + signature_distances<false>(x, y) - x.spared - y.spared.v;
            own_reversed_[i * own_row_ + g].v = features + signature_distances<true>(x, y) - x.spared - y.spared.v;
        }
    }
}

/// The opened b's columns of own_, and for each member of it the least gain of what can come before, whatever of a it
/// is paired with, even several times the same.
void DecisionMatrix::set_cut(const PartRing& a, const OpenedRing& open_b, bool reversed) {
    const std::vector<LaneGroup>& own = reversed ? own_reversed_ : own_;
    const std::size_t row = row_length(open_b);
    own_in_order_.resize(a.parts.size() * row);
    least_of_a_.resize(a.parts.size());
    least_of_b_.assign(row, LaneGroup{});
    for (std::size_t x = 0; x < a.parts.size(); ++x) {
        LaneGroup* ordered = &own_in_order_[x * row];
        std::fill(ordered + open_b.members.size() / kLanes, ordered + row, LaneGroup{});  // nought past the members
        auto* to = reinterpret_cast<float*>(ordered);
        const auto* from = reinterpret_cast<const float*>(&own[x * own_row_]);
        for (std::size_t k = 0; k < open_b.members.size(); ++k) to[k] = from[open_b.members[k].part];
        Lanes least{};
        for (std::size_t g = 0; g < row; ++g) {
            least = least_of(least, ordered[g].v);
            least_of_b_[g].v = least_of(least_of_b_[g].v, ordered[g].v);
        }
        least_of_a_[x] = least_lane(least);
    }
    before_b_.resize(row);
    fill_before(open_b, reinterpret_cast<const float*>(least_of_b_.data()), false,
                reinterpret_cast<float*>(before_b_.data()));
}

/// The least sum of `least` over members that follow one another, before each member.
void DecisionMatrix::fill_before(const OpenedRing& open, const float* least, bool by_part, float* out) {
    until_.resize(open.members.size() + 1);
    until_[0] = 0.0F;
    for (std::size_t k = 0; k < open.members.size(); ++k) {
        const OpenedRing::Member& member = open.members[k];
        out[k] = until_[index(member.before)];
        until_[k + 1] = std::min(until_[k], out[k] + least[by_part ? index(member.part) : k]);
    }
}

/// gains_[x, y] is the cost of the best match that starts with this pair, less that of leaving all its terminals out.
/// Members come by where they end, so what may follow a member comes after it. A pair that gains nothing is better left
/// out than followed; one that with all that can come before it does not get below `give_up_at` is of no use either. So
/// only gains below a threshold are followed.
float DecisionMatrix::solve(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b, float give_up_at) {
    const std::size_t row = row_length(open_b), size_a = open_a.members.size();
    gains_.assign(size_a * row, LaneGroup{});
    onward_gains_.resize(size_a * row);
    row_least_.resize(size_a);
    before_a_.resize(size_a);
    fill_before(open_a, least_of_a_.data(), true, before_a_.data());
    float least = 0.0F;
    for (std::size_t x = size_a; x-- > 0;) {
        const LaneGroup* own = &own_in_order_[index(open_a.members[x].part) * row];
        Lanes least_of_row{};
        for (std::size_t g = 0; g < row; ++g) {
            const Lanes threshold = least_of(Lanes{}, give_up_at - greatest_of(before_b_[g].v, before_a_[x]));
            Lanes& gain = gains_[x * row + g].v;
            onward_gains_[x * row + g].v = gain;
            gain = own[g].v + gain;
            gain = gain < threshold ? gain : Lanes{};
            least_of_row = least_of(least_of_row, gain);
        }
        row_least_[x] = least_lane(least_of_row);
        least = std::min(least, row_least_[x]);
        if (open_a.members[x].before > 0 && row_least_[x] < 0.0F) connect(a, open_a, open_b, x);
    }
    return least;
}

/// Offers the pairs of member `to` of A as the next to all pairs that end before them. A pair that gains nothing is
/// better left out than followed.
CROQUIS_LANES_CLONES void DecisionMatrix::connect(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b,
                                                  std::size_t to) {
    const std::size_t row = row_length(open_b);
    const auto* gain_of = reinterpret_cast<const float*>(&gains_[to * row]);
    onward_.resize(open_b.members.size());
    const InterDistance* const from_part = &a.inter[index(open_a.members[to].part)];
    const std::size_t part_count = a.parts.size();
    for (std::size_t g = 0; g * kWideLanes < open_b.members.size(); ++g) {
        Onward* last = onward_.data();
        for (auto k = index(open_b.steps_from[g]); k < index(open_b.steps_from[g + 1]); ++k) {
            const float gain = gain_of[open_b.steps_to[k]];
            *last = {gain, &open_b.steps[k]};
            last += gain < 0.0F ? 1 : 0;  // without a branch: it would be guessed wrongly half the time
        }
        if (last == onward_.data()) continue;
        for (std::size_t x = 0; x < index(open_a.members[to].before); ++x) {
            const InterDistance& d = from_part[index(open_a.members[x].part) * part_count];
            const WideLanes d_e = WideLanes{} + d.d_e, d_be = WideLanes{} + d.d_be, d_a = WideLanes{} + d.d_a;
            auto* const gains = reinterpret_cast<float*>(&gains_[x * row]) + g * kWideLanes;
            WideLanes best;
            std::memcpy(&best, gains, sizeof best);
            for (const Onward* next = onward_.data(); next != last; ++next) {
                const WideLanes e = d_e - next->step->d_e, be = d_be - next->step->d_be, angle = d_a - next->step->d_a;
                const WideLanes gain = next->gain + (e * e + be * be + angle * angle);
                best = gain < best ? gain : best;
            }
            std::memcpy(gains, &best, sizeof best);
        }
    }
}

/// The pair that best starts the match; nullopt if none gains anything. Among equal ones the first in member order.
std::optional<DecisionMatrix::Link> DecisionMatrix::first_link(const OpenedRing& open_a,
                                                               const OpenedRing& open_b) const {
    const std::size_t row = row_length(open_b);
    const float least = row_least_.empty() ? 0.0F : *std::min_element(row_least_.begin(), row_least_.end());
    if (least >= 0.0F) return std::nullopt;
    for (std::size_t x = 0; x < open_a.members.size(); ++x) {
        if (row_least_[x] != least) continue;
        const auto* gains = reinterpret_cast<const float*>(&gains_[x * row]);
        return Link{x, static_cast<std::size_t>(std::find(gains, gains + open_b.members.size(), least) - gains)};
    }
    return std::nullopt;
}

/// The pair that best follows a pair of the match; nullopt if none gains anything. Among equal ones the first in member
/// order.
std::optional<DecisionMatrix::Link> DecisionMatrix::next_link(const PartRing& a, const OpenedRing& open_a,
                                                              const PartRing& b, const OpenedRing& open_b,
                                                              Link after) const {
    const std::size_t row = row_length(open_b);
    const float sought = reinterpret_cast<const float*>(&onward_gains_[after.x * row])[after.y];
    if (sought >= 0.0F) return std::nullopt;
    for (std::size_t x = after.x + 1; x < open_a.members.size(); ++x) {
        if (row_least_[x] > sought || after.x >= index(open_a.members[x].before)) continue;
        const InterDistance& of_a = a.between(index(open_a.members[after.x].part), index(open_a.members[x].part));
        const auto* gains = reinterpret_cast<const float*>(&gains_[x * row]);
        for (std::size_t y = after.y + 1; y < open_b.members.size(); ++y) {
            if (gains[y] > sought || after.y >= index(open_b.members[y].before)) continue;
            const InterDistance& of_b = b.between(index(open_b.members[after.y].part), index(open_b.members[y].part));
            if (gains[y] + inter_cost(of_a, of_b) == sought) return Link{x, y};
        }
    }
    return std::nullopt;
}

void DecisionMatrix::trace(const PartRing& a, const OpenedRing& open_a, const PartRing& b, const OpenedRing& open_b,
                           Chain& chain) const {
    chain.clear();
    std::optional<Link> link = first_link(open_a, open_b);
    while (link) {
        chain.emplace_back(open_a.members[link->x].part, open_b.members[link->y].part);
        link = next_link(a, open_a, b, open_b, *link);
    }
}

}  // namespace core
