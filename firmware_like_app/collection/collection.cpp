#include "firmware_like_app/collection/collection.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <numeric>

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

namespace {

/// The nearer of two views by what `distance(view, give_up_at)` gives; the first of equals.
template <typename Distance>
RankedModel nearer_view(std::size_t model, const Distance& distance) {
    const double first = distance(0, std::numeric_limits<double>::infinity());
    const double second = distance(1, first);
    return {model, second < first ? 1 : 0, std::min(first, second)};
}

void sort_by_distance(std::vector<RankedModel>& ranked) {
    std::sort(ranked.begin(), ranked.end(), [](const RankedModel& a, const RankedModel& b) {
        return a.distance != b.distance ? a.distance < b.distance : a.model < b.model;
    });
}

std::size_t threads(int jobs) {
    return static_cast<std::size_t>(std::max(1, jobs));
}

/// The nearest models so far, shared by all threads. Which models are compared depends on when others finish; which are
/// the nearest does not.
class NearestSoFar {
  public:
    explicit NearestSoFar(std::size_t count) : count_(count) {}

    /// A model farther than this is none of the nearest.
    [[nodiscard]] double limit() {
        const std::lock_guard lock(mutex_);
        return best_.size() < count_ ? std::numeric_limits<double>::infinity() : best_.back().distance;
    }
    void offer(const RankedModel& model) {
        const std::lock_guard lock(mutex_);
        best_.push_back(model);
        sort_by_distance(best_);
        if (best_.size() > count_) best_.pop_back();
    }
    [[nodiscard]] std::vector<RankedModel> take() { return std::move(best_); }

  private:
    std::size_t count_;
    std::mutex mutex_;
    std::vector<RankedModel> best_;  // sorted
};

/// Just above a limit, so that a model as far as it is still compared: ids decide among equals.
double just_above(double limit) {
    return std::nextafter(limit, std::numeric_limits<double>::infinity());
}

}  // namespace

std::vector<RankedModel> Collection::rank(const core::ComparableShape& query, Reading reading, int jobs,
                                          std::stop_token stop) const {
    std::vector<RankedModel> ranked(models_.size());
    std::vector<core::FusedMatcher> matchers(threads(jobs));
    core::parallel_for(models_.size(), std::max(1, jobs), [&](std::size_t i, int worker) {
        ranked[i].model = i;
        if (stop.stop_requested()) return;
        core::FusedMatcher& matcher = matchers[static_cast<std::size_t>(worker)];
        ranked[i] = nearer_view(i, [&](std::size_t v, double give_up_at) {
            const core::ComparableShape& view = models_[i].views[v];
            return reading == Reading::Parts ? matcher.parts().distance(query.parts, view.parts, give_up_at)
                                             : matcher.distance(query, view, give_up_at);
        });
    });
    sort_by_distance(ranked);
    return ranked;
}

std::vector<RankedModel> Collection::nearest(const core::ComparableShape& query, std::size_t count, int jobs,
                                             std::stop_token stop) const {
    std::vector<std::array<double, 2>> contours(models_.size());
    std::vector<core::FusedMatcher> matchers(threads(jobs));
    core::parallel_for(models_.size(), std::max(1, jobs), [&](std::size_t i, int worker) {
        if (stop.stop_requested()) return;
        for (std::size_t v = 0; v < 2; ++v) {
            contours[i][v] = matchers[static_cast<std::size_t>(worker)].contour().distance(query.contour,
                                                                                           models_[i].views[v].contour);
        }
    });
    // Likely ones first, so that the limit falls fast.
    std::vector<std::size_t> order(models_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto nearer = [&](std::size_t i) { return std::min(contours[i][0], contours[i][1]); };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return nearer(a) < nearer(b); });
    NearestSoFar best(count);
    const core::PartsBound bound(query.parts);
    core::parallel_for(order.size(), std::max(1, jobs), [&](std::size_t k, int worker) {
        const std::size_t i = order[k];
        const double limit = just_above(best.limit());
        if (nearer(i) >= limit || stop.stop_requested()) return;
        core::FusedMatcher& matcher = matchers[static_cast<std::size_t>(worker)];
        const RankedModel found = nearer_view(i, [&](std::size_t v, double give_up_at) {
            return matcher.distance_from(contours[i][v], query, bound, models_[i].views[v],
                                         std::min(give_up_at, limit));
        });
        if (found.distance < limit) best.offer(found);
    });
    return best.take();
}

}  // namespace app
