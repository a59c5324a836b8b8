#pragma once
// Re-ranking of a whole set: distances between shapes become distances along the collection. Two shapes are near when
// walks that start from them meet, so a rabbit and a crouching rabbit are near when rabbits in between lead from one to
// the other. Nothing is learnt from labels.
//
// After Yang, Prasad and Latecki, "Affinity learning with diffusion on tensor product graph" (2013): A = sum over t of
// S^t (S^t)' for t from 0 to 10, where S are the steps of the neighbour graph. We start from the identity, weaken
// one-sided links (neighbour_graph.hpp), and divide by the root of both walks' chances to meet themselves.

#include <cstddef>
#include <span>
#include <vector>

namespace core {

inline constexpr int kWalkLength = 10;

/// n x n distances in, n x n out, row: query. Symmetric; 0 on the diagonal and >= 0 elsewhere; what no walk leads to
/// comes after everything else, in the order of the distances given. The distances should be symmetric with 0 on the
/// diagonal and not negative. Results do not depend on `jobs`. Memory 3 n x n floats; time about 250 n x n operations.
[[nodiscard]] std::vector<float> reranked_distances(std::span<const float> distances, std::size_t n, int jobs = 1);

}  // namespace core
