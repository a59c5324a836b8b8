#pragma once
// Which models of an index are near to which: the neighbour lists that re-ranking walks along (core/rerank), measured
// once when models are added.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "core/rerank/neighbour_graph.hpp"
#include "db/stores/two_view_index.hpp"
#include "firmware_like_app/collection/model_search.hpp"

namespace app {

/// The distance of two models: the least of the contours of their views. Lists measured by another one, or by another
/// version of the program, are measured again.
[[nodiscard]] std::string likeness_measure();

struct LikenessReport {
    int measured = 0;  ///< models that got a list, or a new one
    bool interrupted = false;
};

/// Gives every model that has no full list one, and enters it into those of the others. A model's list is measured
/// against all models and stored together with those that it changed, so whatever is stored is right whenever this is
/// stopped or killed, and a later call goes on. The lists do not depend on `jobs`. A pair of models takes four contour
/// distances: 1,254 new models are 0.8 million pairs, one new one 1,253. `stop` is looked at for each model.
[[nodiscard]] core::Result<LikenessReport> update_likeness(
    db::TwoViewIndex& index, int jobs, const std::stop_token& stop,
    const std::function<void(std::size_t done, std::size_t total)>& progress = {});

/// The lists that update_likeness would store for these models, by their places; for an index that has none. Costs as
/// much: 25 s for 1,254 models on one core.
[[nodiscard]] core::NearestLists measured_likeness(
    std::span<const CollectionModel> models, int jobs,
    const std::function<void(std::size_t done, std::size_t total)>& progress = {});

/// Stored lists by the places of their models in `ids`; what they name beside these is left out.
[[nodiscard]] core::NearestLists lists_by_place(const std::vector<db::NeighbourList>& stored,
                                                const std::vector<std::int64_t>& ids);

}  // namespace app
