#pragma once
// Lengths, areas and bending of any arc of a sampled outline in constant time, from running sums.

#include <vector>

#include "core/geometry/point.hpp"

namespace core {

/// Arcs run anti-clockwise from sample `from` to sample `to`, cyclically; from == to is the whole ring.
class ArcMeasures {
  public:
    ArcMeasures() = default;
    /// The ring is anti-clockwise with at least three samples. Linear time.
    explicit ArcMeasures(const Polygon& samples);

    [[nodiscard]] double perimeter() const { return length_.back(); }
    [[nodiscard]] double area() const { return 0.5 * cross_.back(); }
    [[nodiscard]] double bending() const { return bending_.back(); }

    /// Number of edges of the arc.
    [[nodiscard]] int steps(int from, int to) const;
    [[nodiscard]] double length(int from, int to) const;
    /// Area between the arc and its chord; positive where the arc bulges out of the shape.
    [[nodiscard]] double area(int from, int to) const;
    /// Sum of discrete curvature over the samples from `from` to `to`, both included (5.4 item 8): the shape is scaled
    /// by the reciprocal of the greatest distance of a sample to the centroid.
    [[nodiscard]] double bending(int from, int to) const;
    [[nodiscard]] int count() const { return static_cast<int>(samples_.size()); }

  private:
    [[nodiscard]] double span(const std::vector<double>& sums, int from, int to) const;
    Polygon samples_;
    std::vector<double> length_, cross_, bending_;  // entry i: sum over the edges (samples) before i; count + 1 entries
};

}  // namespace core
