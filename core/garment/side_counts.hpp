#pragma once
// How many edges each side of a region has, and the distances of a star that fills it.

#include <array>
#include <optional>

namespace core {

/// Sides in order around the region. Between the steps of a plan a side may have 0 edges: its two corners are one.
struct SideCounts {
    static constexpr int kMost = 24;  ///< sides; room for those that a plan adds to the 8 of a region

    int n = 0;
    std::array<int, kMost> edges{};

    /// Any index: sides are counted around.
    [[nodiscard]] int operator[](int side) const { return edges[static_cast<std::size_t>((side % n + n) % n)]; }
    void push_back(int count) { edges[static_cast<std::size_t>(n++)] = count; }
    [[nodiscard]] int total() const {
        int sum = 0;
        for (int i = 0; i < n; ++i) sum += edges[static_cast<std::size_t>(i)];
        return sum;
    }
};

/// The distances d_i, in edges, from the one irregular vertex of a star to each side, for 3 or 5 sides: the solution of
/// l_i = d_{i-1} + d_{i+1}. Nothing where it is negative or not whole. (Thesis 3.2.1; the positive and the negative sum
/// of the printed formula together run over n terms.)
[[nodiscard]] std::optional<SideCounts> star_distances(const SideCounts& sides);

}  // namespace core
