#include "firmware_like_app/collection/collection.hpp"

#include "core/base/parallel.hpp"

namespace app {

core::Result<Collection> Collection::load(const std::string& database, const core::ShapeParameters& parameters) {
    const core::Result<db::TwoViewIndex> index = db::TwoViewIndex::open(database, db::OpenMode::ReadOnly);
    if (!index) return core::unexpected(index.error());
    core::Result<db::LoadedModels> loaded = index->load_views();
    if (!loaded) return core::unexpected(loaded.error());
    Collection collection;
    collection.damaged_ = std::move(loaded->damaged);
    collection.models_.resize(loaded->models.size());
    core::parallel_for(loaded->models.size(), core::core_count(), [&](std::size_t i, int) {
        CollectionModel& model = collection.models_[i];
        model.record = std::move(loaded->models[i]);
        for (std::size_t v = 0; v < 2; ++v) {
            const db::ModelView& view = model.record.views[v];
            model.views[v] = core::comparable(view.descriptor, view.contour, parameters);
        }
    });
    return collection;
}

std::vector<RankedModel> Collection::rank(const core::ComparableShape& query, RankBy by, int jobs,
                                          std::stop_token stop) const {
    return rank_models(models_, {.readings = {&query, 1}, .jobs = jobs, .stop = std::move(stop)}, by);
}

std::vector<RankedModel> Collection::nearest(const core::ComparableShape& query, std::size_t count, int jobs,
                                             std::stop_token stop) const {
    return nearest_models(models_, {.readings = {&query, 1}, .jobs = jobs, .stop = std::move(stop)}, count);
}

}  // namespace app
