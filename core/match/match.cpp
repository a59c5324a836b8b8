#include "core/match/match.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace core {

void Matcher::fill_node_distances(const PartRing& a, const PartRing& b, std::vector<float>& out) const {
    out.resize(a.parts.size() * b.parts.size());
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        for (std::size_t j = 0; j < b.parts.size(); ++j) {
            out[i * b.parts.size() + j] = core::node_distance(a.parts[i], b.parts[j]);
        }
    }
}

namespace {

/// Bounds are compared with this share of slack, so that rounding never cuts off the best match.
constexpr float kRounding = 1e-5F;

float inter_cost(const InterDistance& a, const InterDistance& b) {
    const float e = a.d_e - b.d_e, be = a.d_be - b.d_be, angle = a.d_a - b.d_a;
    return e * e + be * be + angle * angle;
}

}  // namespace

/// head_bound_[i, j]: the least gain that pairs ending before position i of A and j of B can have if inter-distances cost
/// nothing, so never above the true one. Returns the bound of the whole configuration.
float Matcher::fill_heads(const PartRing& a, const PartRing& b, const Configuration& c) {
    const OpenedRing& oa = a.opened[static_cast<std::size_t>(c.open_a)];
    const OpenedRing& ob = b.opened[static_cast<std::size_t>(c.open_b)];
    const std::vector<float>& nodes = c.reversed ? node_distance_reversed_ : node_distance_;
    const auto n = static_cast<std::size_t>(a.terminal_count), m = static_cast<std::size_t>(b.terminal_count);
    const std::size_t row = m + 1;
    head_bound_.assign((n + 1) * row, 0.0F);
    for (std::size_t i = 0; i <= n; ++i) {
        for (std::size_t j = 0; j <= m; ++j) {
            float& here = head_bound_[i * row + j];
            if (i > 0) here = std::min(here, head_bound_[(i - 1) * row + j]);
            if (j > 0) here = std::min(here, head_bound_[i * row + j - 1]);
            if (i == n || j == m) continue;
            for (int mx = oa.starts_at[i]; mx < oa.starts_at[i + 1]; ++mx) {
                const auto [x, xe] = oa.members[static_cast<std::size_t>(mx)];
                const float spared_a = oa.norms_from[i] - oa.norms_from[static_cast<std::size_t>(xe)];
                const float* row_of_x = &nodes[static_cast<std::size_t>(x) * b.parts.size()];
                float* ends = &head_bound_[static_cast<std::size_t>(xe) * row];
                for (int my = ob.starts_at[j]; my < ob.starts_at[j + 1]; ++my) {
                    const auto [y, ye] = ob.members[static_cast<std::size_t>(my)];
                    const float spared_b = ob.norms_from[j] - ob.norms_from[static_cast<std::size_t>(ye)];
                    float& end = ends[ye];
                    end = std::min(end, here + (row_of_x[y] - spared_a - spared_b));
                }
            }
        }
    }
    return oa.norms_from[0] + ob.norms_from[0] + head_bound_[n * row + m];
}

/// The best continuation of an entry whose parts end before these positions; inter-distances only add, so rows and cells whose
/// least gain is no better than what is found already are passed over.
void Matcher::continue_best(Entry& entry, const PartRing& a, const PartRing& b, int from_a, int from_b) const {
    const std::size_t row = static_cast<std::size_t>(b.terminal_count) + 1;
    const InterDistance* inter_a = &a.inter[static_cast<std::size_t>(entry.x) * a.parts.size()];
    const InterDistance* inter_b = &b.inter[static_cast<std::size_t>(entry.y) * b.parts.size()];
    for (int i = from_a; i < a.terminal_count; ++i) {
        const std::size_t base = static_cast<std::size_t>(i) * row;
        if (tail_[base + static_cast<std::size_t>(from_b)] >= entry.gain) return;
        for (int j = from_b; j < b.terminal_count; ++j) {
            if (tail_[base + static_cast<std::size_t>(j)] >= entry.gain) break;
            const Cell& cell = cells_[base + static_cast<std::size_t>(j)];
            if (cell.least >= entry.gain) continue;
            for (int k = cell.begin; k < cell.end; ++k) {
                const Entry& next = entries_[static_cast<std::size_t>(k)];
                if (next.gain >= entry.gain) continue;
                const float gain = next.gain + inter_cost(inter_a[next.x], inter_b[next.y]);
                if (gain < entry.gain) {
                    entry.gain = gain;
                    entry.next = k;
                }
            }
        }
    }
}

/// One configuration, exactly, unless its cost is not below `give_up_at`: then anything not below that comes back. Cells are
/// filled from the ends of both rings backwards, so all that may follow an entry is there before it. Entries that do not
/// beat leaving out are dropped, and those that cannot be part of a match below `give_up_at`, by head_bound_.
float Matcher::solve(const PartRing& a, const PartRing& b, const Configuration& c, float give_up_at) {
    const OpenedRing& oa = a.opened[static_cast<std::size_t>(c.open_a)];
    const OpenedRing& ob = b.opened[static_cast<std::size_t>(c.open_b)];
    const std::vector<float>& nodes = c.reversed ? node_distance_reversed_ : node_distance_;
    const auto n = static_cast<std::size_t>(a.terminal_count), m = static_cast<std::size_t>(b.terminal_count);
    const std::size_t row = m + 1;
    const float all = oa.norms_from[0] + ob.norms_from[0];
    const float useless = give_up_at - all + kRounding * all;
    tail_.assign((n + 1) * row, 0.0F);
    cells_.assign((n + 1) * row, Cell{});
    entries_.clear();
    head_ = -1;
    float best = 0.0F;
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = m; j-- > 0;) {
            Cell& cell = cells_[i * row + j];
            cell.begin = static_cast<int>(entries_.size());
            const float before = head_bound_[i * row + j];
            for (int mx = oa.starts_at[i]; mx < oa.starts_at[i + 1]; ++mx) {
                const auto [x, xe] = oa.members[static_cast<std::size_t>(mx)];
                const float spared_a = oa.norms_from[i] - oa.norms_from[static_cast<std::size_t>(xe)];
                const float* row_of_x = &nodes[static_cast<std::size_t>(x) * b.parts.size()];
                for (int my = ob.starts_at[j]; my < ob.starts_at[j + 1]; ++my) {
                    const auto [y, ye] = ob.members[static_cast<std::size_t>(my)];
                    const float spared_b = ob.norms_from[j] - ob.norms_from[static_cast<std::size_t>(ye)];
                    const float own = row_of_x[y] - spared_a - spared_b;
                    const float after = tail_[static_cast<std::size_t>(xe) * row + static_cast<std::size_t>(ye)];
                    if (own + after >= 0.0F || before + own + after >= useless) continue;
                    Entry entry{0.0F, -1, x, y};
                    continue_best(entry, a, b, xe, ye);
                    entry.gain = own + entry.gain;
                    if (entry.gain >= 0.0F || before + entry.gain >= useless) continue;
                    if (entry.gain < best) {
                        best = entry.gain;
                        head_ = static_cast<int>(entries_.size());
                    }
                    cell.least = std::min(cell.least, entry.gain);
                    entries_.push_back(entry);
                }
            }
            cell.end = static_cast<int>(entries_.size());
            tail_[i * row + j] = std::min({tail_[(i + 1) * row + j], tail_[i * row + j + 1], cell.least});
        }
    }
    return all + best;
}

void Matcher::add_configurations(const PartRing& a, const PartRing& b, bool reversed) {
    for (std::size_t i = 0; i < a.opened.size(); ++i) {
        for (std::size_t j = 0; j < b.opened.size(); ++j) {
            Configuration c{0.0F, static_cast<int>(i), static_cast<int>(j), reversed};
            c.bound = fill_heads(a, b, c);
            configurations_.push_back(c);
        }
    }
}

/// Most promising configurations first; the rest mostly fall to their bound. Between equal costs the first configuration wins.
Matcher::Best Matcher::best_of_configurations(const PartRing& a, const PartRing& forwards, const PartRing& backwards) {
    std::stable_sort(configurations_.begin(), configurations_.end(),
                     [](const Configuration& p, const Configuration& q) { return p.bound < q.bound; });
    Best best{std::numeric_limits<float>::infinity(), {}};
    for (const Configuration& c : configurations_) {
        if (c.bound >= best.cost) break;
        const PartRing& b = c.reversed ? backwards : forwards;
        fill_heads(a, b, c);
        const float cost = solve(a, b, c, best.cost);
        if (cost < best.cost) best = {cost, c};
    }
    return best;
}

double Matcher::distance(const MatchableShape& a, const MatchableShape& b) {
    fill_node_distances(a.forwards, b.forwards, node_distance_);
    fill_node_distances(a.forwards, b.backwards, node_distance_reversed_);
    configurations_.clear();
    add_configurations(a.forwards, b.forwards, false);
    add_configurations(a.forwards, b.backwards, true);
    return std::max(0.0F, best_of_configurations(a.forwards, b.forwards, b.backwards).cost);
}

double Matcher::asymmetry(const MatchableShape& shape) {
    fill_node_distances(shape.forwards, shape.backwards, node_distance_reversed_);
    configurations_.clear();
    add_configurations(shape.forwards, shape.backwards, true);
    return std::max(0.0F, best_of_configurations(shape.forwards, shape.forwards, shape.backwards).cost);
}

Match Matcher::match(const MatchableShape& a, const MatchableShape& b) {
    fill_node_distances(a.forwards, b.forwards, node_distance_);
    fill_node_distances(a.forwards, b.backwards, node_distance_reversed_);
    configurations_.clear();
    add_configurations(a.forwards, b.forwards, false);
    add_configurations(a.forwards, b.backwards, true);
    const Best best = best_of_configurations(a.forwards, b.forwards, b.backwards);
    return explain(a.forwards, best.configuration.reversed ? b.backwards : b.forwards, best);
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

Match Matcher::explain(const PartRing& a, const PartRing& b, const Best& best) {
    fill_heads(a, b, best.configuration);
    Match match;
    match.distance = std::max(0.0F, solve(a, b, best.configuration, std::numeric_limits<float>::infinity()));
    match.reversed = best.configuration.reversed;
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
    leave_out(b, used_b, match.reversed, match.left_out_b, match.left_out_cost);
    return match;
}

}  // namespace core
