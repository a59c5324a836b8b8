#include "core/match/match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace core {

namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// Bounds are compared with this share of slack, so that rounding never cuts off the best match.
constexpr float kRounding = 1e-5F;

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

/// Root of the weighted feature differences of one part and four.
Lanes feature_distances(const RingPart& x, const PartGroup& y) {
    Lanes sum{};
    for (std::size_t k = 0; k < kFeatureCount; ++k) {
        const Lanes d = x.weighted[k] - y.weighted[k].v;
        sum += d * d;
    }
    return square_root(sum);
}

/// Squared distance of the signature of one part and those of four, read as they are or from their ends.
template <bool kReversed>
Lanes signature_distances(const RingPart& x, const PartGroup& y) {
    Lanes sum{};
    for (std::size_t k = 0; k < kSignatureSize; ++k) {
        const Lanes d = x.signature[k] - y.signature[kReversed ? kSignatureSize - 1 - k : k].v;
        sum += d * d;
    }
    return sum;
}

/// A fixed order of the two shapes, so that sums are built in the same way for (A, B) and (B, A). The one with fewer
/// parts comes first: the second fills the lanes.
bool in_order(const PartRing& a, const PartRing& b) {
    const auto sizes = [](const PartRing& r) { return std::tuple(r.parts.size(), r.terminal_count, r.norms); };
    if (sizes(a) != sizes(b)) return sizes(a) < sizes(b);
    const auto content = [](const RingPart& p) { return std::tie(p.first, p.count, p.weighted, p.signature); };
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        if (content(a.parts[i]) != content(b.parts[i])) return content(a.parts[i]) < content(b.parts[i]);
    }
    const auto inter = [](const InterDistance& d) { return std::tie(d.d_e, d.d_be, d.d_a); };
    return !std::lexicographical_compare(b.inter.begin(), b.inter.end(), a.inter.begin(), a.inter.end(),
                                         [&](const auto& p, const auto& q) { return inter(p) < inter(q); });
}

}  // namespace

/// Both readings of b at once: its features are the same, its signatures turn round.
void Matcher::fill_own(const PartRing& a, const PartRing& b) {
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
void Matcher::order_own(const PartRing& a, const OpenedRing& open_b, bool reversed) {
    const std::vector<LaneGroup>& own = reversed ? own_reversed_ : own_;
    const std::size_t row = lane_groups(open_b.members.size());
    own_in_order_.resize(a.parts.size() * row);
    least_of_a_.resize(a.parts.size());
    least_of_b_.assign(row, LaneGroup{});
    for (std::size_t x = 0; x < a.parts.size(); ++x) {
        LaneGroup* ordered = &own_in_order_[x * row];
        ordered[row - 1].v = Lanes{};
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
void Matcher::fill_before(const OpenedRing& open, const float* least, bool by_part, float* out) {
    until_.resize(open.members.size() + 1);
    until_[0] = 0.0F;
    for (std::size_t k = 0; k < open.members.size(); ++k) {
        const OpenedRing::Member& member = open.members[k];
        out[k] = until_[index(member.before)];
        until_[k + 1] = std::min(until_[k], out[k] + least[by_part ? index(member.part) : k]);
    }
}

/// The least cost for one pair of cuts, less the norms of all terminals; or anything not below `give_up_at`, if it is
/// not below. gains_[x, y] is the cost of the best match that starts with this pair, less that of leaving all its
/// terminals out. Members come by where they end, so what may follow a member comes after it. A pair that gains nothing
/// is better left out than followed; one that with all that can come before it does not get below `give_up_at` is of no
/// use either. So only gains below a threshold are followed.
float Matcher::solve(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b, float give_up_at) {
    const std::size_t row = lane_groups(open_b.members.size()), size_a = open_a.members.size();
    gains_.assign(size_a * row, LaneGroup{});
    before_a_.resize(size_a);
    fill_before(open_a, least_of_a_.data(), true, before_a_.data());
    Lanes least{};
    for (std::size_t x = size_a; x-- > 0;) {
        const LaneGroup* own = &own_in_order_[index(open_a.members[x].part) * row];
        for (std::size_t g = 0; g < row; ++g) {
            const Lanes threshold = least_of(Lanes{}, give_up_at - greatest_of(before_b_[g].v, before_a_[x]));
            Lanes& gain = gains_[x * row + g].v;
            gain = own[g].v + gain;
            gain = gain < threshold ? gain : Lanes{};
            least = least_of(least, gain);
        }
        if (open_a.members[x].before > 0) connect(a, open_a, open_b, x);
    }
    return least_lane(least);
}

/// Offers the pairs of member `to` of A as the next to all pairs that end before them. A pair that gains nothing is
/// better left out than followed.
CROQUIS_LANES_CLONES void Matcher::connect(const PartRing& a, const OpenedRing& open_a, const OpenedRing& open_b,
                                           std::size_t to) {
    const std::size_t row = lane_groups(open_b.members.size());
    const auto* gain_of = reinterpret_cast<const float*>(&gains_[to * row]);
    onward_.resize(open_b.members.size());
    for (std::size_t g = 0; g < row; ++g) {
        const OpenedRing::Step* step = open_b.steps.data() + open_b.steps_from[g];
        const OpenedRing::Step* end = open_b.steps.data() + open_b.steps_from[g + 1];
        Onward* last = onward_.data();
        for (; step != end; ++step) {  // without a branch: it would be guessed wrongly half the time
            const float gain = gain_of[step->to];
            *last = {all_lanes(gain), step};
            last += gain < 0.0F ? 1 : 0;
        }
        if (last == onward_.data()) continue;
        for (std::size_t x = 0; x < index(open_a.members[to].before); ++x) {
            const InterDistance& d = a.between(index(open_a.members[x].part), index(open_a.members[to].part));
            const Lanes d_e = all_lanes(d.d_e), d_be = all_lanes(d.d_be), d_a = all_lanes(d.d_a);
            Lanes best = gains_[x * row + g].v;
            for (const Onward* next = onward_.data(); next != last; ++next) {
                const Lanes e = d_e - next->step->d_e, be = d_be - next->step->d_be, angle = d_a - next->step->d_a;
                best = least_of(next->gain + (e * e + be * be + angle * angle), best);
            }
            gains_[x * row + g].v = best;
        }
    }
}

/// Between equal costs the first pair of cuts wins.
void Matcher::try_cuts(const PartRing& a, const PartRing& b, bool reversed, Cut& best) {
    for (std::size_t j = 0; j < b.opened.size(); ++j) {
        order_own(a, b.opened[j], reversed);
        for (std::size_t i = 0; i < a.opened.size(); ++i) {
            const float all = a.norms + b.norms;
            const float cost = all + solve(a, a.opened[i], b.opened[j], best.cost - all + kRounding * all);
            if (cost < best.cost) best = {cost, i, j, reversed};
        }
    }
}

Matcher::Cut Matcher::best_cut(const MatchableShape& a, const MatchableShape& b) {
    Cut best{std::numeric_limits<float>::infinity(), 0, 0, false};
    fill_own(a.forwards, b.forwards);
    try_cuts(a.forwards, b.forwards, false, best);
    try_cuts(a.forwards, b.backwards, true, best);
    best.cost = std::max(0.0F, best.cost);
    return best;
}

double Matcher::distance(const MatchableShape& a, const MatchableShape& b) {
    return in_order(a.forwards, b.forwards) ? best_cut(a, b).cost : best_cut(b, a).cost;
}

double Matcher::asymmetry(const MatchableShape& shape) {
    Cut best{std::numeric_limits<float>::infinity(), 0, 0, true};
    fill_own(shape.forwards, shape.forwards);
    try_cuts(shape.forwards, shape.backwards, true, best);
    return std::max(0.0F, best.cost);
}

/// The pair that best starts the match (after == nullptr) or best follows a pair of it; nullopt if none gains anything.
/// Among equal ones the first in member order.
std::optional<Matcher::Link> Matcher::next_link(const PartRing& a, const OpenedRing& open_a, const PartRing& b,
                                                const OpenedRing& open_b, const Link* after) const {
    const std::size_t row = lane_groups(open_b.members.size());
    float least = 0.0F;
    std::optional<Link> best;
    for (std::size_t i = 0; i < open_a.members.size(); ++i) {
        const OpenedRing::Member& x = open_a.members[i];
        if (after != nullptr && after->x >= index(x.before)) continue;
        for (std::size_t j = 0; j < open_b.members.size(); ++j) {
            const OpenedRing::Member& y = open_b.members[j];
            if (after != nullptr && after->y >= index(y.before)) continue;
            float gain = gains_[i * row + j / kLanes].v[j % kLanes];
            if (gain >= 0.0F) continue;
            if (after != nullptr) {
                gain += inter_cost(a.between(index(open_a.members[after->x].part), index(x.part)),
                                   b.between(index(open_b.members[after->y].part), index(y.part)));
            }
            if (gain >= least) continue;
            least = gain;
            best = Link{i, j};
        }
    }
    return best;
}

/// The parts of a and b matched by the pair of cuts solved last, in their order.
Matcher::Chain Matcher::trace(const PartRing& a, const OpenedRing& open_a, const PartRing& b,
                              const OpenedRing& open_b) const {
    Chain chain;
    std::optional<Link> link = next_link(a, open_a, b, open_b, nullptr);
    while (link) {
        chain.emplace_back(open_a.members[link->x].part, open_b.members[link->y].part);
        link = next_link(a, open_a, b, open_b, &*link);
    }
    return chain;
}

namespace {

MatchedPair matched_pair(const RingPart& x, const RingPart& y) {
    MatchedPair pair{x.part, y.part, 0.0, 0.0, 0.0, 0.0, 0.0};
    for (std::size_t f = 0; f < kFeatureCount; ++f) pair.features += std::pow(x.weighted[f] - y.weighted[f], 2.0);
    pair.features = std::sqrt(pair.features);
    for (std::size_t s = 0; s < kSignatureSize; ++s) pair.signature += std::pow(x.signature[s] - y.signature[s], 2.0);
    return pair;
}

void mark(const PartRing& ring, const RingPart& part, std::vector<char>& matched) {
    for (int t = 0; t < part.count; ++t) matched[index((part.first + t) % ring.terminal_count)] = 1;
}

void leave_out(const PartRing& ring, const std::vector<char>& matched, bool backwards, std::vector<int>& out,
               double& cost) {
    for (int t = 0; t < ring.terminal_count; ++t) {
        if (matched[index(t)] != 0) continue;
        out.push_back(backwards ? ring.terminal_count - 1 - t : t);
        cost += ring.terminal_norm[index(t)];
    }
    std::sort(out.begin(), out.end());
}

}  // namespace

void Matcher::explain(const PartRing& a, const PartRing& b, const Chain& chain, Match& match) {
    std::vector<char> used_a(index(a.terminal_count), 0), used_b(index(b.terminal_count), 0);
    for (std::size_t k = 0; k < chain.size(); ++k) {
        const auto [x, y] = chain[k];
        MatchedPair pair = matched_pair(a.parts[index(x)], b.parts[index(y)]);
        if (k > 0) {
            const InterDistance& ia = a.between(index(chain[k - 1].first), index(x));
            const InterDistance& ib = b.between(index(chain[k - 1].second), index(y));
            pair.d_e = std::pow(ia.d_e - ib.d_e, 2.0);
            pair.d_be = std::pow(ia.d_be - ib.d_be, 2.0);
            pair.d_a = std::pow(ia.d_a - ib.d_a, 2.0);
        }
        mark(a, a.parts[index(x)], used_a);
        mark(b, b.parts[index(y)], used_b);
        match.pairs.push_back(pair);
    }
    leave_out(a, used_a, false, match.left_out_a, match.left_out_cost);
    leave_out(b, used_b, match.reversed, match.left_out_b, match.left_out_cost);
}

Match Matcher::match(const MatchableShape& a, const MatchableShape& b) {
    const bool swapped = !in_order(a.forwards, b.forwards);
    const MatchableShape& first = swapped ? b : a;
    const MatchableShape& second = swapped ? a : b;
    const Cut best = best_cut(first, second);
    Match match;
    match.distance = best.cost;
    match.reversed = best.reversed;
    Chain chain;
    if (std::isfinite(best.cost)) {
        const PartRing& other = best.reversed ? second.backwards : second.forwards;
        order_own(first.forwards, other.opened[best.open_b], best.reversed);
        (void)solve(first.forwards, first.forwards.opened[best.open_a], other.opened[best.open_b],
                    std::numeric_limits<float>::infinity());
        chain = trace(first.forwards, first.forwards.opened[best.open_a], other, other.opened[best.open_b]);
    }
    if (swapped) {
        for (auto& [x, y] : chain) std::swap(x, y);
        if (best.reversed)
            std::reverse(chain.begin(), chain.end());  // the second was read backwards, now the first is not
    }
    explain(a.forwards, best.reversed ? b.backwards : b.forwards, chain, match);
    return match;
}

}  // namespace core
