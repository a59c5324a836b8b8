#pragma once
// The index in memory, ready to be searched: every model's two views against one drawing.

#include <optional>
#include <string>
#include <vector>

#include "core/rerank/neighbour_graph.hpp"
#include "firmware_like_app/collection/model_search.hpp"

namespace app {

class Collection {
  public:
    /// Reads the whole index. FileMissing, NotAnIndex, NewerVersion, Damaged …; damaged models are passed over and
    /// named in damaged().
    [[nodiscard]] static core::Result<Collection> load(const std::string& database,
                                                       const core::ShapeParameters& parameters = {});

    [[nodiscard]] const std::vector<CollectionModel>& models() const { return models_; }
    [[nodiscard]] const std::vector<db::Damage>& damaged() const { return damaged_; }
    /// What its user should know, a sentence each: models that were described with other settings than this program's,
    /// or by another version of it, and what is damaged.
    [[nodiscard]] std::vector<std::string> warnings() const;
    /// Who is near to whom (likeness_lists.hpp), by places in models(). Nothing where the index has no such lists, or
    /// those of another distance.
    [[nodiscard]] const std::optional<core::NearestLists>& likeness() const { return likeness_; }

    /// rank_models for one drawing, in all its readings.
    [[nodiscard]] std::vector<RankedModel> rank(std::span<const core::ComparableShape> readings, RankBy by, int jobs,
                                                std::stop_token stop = {}) const;
    /// rank_models_both_ways for one drawing, in all its readings.
    [[nodiscard]] BothRankings rank_both_ways(std::span<const core::ComparableShape> readings, int jobs) const;
    /// nearest_models for one drawing, in all its readings; `likely` as in ModelSearch.
    [[nodiscard]] std::vector<RankedModel> nearest(std::span<const core::ComparableShape> readings, std::size_t count,
                                                   int jobs, std::stop_token stop = {},
                                                   std::span<const std::size_t> likely = {}) const;

  private:
    std::vector<CollectionModel> models_;
    std::vector<db::Damage> damaged_;
    std::optional<std::string> stale_;
    std::optional<core::NearestLists> likeness_;
};

}  // namespace app
