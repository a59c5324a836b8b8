#include "firmware_like_app/collection/collection.hpp"

#include "core/base/parallel.hpp"
#include "firmware_like_app/collection/likeness_lists.hpp"
#include "firmware_like_app/collection/model_views.hpp"

namespace app {

namespace {

/// Made ready for matching. Copied once more, since what was filled item by item has room for more, and a copy has not:
/// a quarter of the memory.
void make_comparable(const db::ModelView& view, const core::ShapeParameters& parameters, core::ComparableShape& out) {
    const core::ComparableShape shape = core::comparable(view.descriptor, view.contour, parameters);
    out = shape;
}

core::Result<std::optional<core::NearestLists>> likeness_of(const db::TwoViewIndex& index,
                                                            const std::vector<CollectionModel>& models) {
    const core::Result<std::optional<std::string>> measure = index.likeness_measure();
    if (!measure) return core::unexpected(measure.error());
    if (*measure != likeness_measure()) return std::optional<core::NearestLists>();
    const core::Result<std::vector<db::NeighbourList>> lists = index.neighbour_lists();
    if (!lists) return core::unexpected(lists.error());
    std::vector<std::int64_t> ids;
    for (const CollectionModel& model : models) ids.push_back(model.record.id);
    return std::optional<core::NearestLists>(lists_by_place(*lists, ids));
}

}  // namespace

core::Result<Collection> Collection::load(const std::string& database, const core::ShapeParameters& parameters) {
    ViewParameters described_with;
    described_with.shape = parameters;
    const core::Result<db::TwoViewIndex> index =
        db::TwoViewIndex::open(database, db::OpenMode::ReadOnly, {.parameters = parameters_text(described_with)});
    if (!index) return core::unexpected(index.error());
    core::Result<db::LoadedModels> loaded = index->load_views(core::core_count());
    if (!loaded) return core::unexpected(loaded.error());
    core::Result<std::optional<std::string>> stale = index->stale();
    if (!stale) return core::unexpected(stale.error());
    Collection collection;
    collection.stale_ = std::move(*stale);
    collection.damaged_ = std::move(loaded->damaged);
    collection.models_.resize(loaded->models.size());
    core::parallel_for(loaded->models.size(), core::core_count(), [&](std::size_t i, int) {
        CollectionModel& model = collection.models_[i];
        model.record = std::move(loaded->models[i]);
        for (std::size_t v = 0; v < 2; ++v) make_comparable(model.record.views[v], parameters, model.views[v]);
    });
    core::Result<std::optional<core::NearestLists>> likeness = likeness_of(*index, collection.models_);
    if (!likeness) return core::unexpected(likeness.error());
    collection.likeness_ = std::move(*likeness);
    return collection;
}

std::vector<std::string> Collection::warnings() const {
    std::vector<std::string> sentences;
    if (stale_) sentences.push_back(*stale_);
    for (const db::Damage& damage : damaged_) sentences.push_back(damage.sentence());
    return sentences;
}

std::vector<RankedModel> Collection::rank(std::span<const core::ComparableShape> readings, RankBy by, int jobs,
                                          std::stop_token stop) const {
    return rank_models(models_, {.readings = readings, .jobs = jobs, .stop = std::move(stop)}, by);
}

BothRankings Collection::rank_both_ways(std::span<const core::ComparableShape> readings, int jobs) const {
    return rank_models_both_ways(models_, {.readings = readings, .jobs = jobs});
}

std::vector<RankedModel> Collection::nearest(std::span<const core::ComparableShape> readings, std::size_t count,
                                             int jobs, std::stop_token stop,
                                             std::span<const std::size_t> likely) const {
    return nearest_models(models_, {.readings = readings, .likely = likely, .jobs = jobs, .stop = std::move(stop)},
                          count);
}

}  // namespace app
