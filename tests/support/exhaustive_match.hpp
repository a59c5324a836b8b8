#pragma once
// The distance of two shapes by trying every match, straight from the definitions in core/match/decision_matrix.hpp and
// match.hpp. Exponential: for rings of a few terminals.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/match/match.hpp"

namespace support {

class ExhaustiveMatch {
  public:
    struct Least {
        double part_cost = std::numeric_limits<double>::infinity();  ///< over all configurations
        double distance = std::numeric_limits<double>::infinity();   ///< with the outlines, if ties fall well …
        double at_most = std::numeric_limits<double>::infinity();    ///< … and if they fall badly
    };
    /// Over all matches, all pairs of stop points and both directions of b.
    static Least least(const core::MatchableShape& a, const core::MatchableShape& b) {
        if (!core::in_order(a.forwards, b.forwards)) return least(b, a);
        const Least there = least(a.forwards, b.forwards), back = least(a.forwards, b.backwards);
        return {std::min(there.part_cost, back.part_cost), std::min(there.distance, back.distance),
                std::min(there.at_most, back.at_most)};
    }
    static Least least(const core::PartRing& a, const core::PartRing& b) {
        Least best;
        const double norms = sum_of_norms(a) + sum_of_norms(b);
        for (const int start_a : a.stop_points) {
            for (const int start_b : b.stop_points) {
                ExhaustiveMatch m{a, b, start_a, start_b};
                m.extend(0, 0, 0.0, norms);
                best.part_cost = std::min(best.part_cost, m.best_);
                const auto [least, most] = m.outline_differences();
                const auto parts = static_cast<float>(m.best_ / std::sqrt(norms));
                best.distance = std::min(best.distance, double{core::configuration_distance(parts, least)});
                best.at_most = std::min(best.at_most, double{core::configuration_distance(parts, most)});
            }
        }
        return best;
    }
    static double node_cost(const core::RingPart& x, const core::RingPart& y) {
        double features = 0.0, signature = 0.0;
        for (std::size_t i = 0; i < core::kFeatureCount; ++i) features += square(x.weighted[i] - y.weighted[i]);
        for (std::size_t i = 0; i < core::kSignatureSize; ++i) signature += square(x.signature[i] - y.signature[i]);
        return std::sqrt(features) + signature;
    }
    static double step_cost(const core::InterDistance& x, const core::InterDistance& y) {
        return square(x.d_e - y.d_e) + square(x.d_be - y.d_be) + square(x.d_a - y.d_a);
    }

  private:
    using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

    ExhaustiveMatch(const core::PartRing& a, const core::PartRing& b, int start_a, int start_b)
        : a_(a), b_(b), start_a_(start_a), start_b_(start_b) {}

    static double square(double v) { return v * v; }
    static double sum_of_norms(const core::PartRing& ring) {
        double sum = 0.0;
        for (int t = 0; t < ring.terminal_count; ++t) sum += ring.terminal_norm[static_cast<std::size_t>(t)];
        return sum;
    }
    /// Position of the part's first terminal in the ring cut open before `start`.
    static int position(const core::PartRing& ring, const core::RingPart& part, int start) {
        return (part.first - start + ring.terminal_count) % ring.terminal_count;
    }
    static double norms_of(const core::PartRing& ring, const core::RingPart& part) {
        double sum = 0.0;
        for (int k = 0; k < part.count; ++k) {
            sum += ring.terminal_norm[static_cast<std::size_t>((part.first + k) % ring.terminal_count)];
        }
        return sum;
    }

    /// The least and the greatest along matches of the least cost.
    std::pair<float, float> outline_differences() const {
        std::pair<float, float> range{std::numeric_limits<float>::infinity(), 0.0F};
        for (const auto& [cost, pairs] : good_) {
            if (cost > best_ + kTie) continue;
            const float difference = outline_difference(pairs);
            range = {std::min(range.first, difference), std::max(range.second, difference)};
        }
        return range;
    }

    /// From the first place on the outline of a.
    float outline_difference(Pairs pairs) const {
        const auto first = std::min_element(pairs.begin(), pairs.end(), [&](const auto& p, const auto& q) {
            return a_.parts[p.first].from < a_.parts[q.first].from;
        });
        std::rotate(pairs.begin(), first, pairs.end());
        std::vector<core::OutlineAnchor> anchors;
        for (const auto& [x, y] : pairs) {
            anchors.push_back({a_.parts[x].from, b_.parts[y].from});
            anchors.push_back({a_.parts[x].to, b_.parts[y].to});
        }
        return core::aligned_difference(a_.outline, b_.outline, anchors);
    }

    /// All matches that go on from the pairs so far, whose parts ended before these positions.
    void extend(int from_a, int from_b, double pairs, double left_out) {
        const double whole = pairs + left_out;
        if (whole <= best_ + kTie) good_.emplace_back(whole, pairs_);
        best_ = std::min(best_, whole);
        for (std::size_t x = 0; x < a_.parts.size(); ++x) {
            const int at_a = position(a_, a_.parts[x], start_a_), end_a = at_a + a_.parts[x].count;
            if (at_a < from_a || end_a > a_.terminal_count) continue;
            for (std::size_t y = 0; y < b_.parts.size(); ++y) {
                const int at_b = position(b_, b_.parts[y], start_b_), end_b = at_b + b_.parts[y].count;
                if (at_b < from_b || end_b > b_.terminal_count) continue;
                double cost = node_cost(a_.parts[x], b_.parts[y]);
                if (!pairs_.empty()) {
                    cost += step_cost(a_.between(pairs_.back().first, x), b_.between(pairs_.back().second, y));
                }
                pairs_.emplace_back(x, y);
                extend(end_a, end_b, pairs + cost, left_out - norms_of(a_, a_.parts[x]) - norms_of(b_, b_.parts[y]));
                pairs_.pop_back();
            }
        }
    }

    const core::PartRing& a_;
    const core::PartRing& b_;
    int start_a_, start_b_;
    static constexpr double kTie = 2e-3;  // more than single precision tells apart
    Pairs pairs_;
    std::vector<std::pair<double, Pairs>> good_;
    double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace support
