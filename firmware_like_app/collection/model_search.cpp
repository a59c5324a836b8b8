#include "firmware_like_app/collection/model_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "core/base/parallel.hpp"

namespace app {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The nearest of all pairs of a reading and a view, by what `distance(reading, view, give_up_at)` gives; the first of
/// equals. No nearer than `limit`: any value that is not below it.
template <typename Distance>
RankedModel nearest_pair(std::size_t model, std::size_t readings, double limit, const Distance& distance) {
    RankedModel nearest{.model = model, .distance = limit};
    for (std::size_t r = 0; r < readings; ++r) {
        for (std::size_t v = 0; v < 2; ++v) {
            const double d = distance(r, v, nearest.distance);
            if (d < nearest.distance) nearest = {model, static_cast<int>(v), d, static_cast<int>(r)};
        }
    }
    return nearest;
}

bool is_nearer(const RankedModel& a, const RankedModel& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.model < b.model;
}

/// The models looked at, in order.
std::vector<std::size_t> models_of(std::size_t count, const ModelSearch& search) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    if (search.except && *search.except < count) all.erase(all.begin() + static_cast<std::ptrdiff_t>(*search.except));
    return all;
}

int threads(const ModelSearch& search) {
    return std::max(1, search.jobs);
}

/// Both least distances over all pairs of a reading and a view, those nearest by their contours first, so that others
/// are given up soon.
struct LeastDistances {
    double parts = kInfinity, fused = kInfinity;
};
LeastDistances least_distances(std::span<const core::ComparableShape> readings, const CollectionModel& model,
                               core::FusedMatcher& matcher) {
    struct Pair {
        double contour = 0.0;
        const core::ComparableShape *drawn = nullptr, *view = nullptr;
    };
    std::vector<Pair> pairs;
    for (const core::ComparableShape& drawn : readings) {
        for (const core::ComparableShape& view : model.views) {
            pairs.push_back({matcher.contour().distance(drawn.contour, view.contour), &drawn, &view});
        }
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.contour < q.contour; });
    LeastDistances least;
    for (const Pair& pair : pairs) {
        // What may still lower one of the two.
        const double give_up_at = std::max(least.parts, core::parts_limit(pair.contour, least.fused));
        const double parts = matcher.parts().distance(pair.drawn->parts, pair.view->parts, give_up_at);
        least.parts = std::min(least.parts, parts);
        least.fused = std::min(least.fused, core::fused_distance(parts, pair.contour));
    }
    return least;
}

/// The nearest models so far, shared by all threads. Which models are compared depends on when others finish; which are
/// the nearest does not.
class NearestSoFar {
  public:
    explicit NearestSoFar(std::size_t count) : count_(count) {}

    /// A model farther than this is none of the nearest.
    [[nodiscard]] double limit() {
        const std::lock_guard lock(mutex_);
        return best_.size() < count_ ? kInfinity : best_.back().distance;
    }
    void offer(const RankedModel& model) {
        const std::lock_guard lock(mutex_);
        best_.insert(std::upper_bound(best_.begin(), best_.end(), model, is_nearer), model);
        if (best_.size() > count_) best_.pop_back();
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] std::vector<RankedModel> take() { return std::move(best_); }

  private:
    std::size_t count_;
    std::mutex mutex_;
    std::vector<RankedModel> best_;  // sorted
};

/// Just above a limit, so that a model as far as it is still compared: ids decide among equals.
double just_above(double limit) {
    return std::nextafter(limit, kInfinity);
}

/// The stages of nearest_models.
class NearestSearch {
  public:
    NearestSearch(std::span<const CollectionModel> models, const ModelSearch& search, std::size_t count)
        : models_(models),
          search_(search),
          matchers_(static_cast<std::size_t>(threads(search))),
          contours_(models.size() * search.readings.size()),
          nearest_contour_(models.size(), kInfinity),
          best_(count) {
        for (const core::ComparableShape& reading : search.readings) bounds_.emplace_back(reading.parts);
    }

    std::vector<RankedModel> run() {
        std::vector<std::size_t> order = models_of(models_.size(), search_);
        std::vector<double> bounds = cheap_bounds(order);
        std::size_t known = 0;
        for (const std::size_t model : search_.likely) {
            if (model >= bounds.size() || std::isinf(bounds[model])) continue;
            bounds[model] = kFirstOfAll;
            ++known;
        }
        sort_by(order, bounds);
        // A few likely ones first: the limit that they give spares most others the better part of their work.
        const std::size_t first = std::min(order.size(), known < best_.count() ? kFirst : known);
        compare(std::span(order).first(first));
        compare(std::span(order).subspan(first));
        return best_.take();
    }

  private:
    static constexpr std::size_t kFirst = 96;  // 32 to 200 do equally well, and so do more stages
    static constexpr double kFirstOfAll = -1.0;

    /// Of the contours' distances, by model.
    std::vector<double> cheap_bounds(const std::vector<std::size_t>& models) const {
        std::vector<double> bounds(models_.size(), kInfinity);
        for (const std::size_t model : models) {
            for (const core::ComparableShape& reading : search_.readings) {
                for (const core::ComparableShape& view : models_[model].views) {
                    bounds[model] = std::min(bounds[model], core::lower_bound(reading.contour, view.contour));
                }
            }
        }
        return bounds;
    }

    static void sort_by(std::span<std::size_t> models, const std::vector<double>& key) {
        std::stable_sort(models.begin(), models.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
    }

    /// The contours of all of these, then the parts of those that are left, likely ones first so that the limit falls
    /// fast.
    void compare(std::span<std::size_t> models) {
        for_all(models, [this](std::size_t model, core::FusedMatcher& matcher) { compare_contours(model, matcher); });
        sort_by(models, nearest_contour_);
        for_all(models, [this](std::size_t model, core::FusedMatcher& matcher) { compare_parts(model, matcher); });
    }

    template <typename Work>
    void for_all(std::span<const std::size_t> models, const Work& work) {
        core::parallel_for(models.size(), threads(search_), [&](std::size_t k, int worker) {
            if (!search_.stop.stop_requested()) work(models[k], matchers_[static_cast<std::size_t>(worker)]);
        });
    }

    /// Of both views with a reading.
    std::array<double, 2>& contours(std::size_t model, std::size_t reading) {
        return contours_[model * search_.readings.size() + reading];
    }

    void compare_contours(std::size_t model, core::FusedMatcher& matcher) {
        const double limit = just_above(best_.limit());
        for (std::size_t r = 0; r < search_.readings.size(); ++r) {
            for (std::size_t v = 0; v < 2; ++v) {
                const double d =
                    matcher.contour().distance(search_.readings[r].contour, models_[model].views[v].contour, limit);
                contours(model, r)[v] = d;
                nearest_contour_[model] = std::min(nearest_contour_[model], d);
            }
        }
    }

    void compare_parts(std::size_t model, core::FusedMatcher& matcher) {
        const double limit = just_above(best_.limit());
        if (nearest_contour_[model] >= limit) return;
        const RankedModel found =
            nearest_pair(model, search_.readings.size(), limit, [&](std::size_t r, std::size_t v, double give_up_at) {
                return matcher.distance_from(contours(model, r)[v], search_.readings[r], bounds_[r],
                                             models_[model].views[v], give_up_at);
            });
        if (found.distance < limit) best_.offer(found);
    }

    std::span<const CollectionModel> models_;
    const ModelSearch& search_;
    std::vector<core::PartsBound> bounds_;         // of the readings
    std::vector<core::FusedMatcher> matchers_;     // of the threads
    std::vector<std::array<double, 2>> contours_;  // by model, then reading; beyond the limit any such value
    std::vector<double> nearest_contour_;          // by model
    NearestSoFar best_;
};

}  // namespace

std::vector<RankedModel> rank_models(std::span<const CollectionModel> models, const ModelSearch& search, RankBy by) {
    const std::vector<std::size_t> all = models_of(models.size(), search);
    std::vector<RankedModel> ranked(all.size());
    std::vector<core::FusedMatcher> matchers(static_cast<std::size_t>(threads(search)));
    core::parallel_for(all.size(), threads(search), [&](std::size_t k, int worker) {
        ranked[k].model = all[k];
        if (search.stop.stop_requested()) return;
        core::FusedMatcher& matcher = matchers[static_cast<std::size_t>(worker)];
        ranked[k] = nearest_pair(
            all[k], search.readings.size(), kInfinity, [&](std::size_t r, std::size_t v, double give_up_at) {
                const core::ComparableShape& drawn = search.readings[r];
                const core::ComparableShape& view = models[all[k]].views[v];
                return by == RankBy::Parts ? matcher.parts().distance(drawn.parts, view.parts, give_up_at)
                                           : matcher.distance(drawn, view, give_up_at);
            });
    });
    std::sort(ranked.begin(), ranked.end(), is_nearer);
    return ranked;
}

BothRankings rank_models_both_ways(std::span<const CollectionModel> models, const ModelSearch& search) {
    const std::vector<std::size_t> all = models_of(models.size(), search);
    BothRankings out{std::vector<RankedModel>(all.size()), std::vector<RankedModel>(all.size())};
    std::vector<core::FusedMatcher> matchers(static_cast<std::size_t>(threads(search)));
    core::parallel_for(all.size(), threads(search), [&](std::size_t k, int worker) {
        out.by_parts[k].model = out.fused[k].model = all[k];
        if (search.stop.stop_requested()) return;
        const LeastDistances least =
            least_distances(search.readings, models[all[k]], matchers[static_cast<std::size_t>(worker)]);
        out.by_parts[k].distance = least.parts;
        out.fused[k].distance = least.fused;
    });
    std::sort(out.by_parts.begin(), out.by_parts.end(), is_nearer);
    std::sort(out.fused.begin(), out.fused.end(), is_nearer);
    return out;
}

std::vector<RankedModel> reranked(const core::QueryReranker& reranker, const std::vector<RankedModel>& ranked) {
    std::vector<float> distances(reranker.size());
    std::vector<std::size_t> place(reranker.size());
    for (std::size_t k = 0; k < ranked.size(); ++k) {
        distances[ranked[k].model] = static_cast<float>(ranked[k].distance);
        place[ranked[k].model] = k;
    }
    std::vector<RankedModel> out;
    for (const std::int32_t model : reranker.order(distances)) {
        out.push_back(ranked[place[static_cast<std::size_t>(model)]]);
    }
    return out;
}

std::vector<RankedModel> nearest_models(std::span<const CollectionModel> models, const ModelSearch& search,
                                        std::size_t count) {
    if (count == 0) return {};
    return NearestSearch(models, search, count).run();
}

}  // namespace app
