#include "core/match/match.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace core {

namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// Bounds are compared with this share of slack, so that rounding never cuts off the best match.
constexpr float kRounding = 1e-5F;

}  // namespace

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

float configuration_distance(float parts, float outline) {
    return kOutlineWeight * outline + parts * std::min(1.0F, outline / kNearlyEqual);
}

namespace {

/// The parts' cost with which an outline difference reaches `distance`.
float parts_within(float distance, float outline) {
    const float share = std::min(1.0F, outline / kNearlyEqual);
    return share > 0.0F ? (distance - kOutlineWeight * outline) / share : std::numeric_limits<float>::infinity();
}

/// The outline difference with which these parts reach `distance`.
float outline_within(float distance, float parts) {
    const float beyond = (distance - parts) / kOutlineWeight;
    return beyond >= kNearlyEqual ? beyond : distance / (kOutlineWeight + parts / kNearlyEqual);
}

}  // namespace

/// The outlines along chain_, or what is not below `give_up_at`. It starts at its first place
/// on the outline of a whatever the cut, so that the same pairs give the same value.
float Matcher::outline_along(const PartRing& a, const PartRing& b, float give_up_at) {
    pairs_ = chain_;
    const auto first = std::min_element(pairs_.begin(), pairs_.end(), [&](const auto& p, const auto& q) {
        return a.parts[index(p.first)].from < a.parts[index(q.first)].from;
    });
    std::rotate(pairs_.begin(), first, pairs_.end());
    for (std::size_t k = 0; k < compared_count_; ++k) {
        if (compared_[k].pairs == pairs_) return compared_[k].outline;
    }
    anchors_.clear();
    for (const auto& [x, y] : pairs_) {
        const RingPart &of_a = a.parts[index(x)], &of_b = b.parts[index(y)];
        anchors_.push_back({of_a.from, of_b.from});
        anchors_.push_back({of_a.to, of_b.to});
    }
    const float outline = aligned_difference(a.outline, b.outline, anchors_, give_up_at);
    if (outline >= give_up_at) return outline;
    if (compared_count_ == compared_.size()) compared_.emplace_back();
    compared_[compared_count_].pairs = pairs_;
    compared_[compared_count_++].outline = outline;
    return outline;
}

/// Of equal configurations the first wins. One that cannot come below the best, whatever its outlines differ by beyond
/// `least_outline`, is not looked at further.
void Matcher::try_cuts(const PartRing& a, const PartRing& b, bool reversed, float least_outline) {
    compared_count_ = 0;
    const float all = a.norms + b.norms, unit = std::sqrt(all);
    for (const OpenedRing& open_b : b.opened) {
        if (parts_within(best_.distance, least_outline) <= 0.0F) return;
        matrix_.set_cut(a, open_b, reversed);
        for (const OpenedRing& open_a : a.opened) {
            const float most = parts_within(best_.distance, least_outline) * unit - all + kRounding * all;
            const float gain = matrix_.solve(a, open_a, open_b, most);
            if (gain >= most) continue;
            const float cost = std::max(0.0F, all + gain);
            const float parts = cost / unit;
            const float spare = outline_within(best_.distance, parts);
            if (least_outline >= spare) continue;
            matrix_.trace(a, open_a, b, open_b, chain_);
            const float outline = outline_along(a, b, spare);
            if (outline >= spare) continue;
            const float distance = configuration_distance(parts, outline);
            if (distance >= best_.distance) continue;
            best_.distance = distance;
            best_.part_cost = cost;
            best_.outline = outline;
            best_.reversed = reversed;
            best_.chain = chain_;
        }
    }
}

void Matcher::try_both(const MatchableShape& a, const MatchableShape& b, float give_up_at, LeastOutlines least) {
    best_.distance = give_up_at;
    best_.chain.clear();
    matrix_.set_rings(a.forwards, b.forwards);
    try_cuts(a.forwards, b.forwards, false, least.along);
    try_cuts(a.forwards, b.backwards, true, least.against);
}

double Matcher::distance(const MatchableShape& a, const MatchableShape& b, double give_up_at, LeastOutlines least) {
    const bool swapped = !in_order(a.forwards, b.forwards);
    try_both(swapped ? b : a, swapped ? a : b, static_cast<float>(give_up_at), least);
    return best_.distance;
}

double Matcher::asymmetry(const MatchableShape& shape) {
    best_.distance = std::numeric_limits<float>::infinity();
    matrix_.set_rings(shape.forwards, shape.forwards);
    try_cuts(shape.forwards, shape.backwards, true, 0.0F);
    return best_.distance;
}

double Matcher::part_cost(const MatchableShape& first, const MatchableShape& second) {
    const bool swapped = !in_order(first.forwards, second.forwards);
    const MatchableShape& a = swapped ? second : first;
    const MatchableShape& b = swapped ? first : second;
    matrix_.set_rings(a.forwards, b.forwards);
    const float all = a.forwards.norms + b.forwards.norms;
    float gain = 0.0F;
    for (const bool reversed : {false, true}) {
        for (const OpenedRing& open_b : (reversed ? b.backwards : b.forwards).opened) {
            matrix_.set_cut(a.forwards, open_b, reversed);
            for (const OpenedRing& open_a : a.forwards.opened) {
                gain = std::min(gain, matrix_.solve(a.forwards, open_a, open_b, gain + kRounding * all));
            }
        }
    }
    return std::max(0.0F, all + gain);
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

/// Fills in the pairs, their costs, and what is left out.
void explain(const PartRing& a, const PartRing& b, const DecisionMatrix::Chain& chain, Match& match) {
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

}  // namespace

Match Matcher::match(const MatchableShape& a, const MatchableShape& b) {
    const bool swapped = !in_order(a.forwards, b.forwards);
    try_both(swapped ? b : a, swapped ? a : b, std::numeric_limits<float>::infinity());
    Match match;
    match.distance = best_.distance;
    match.part_cost = best_.part_cost;
    match.outline = best_.outline;
    match.reversed = best_.reversed;
    Chain chain = best_.chain;
    if (swapped) {
        for (auto& [x, y] : chain) std::swap(x, y);
        if (best_.reversed)
            std::reverse(chain.begin(), chain.end());  // the second was read backwards, now the first is not
    }
    explain(a.forwards, best_.reversed ? b.backwards : b.forwards, chain, match);
    return match;
}

}  // namespace core
