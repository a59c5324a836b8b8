#pragma once
// The distance of two shapes by trying every match, straight from the definition in core/match/match.hpp. Exponential:
// for rings of a few terminals.

#include <cmath>
#include <limits>

#include "core/match/part_ring.hpp"

namespace support {

class ExhaustiveMatch {
  public:
    /// The least cost over all matches, all pairs of stop points and both directions of b.
    static double distance(const core::MatchableShape& a, const core::MatchableShape& b) {
        return std::min(least(a.forwards, b.forwards), least(a.forwards, b.backwards));
    }
    static double least(const core::PartRing& a, const core::PartRing& b) {
        double best = std::numeric_limits<double>::infinity();
        for (const int start_a : a.stop_points) {
            for (const int start_b : b.stop_points) {
                ExhaustiveMatch m{a, b, start_a, start_b};
                m.extend(-1, -1, 0, 0, 0.0, sum_of_norms(a) + sum_of_norms(b));
                best = std::min(best, m.best_);
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

    /// All matches that go on from a last pair (-1: none), whose parts ended before these positions.
    void extend(int last_x, int last_y, int from_a, int from_b, double pairs, double left_out) {
        best_ = std::min(best_, pairs + left_out);
        for (std::size_t x = 0; x < a_.parts.size(); ++x) {
            const int at_a = position(a_, a_.parts[x], start_a_), end_a = at_a + a_.parts[x].count;
            if (at_a < from_a || end_a > a_.terminal_count) continue;
            for (std::size_t y = 0; y < b_.parts.size(); ++y) {
                const int at_b = position(b_, b_.parts[y], start_b_), end_b = at_b + b_.parts[y].count;
                if (at_b < from_b || end_b > b_.terminal_count) continue;
                double cost = node_cost(a_.parts[x], b_.parts[y]);
                if (last_x >= 0) {
                    cost += step_cost(a_.between(static_cast<std::size_t>(last_x), x),
                                      b_.between(static_cast<std::size_t>(last_y), y));
                }
                extend(static_cast<int>(x), static_cast<int>(y), end_a, end_b, pairs + cost,
                       left_out - norms_of(a_, a_.parts[x]) - norms_of(b_, b_.parts[y]));
            }
        }
    }

    const core::PartRing& a_;
    const core::PartRing& b_;
    int start_a_, start_b_;
    double best_ = std::numeric_limits<double>::infinity();
};

}  // namespace support
