#pragma once
// The index in memory, ready to be searched: every model's two views against one drawing.

#include <string>
#include <vector>

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

    /// rank_models for one drawing.
    [[nodiscard]] std::vector<RankedModel> rank(const core::ComparableShape& query, RankBy by, int jobs,
                                                std::stop_token stop = {}) const;
    /// nearest_models for one drawing.
    [[nodiscard]] std::vector<RankedModel> nearest(const core::ComparableShape& query, std::size_t count, int jobs,
                                                   std::stop_token stop = {}) const;

  private:
    std::vector<CollectionModel> models_;
    std::vector<db::Damage> damaged_;
};

}  // namespace app
