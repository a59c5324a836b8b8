#include "core/garment/desk/desk_history.hpp"

#include <algorithm>
#include <utility>

namespace core {
namespace {

constexpr std::size_t kNewest = 48, kEvery = 8;

/// What an act was about: the first name that its steps tell.
std::string name_of(const std::vector<DesignStep>& steps) {
    const DesignStep& first = steps.front();
    if (first.kind == DesignStep::Kind::Place) return first.object.name;
    if (!first.region.empty()) return first.region;
    if (!first.name.empty()) return first.name;
    return first.lines.empty() ? std::string() : first.lines.front();
}

}  // namespace

DesignHistory::DesignHistory(DesignRunner start) : now_(std::move(start)) {
    kept_.emplace(0, now_);
}

void DesignHistory::push(std::vector<DesignStep> steps, DesignRunner after) {
    if (steps.empty()) return;
    acts_.resize(place_);
    kept_.erase(kept_.upper_bound(place_), kept_.end());
    acts_.push_back(std::move(steps));
    ++place_;
    now_ = std::move(after);
    kept_.insert_or_assign(place_, now_);
    thin();
}

/// Forgets the one state that has become old and is none of every eighth.
void DesignHistory::thin() {
    if (place_ <= kNewest) return;
    const std::size_t old = place_ - kNewest;
    if (old % kEvery != 0) kept_.erase(old);
}

void DesignHistory::go_to(std::size_t place) {
    place = std::min(place, acts_.size());
    auto from = kept_.upper_bound(place);
    --from;
    now_ = from->second;
    for (std::size_t act = from->first; act < place; ++act)
        for (const DesignStep& step : acts_[act]) (void)now_.take(step);  // failed as it did before, or done
    place_ = place;
}

std::vector<DesignStep> DesignHistory::steps() const {
    std::vector<DesignStep> out;
    for (std::size_t k = 0; k < place_; ++k) out.insert(out.end(), acts_[k].begin(), acts_[k].end());
    return out;
}

std::vector<HistoryEntry> DesignHistory::entries() const {
    std::vector<HistoryEntry> out;
    std::size_t steps = 0;
    for (const std::vector<DesignStep>& act : acts_) {
        steps += act.size();
        out.push_back({act.front().kind, name_of(act), steps});
    }
    return out;
}

}  // namespace core
