#include "firmware_like_app/collection/collection.hpp"

#include <algorithm>

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
            model.views[v] = core::matchable(model.record.views[v].descriptor, parameters);
        }
    });
    return collection;
}

std::vector<RankedModel> Collection::distances(const core::MatchableShape& query, int jobs,
                                               std::stop_token stop) const {
    std::vector<RankedModel> all(models_.size());
    std::vector<core::Matcher> matchers(static_cast<std::size_t>(std::max(1, jobs)));
    core::parallel_for(models_.size(), std::max(1, jobs), [&](std::size_t i, int worker) {
        all[i].model = i;
        if (stop.stop_requested()) return;
        core::Matcher& matcher = matchers[static_cast<std::size_t>(worker)];
        const double first = matcher.distance(query, models_[i].views[0]);
        const double second = matcher.distance(query, models_[i].views[1], first);
        all[i].view = second < first ? 1 : 0;
        all[i].distance = std::min(first, second);
    });
    return all;
}

std::vector<RankedModel> Collection::rank(const core::MatchableShape& query, int jobs, std::stop_token stop) const {
    std::vector<RankedModel> ranked = distances(query, jobs, stop);
    std::stable_sort(ranked.begin(), ranked.end(),
                     [](const RankedModel& a, const RankedModel& b) { return a.distance < b.distance; });
    return ranked;
}

}  // namespace app
