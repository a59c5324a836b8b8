#include "firmware_like_app/collection/likeness_lists.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <unordered_map>

#include "core/base/parallel.hpp"
#include "core/contour/contour_match.hpp"

namespace app {

namespace {

constexpr std::size_t kBatch = 32;  // models whose lists are stored together
constexpr float kInfinity = std::numeric_limits<float>::infinity();

bool is_nearer(const core::Neighbour& a, const core::Neighbour& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.item < b.item;
}

/// The contours of both views of each model, in the order of ids.
struct Contours {
    std::vector<std::int64_t> ids;
    std::vector<std::array<core::MatchableContour, 2>> views;
};

core::Result<Contours> load_contours(const db::TwoViewIndex& index, int jobs) {
    const core::Result<db::LoadedModels> loaded = index.load_views(jobs);
    if (!loaded) return core::unexpected(loaded.error());
    Contours contours;
    for (const db::ModelRecord& model : loaded->models) {
        contours.ids.push_back(model.id);
        contours.views.push_back({core::matchable(model.views[0].contour), core::matchable(model.views[1].contour)});
    }
    return contours;
}

/// Takes lists that are right, by their places.
using KeepLists = std::function<core::Result<void>(const std::vector<std::size_t>& places, const core::NearestLists&)>;

class LikenessUpdate {
  public:
    LikenessUpdate(const Contours& models, core::NearestLists lists, int jobs, std::stop_token stop, KeepLists keep)
        : models_(models),
          lists_(std::move(lists)),
          full_(std::min(core::kNearestCount, models.ids.size() - 1)),
          measured_(models.ids.size()),
          matchers_(static_cast<std::size_t>(std::max(1, jobs))),
          stop_(std::move(stop)),
          keep_(std::move(keep)) {
        for (std::size_t i = 0; i < models_.ids.size(); ++i) {
            if (lists_[i].size() < full_) open_.push_back(i);
        }
        // Lists that are short may be so because a model is gone from their middle.
        for (const std::size_t i : open_) lists_[i].clear();
    }

    core::Result<LikenessReport> run(const std::function<void(std::size_t, std::size_t)>& progress) {
        LikenessReport report;
        for (std::size_t first = 0; first < open_.size(); first += kBatch) {
            const std::span<const std::size_t> batch =
                std::span(open_).subspan(first, std::min(kBatch, open_.size() - first));
            measure(batch);
            if (stop_.stop_requested()) {
                report.interrupted = true;
                return report;
            }
            if (const core::Result<void> done = keep(batch); !done) return core::unexpected(done.error());
            report.measured += static_cast<int>(batch.size());
            if (progress) progress(first + batch.size(), open_.size());
        }
        return report;
    }

    [[nodiscard]] core::NearestLists take_lists() { return std::move(lists_); }

  private:
    /// Distances of the batch's models to all others, but for pairs that were measured before, then into the lists of
    /// both.
    void measure(std::span<const std::size_t> batch) {
        std::vector<std::vector<float>> rows(batch.size());
        core::parallel_for(batch.size(), static_cast<int>(matchers_.size()), [&](std::size_t k, int worker) {
            if (stop_.stop_requested()) return;
            rows[k] = distances(batch[k], matchers_[static_cast<std::size_t>(worker)]);
        });
        if (stop_.stop_requested()) return;
        for (std::size_t k = 0; k < batch.size(); ++k) {
            const std::size_t i = batch[k];
            for (std::size_t j = 0; j < models_.ids.size(); ++j) {
                if (j == i || measured_[j] != 0) continue;
                offer(i, j, rows[k][j]);
                offer(j, i, rows[k][j]);
            }
            measured_[i] = 1;
        }
    }

    /// Of one model to all that were not measured when its batch began; infinite for others, and for those of which
    /// neither list has room.
    std::vector<float> distances(std::size_t i, core::ContourMatcher& matcher) const {
        std::vector<float> row(models_.ids.size(), kInfinity);
        for (std::size_t j = 0; j < models_.ids.size(); ++j) {
            if (j == i || measured_[j] != 0) continue;
            double least = static_cast<double>(std::max(reach(i), reach(j)));
            bool nearer = false;
            for (const core::MatchableContour& a : models_.views[i]) {
                for (const core::MatchableContour& b : models_.views[j]) {
                    const double d = matcher.distance(a, b, least);
                    if (d >= least) continue;
                    least = d;
                    nearer = true;
                }
            }
            if (nearer) row[j] = static_cast<float>(least);
        }
        return row;
    }

    /// Just above what still gets into a list.
    [[nodiscard]] float reach(std::size_t i) const {
        return lists_[i].size() < full_ ? kInfinity : std::nextafter(lists_[i].back().distance, kInfinity);
    }

    void offer(std::size_t to, std::size_t model, float distance) {
        std::vector<core::Neighbour>& list = lists_[to];
        const core::Neighbour neighbour{static_cast<std::int32_t>(model), distance};
        if (distance == kInfinity || (list.size() == full_ && !is_nearer(neighbour, list.back()))) return;
        const auto same = [&](const core::Neighbour& other) { return other.item == neighbour.item; };
        if (std::any_of(list.begin(), list.end(), same)) return;  // its own list was lost, not its place in this one
        list.insert(std::upper_bound(list.begin(), list.end(), neighbour, is_nearer), neighbour);
        if (list.size() > full_) list.pop_back();
        if (changed_.empty() || changed_.back() != to) changed_.push_back(to);
    }

    /// The batch, and lists of others that it changed. Those that wait for their own batch are not complete yet.
    core::Result<void> keep(std::span<const std::size_t> batch) {
        std::vector<std::size_t> due(batch.begin(), batch.end());
        for (const std::size_t i : changed_) {
            if (measured_[i] != 0 || !std::binary_search(open_.begin(), open_.end(), i)) due.push_back(i);
        }
        changed_.clear();
        std::sort(due.begin(), due.end());
        due.erase(std::unique(due.begin(), due.end()), due.end());
        return keep_(due, lists_);
    }

    const Contours& models_;
    core::NearestLists lists_;
    std::size_t full_;
    std::vector<char> measured_;        // in this run, against all others
    std::vector<std::size_t> open_;     // models without a full list, ascending
    std::vector<std::size_t> changed_;  // lists to be stored; a model may be named several times
    std::vector<core::ContourMatcher> matchers_;
    std::stop_token stop_;
    KeepLists keep_;
};

core::Result<void> store(db::TwoViewIndex& index, const std::vector<std::int64_t>& ids,
                         const std::vector<std::size_t>& places, const core::NearestLists& lists) {
    std::vector<db::NeighbourList> stored;
    for (const std::size_t i : places) {
        stored.push_back({ids[i], {}});
        for (const core::Neighbour& n : lists[i]) {
            stored.back().nearest.push_back({ids[static_cast<std::size_t>(n.item)], n.distance});
        }
    }
    return index.store_neighbours(stored);
}

}  // namespace

std::string likeness_measure() {
    return "least contour distance of two views; the nearest " + std::to_string(core::kNearestCount) + "; " +
           CROQUIS_VERSION;
}

core::NearestLists lists_by_place(const std::vector<db::NeighbourList>& stored, const std::vector<std::int64_t>& ids) {
    std::unordered_map<std::int64_t, std::int32_t> place;
    for (std::size_t i = 0; i < ids.size(); ++i) place.emplace(ids[i], static_cast<std::int32_t>(i));
    core::NearestLists lists(ids.size());
    for (const db::NeighbourList& list : stored) {
        const auto own = place.find(list.model_id);
        if (own == place.end()) continue;
        for (const db::StoredNeighbour& neighbour : list.nearest) {
            if (const auto other = place.find(neighbour.id); other != place.end()) {
                lists[static_cast<std::size_t>(own->second)].push_back({other->second, neighbour.distance});
            }
        }
    }
    return lists;
}

core::Result<LikenessReport> update_likeness(db::TwoViewIndex& index, int jobs, const std::stop_token& stop,
                                             const std::function<void(std::size_t, std::size_t)>& progress) {
    if (const core::Result<void> kept = index.keep_likeness(likeness_measure()); !kept) {
        return core::unexpected(kept.error());
    }
    const core::Result<Contours> models = load_contours(index, std::max(1, jobs));
    if (!models) return core::unexpected(models.error());
    if (models->ids.empty()) return LikenessReport{};
    const core::Result<std::vector<db::NeighbourList>> stored = index.neighbour_lists();
    if (!stored) return core::unexpected(stored.error());
    const KeepLists keep = [&](const std::vector<std::size_t>& places, const core::NearestLists& lists) {
        return store(index, models->ids, places, lists);
    };
    return LikenessUpdate(*models, lists_by_place(*stored, models->ids), jobs, stop, keep).run(progress);
}

core::NearestLists measured_likeness(std::span<const CollectionModel> models, int jobs,
                                     const std::function<void(std::size_t done, std::size_t total)>& progress) {
    if (models.empty()) return {};
    Contours contours;
    for (const CollectionModel& model : models) {
        contours.ids.push_back(model.record.id);
        contours.views.push_back({model.views[0].contour, model.views[1].contour});
    }
    const KeepLists nowhere = [](const std::vector<std::size_t>&, const core::NearestLists&) {
        return core::Result<void>();
    };
    LikenessUpdate update(contours, core::NearestLists(models.size()), jobs, {}, nowhere);
    (void)update.run(progress);  // nothing is stored and nobody stops it, so nothing can fail
    return update.take_lists();
}

}  // namespace app
