#pragma once
// The index in memory, ready to be searched: every model's two views against one drawing.

#include <array>
#include <stop_token>
#include <string>
#include <vector>

#include "core/fusion/fused_match.hpp"
#include "db/stores/two_view_index.hpp"

namespace app {

struct CollectionModel {
    db::ModelRecord record;  ///< without display mesh
    std::array<core::ComparableShape, 2> views;
};

struct RankedModel {
    std::size_t model = 0;  ///< index into Collection::models()
    int view = 0;           ///< 0 or 1: the nearer view, the first of equals
    double distance = 0.0;
};

/// Which distance ranks.
enum class Reading {
    Parts,  ///< the parts alone, as the thesis has it
    Fused,  ///< parts and whole contour (core/fusion)
};

class Collection {
  public:
    /// Reads the whole index. FileMissing, NotAnIndex, NewerVersion, Damaged …; damaged models are passed over and
    /// named in damaged().
    [[nodiscard]] static core::Result<Collection> load(const std::string& database,
                                                       const core::ShapeParameters& parameters = {});

    [[nodiscard]] const std::vector<CollectionModel>& models() const { return models_; }
    [[nodiscard]] const std::vector<db::Damage>& damaged() const { return damaged_; }

    /// All models, nearest first, ties by id: drawing and mirror image against both views. The ranks do not depend on
    /// `jobs`. A requested stop gives an unfinished answer soon.
    [[nodiscard]] std::vector<RankedModel> rank(const core::ComparableShape& query, Reading reading, int jobs,
                                                std::stop_token stop = {}) const;

    /// The first `count` of rank(query, Reading::Fused), the same to the last bit, without comparing the parts of
    /// models whose contour alone lies farther: those are about nine in ten.
    [[nodiscard]] std::vector<RankedModel> nearest(const core::ComparableShape& query, std::size_t count, int jobs,
                                                   std::stop_token stop = {}) const;

  private:
    std::vector<CollectionModel> models_;
    std::vector<db::Damage> damaged_;
};

}  // namespace app
