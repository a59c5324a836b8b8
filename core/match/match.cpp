#include "core/match/match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

void Matcher::fill_node_distances(const PartRing& a, const PartRing& b) {
    node_distance_.resize(a.parts.size() * b.parts.size());
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        for (std::size_t j = 0; j < b.parts.size(); ++j) {
            node_distance_[i * b.parts.size() + j] = core::node_distance(a.parts[i], b.parts[j]);
        }
    }
}

namespace {

int position(const RingPart& part, int start, int n) {
    const int p = part.first - start;
    return p < 0 ? p + n : p;
}

/// Parts that do not run over the cut at `start`, from the last position to the first.
void order_parts(const PartRing& ring, int start, std::vector<int>& order) {
    const int n = ring.terminal_count;
    order.clear();
    for (std::size_t i = 0; i < ring.parts.size(); ++i) {
        if (position(ring.parts[i], start, n) + ring.parts[i].count <= n) order.push_back(static_cast<int>(i));
    }
    std::stable_sort(order.begin(), order.end(), [&](int p, int q) {
        return position(ring.parts[static_cast<std::size_t>(p)], start, n) >
               position(ring.parts[static_cast<std::size_t>(q)], start, n);
    });
}

/// sums[i]: norms of the terminals at position i and after.
void norms_from(const PartRing& ring, int start, std::vector<float>& sums) {
    const int n = ring.terminal_count;
    sums.assign(static_cast<std::size_t>(n) + 1, 0.0F);
    for (int i = n - 1; i >= 0; --i) {
        sums[static_cast<std::size_t>(i)] =
            sums[static_cast<std::size_t>(i) + 1] + ring.terminal_norm[static_cast<std::size_t>((start + i) % n)];
    }
}

float inter_cost(const InterDistance& a, const InterDistance& b) {
    const float e = a.d_e - b.d_e, be = a.d_be - b.d_be, angle = a.d_a - b.d_a;
    return e * e + be * be + angle * angle;
}

}  // namespace

/// One configuration. Entries are made from the ends of both rings backwards, so everything that may follow an entry stands
/// before it; entries that do not beat leaving out are dropped, since inter-distances only add.
float Matcher::solve(const PartRing& a, const PartRing& b, int start_a, int start_b) {
    order_parts(a, start_a, order_a_);
    order_parts(b, start_b, order_b_);
    norms_from(a, start_a, left_a_);
    norms_from(b, start_b, left_b_);
    entries_.clear();
    head_ = -1;
    float best = 0.0F;
    for (const int x : order_a_) {
        const RingPart& px = a.parts[static_cast<std::size_t>(x)];
        const int xs = position(px, start_a, a.terminal_count), xe = xs + px.count;
        const float spared_a = left_a_[static_cast<std::size_t>(xs)] - left_a_[static_cast<std::size_t>(xe)];
        for (const int y : order_b_) {
            const RingPart& py = b.parts[static_cast<std::size_t>(y)];
            const int ys = position(py, start_b, b.terminal_count), ye = ys + py.count;
            const float spared_b = left_b_[static_cast<std::size_t>(ys)] - left_b_[static_cast<std::size_t>(ye)];
            const float own = node_distance_[static_cast<std::size_t>(x) * b.parts.size() + static_cast<std::size_t>(y)] -
                              spared_a - spared_b;
            Entry entry{0.0F, -1, x, y, xe, ye, xs, ys};
            for (std::size_t k = 0; k < entries_.size(); ++k) {
                const Entry& next = entries_[k];
                if (next.gain >= entry.gain || next.x_start < xe || next.y_start < ye) continue;
                const float gain =
                    next.gain + inter_cost(a.between(static_cast<std::size_t>(x), static_cast<std::size_t>(next.x)),
                                           b.between(static_cast<std::size_t>(y), static_cast<std::size_t>(next.y)));
                if (gain < entry.gain) {
                    entry.gain = gain;
                    entry.next = static_cast<int>(k);
                }
            }
            entry.gain += own;
            if (entry.gain >= 0.0F) continue;
            if (entry.gain < best) {
                best = entry.gain;
                head_ = static_cast<int>(entries_.size());
            }
            entries_.push_back(entry);
        }
    }
    return left_a_[0] + left_b_[0] + best;
}

Matcher::Configuration Matcher::best_direction(const PartRing& a, const PartRing& b, bool reversed, Configuration best) {
    fill_node_distances(a, b);
    for (const int start_a : a.stop_points) {
        for (const int start_b : b.stop_points) {
            const float cost = solve(a, b, start_a, start_b);
            if (cost < best.cost) best = {cost, start_a, start_b, reversed};
        }
    }
    return best;
}

double Matcher::distance(const MatchableShape& a, const MatchableShape& b) {
    Configuration best{std::numeric_limits<float>::infinity(), -1, -1, false};
    best = best_direction(a.forwards, b.forwards, false, best);
    best = best_direction(a.forwards, b.backwards, true, best);
    return std::max(0.0F, best.cost);
}

double Matcher::asymmetry(const MatchableShape& shape) {
    const Configuration none{std::numeric_limits<float>::infinity(), -1, -1, false};
    return std::max(0.0F, best_direction(shape.forwards, shape.backwards, true, none).cost);
}

Match Matcher::match(const MatchableShape& a, const MatchableShape& b) {
    Configuration best{std::numeric_limits<float>::infinity(), -1, -1, false};
    best = best_direction(a.forwards, b.forwards, false, best);
    best = best_direction(a.forwards, b.backwards, true, best);
    return explain(a.forwards, best.reversed ? b.backwards : b.forwards, best);
}

namespace {

void leave_out(const PartRing& ring, const std::vector<char>& matched, bool backwards, std::vector<int>& out, double& cost) {
    for (int t = 0; t < ring.terminal_count; ++t) {
        if (matched[static_cast<std::size_t>(t)] != 0) continue;
        out.push_back(backwards ? ring.terminal_count - 1 - t : t);
        cost += ring.terminal_norm[static_cast<std::size_t>(t)];
    }
    std::sort(out.begin(), out.end());
}

}  // namespace

Match Matcher::explain(const PartRing& a, const PartRing& b, const Configuration& best) {
    fill_node_distances(a, b);
    Match match;
    match.distance = std::max(0.0F, solve(a, b, best.start_a, best.start_b));
    match.reversed = best.reversed;
    std::vector<char> used_a(static_cast<std::size_t>(a.terminal_count), 0);
    std::vector<char> used_b(static_cast<std::size_t>(b.terminal_count), 0);
    int before = -1;
    for (int k = head_; k >= 0; k = entries_[static_cast<std::size_t>(k)].next) {
        const Entry& e = entries_[static_cast<std::size_t>(k)];
        const RingPart& x = a.parts[static_cast<std::size_t>(e.x)];
        const RingPart& y = b.parts[static_cast<std::size_t>(e.y)];
        MatchedPair pair{x.part, y.part, 0.0, 0.0, 0.0, 0.0, 0.0};
        for (std::size_t f = 0; f < kFeatureCount; ++f) pair.features += std::pow(x.weighted[f] - y.weighted[f], 2.0);
        pair.features = std::sqrt(pair.features);
        for (std::size_t s = 0; s < kSignatureSize; ++s) pair.signature += std::pow(x.signature[s] - y.signature[s], 2.0);
        if (before >= 0) {
            const Entry& p = entries_[static_cast<std::size_t>(before)];
            const InterDistance& ia = a.between(static_cast<std::size_t>(p.x), static_cast<std::size_t>(e.x));
            const InterDistance& ib = b.between(static_cast<std::size_t>(p.y), static_cast<std::size_t>(e.y));
            pair.d_e = std::pow(ia.d_e - ib.d_e, 2.0);
            pair.d_be = std::pow(ia.d_be - ib.d_be, 2.0);
            pair.d_a = std::pow(ia.d_a - ib.d_a, 2.0);
        }
        for (int t = 0; t < x.count; ++t) used_a[static_cast<std::size_t>((x.first + t) % a.terminal_count)] = 1;
        for (int t = 0; t < y.count; ++t) used_b[static_cast<std::size_t>((y.first + t) % b.terminal_count)] = 1;
        match.pairs.push_back(pair);
        before = k;
    }
    leave_out(a, used_a, false, match.left_out_a, match.left_out_cost);
    leave_out(b, used_b, best.reversed, match.left_out_b, match.left_out_cost);
    return match;
}

}  // namespace core
