#pragma once
// Models ranked by how near they are to what is looked for: all of them, or the nearest few at a fraction of the cost.
// Both give the same order to the last bit, whatever the number of threads.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "core/fusion/fused_match.hpp"
#include "core/rerank/query_rerank.hpp"
#include "db/stores/two_view_index.hpp"

namespace app {

struct CollectionModel {
    db::ModelRecord record;  ///< without display mesh
    std::array<core::ComparableShape, 2> views;
};

struct RankedModel {
    std::size_t model = 0;  ///< index into the models
    int view = 0;           ///< 0 or 1: the nearer view
    double distance = 0.0;
    int reading = 0;  ///< which reading of what is looked for is nearest; of equals the first reading, then view
};

/// Which distance ranks.
enum class RankBy {
    Parts,  ///< the parts alone, as the thesis has it
    Fused,  ///< parts and whole contour (core/fusion)
};

struct ModelSearch {
    /// A drawing, in one or several readings of which the best counts, or a model in its views. At least one.
    std::span<const core::ComparableShape> readings;
    std::optional<std::size_t> except = {};  ///< this model is passed over
    /// Models that are likely near, as indices: those of a search for nearly the same drawing. They are compared first,
    /// which spares the others the better part of their work; the answer is the same whatever they are.
    std::span<const std::size_t> likely = {};
    int jobs = 1;               ///< threads; changes no rank
    std::stop_token stop = {};  ///< once requested, an unfinished answer comes soon
};

/// All models but the one passed over, nearest first, ties by index: each reading and its mirror image against both
/// views.
[[nodiscard]] std::vector<RankedModel> rank_models(std::span<const CollectionModel> models, const ModelSearch& search,
                                                   RankBy by);

struct BothRankings {
    std::vector<RankedModel> by_parts, fused;
};

/// What rank_models gives by either distance, in little more than half the time of asking twice: every contour is
/// compared once and so are the parts. Models and distances alone; views and readings are not told.
[[nodiscard]] BothRankings rank_models_both_ways(std::span<const CollectionModel> models, const ModelSearch& search);

/// The first `count` of rank_models by the fused distance, the same to the last bit. Contours are compared with all
/// models, most of them only until it is known that they are too far; parts with those alone that neither their
/// contours nor the bound of their parts leave behind, one in fifteen.
[[nodiscard]] std::vector<RankedModel> nearest_models(std::span<const CollectionModel> models,
                                                      const ModelSearch& search, std::size_t count);

/// The same models along the collection's own likeness (core/rerank), the first one kept; distances as they were.
/// `ranked` holds all models.
[[nodiscard]] std::vector<RankedModel> reranked(const core::QueryReranker& reranker,
                                                const std::vector<RankedModel>& ranked);

}  // namespace app
