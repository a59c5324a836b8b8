#pragma once
// The searcher that stays while collections come and go: several threads may ask, a collection may be replaced while it
// is searched.

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "firmware_like_app/kiosk/searcher.hpp"

namespace app {

class LiveSearcher final : public Searcher {
  public:
    /// Without a collection every answer is empty.
    explicit LiveSearcher(std::shared_ptr<Searcher> searcher = nullptr) : searcher_(std::move(searcher)) {}

    /// One search at a time; others wait for it.
    SearchAnswer search(const core::Drawing& drawing, std::stop_token stop) override {
        return ask(&Searcher::search, drawing, stop);
    }
    SearchAnswer search_unfinished(const core::Drawing& drawing, std::stop_token stop) override {
        return ask(&Searcher::search_unfinished, drawing, stop);
    }
    /// From the next search on. A search that runs goes on with the old one, which it keeps alive.
    void replace(std::shared_ptr<Searcher> searcher) {
        const std::lock_guard lock(mutex_);
        searcher_ = std::move(searcher);
        ++generation_;
    }
    /// Grows with each replacement.
    [[nodiscard]] std::uint64_t generation() const { return generation_; }
    [[nodiscard]] std::shared_ptr<Searcher> current() const {
        const std::lock_guard lock(mutex_);
        return searcher_;
    }

    /// Of the last searches that were not stopped, all their stages; 0: none yet.
    [[nodiscard]] double median_ms() const {
        const std::lock_guard lock(mutex_);
        std::vector<double> sorted(times_ms_.begin(),
                                   times_ms_.begin() + static_cast<std::ptrdiff_t>(std::min(noted_, times_ms_.size())));
        if (sorted.empty()) return 0;
        std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2), sorted.end());
        return sorted[sorted.size() / 2];
    }

  private:
    using Ask = SearchAnswer (Searcher::*)(const core::Drawing&, std::stop_token);
    SearchAnswer ask(Ask how, const core::Drawing& drawing, const std::stop_token& stop) {
        const std::lock_guard lock(searching_);
        const std::shared_ptr<Searcher> searcher = current();
        if (!searcher) return {};
        SearchAnswer answer = (searcher.get()->*how)(drawing, stop);
        if (!stop.stop_requested()) note(answer.silhouette_ms + answer.describe_ms + answer.search_ms);
        return answer;
    }

    void note(double ms) {
        const std::lock_guard lock(mutex_);
        times_ms_[noted_++ % times_ms_.size()] = ms;
    }
    std::array<double, 64> times_ms_{};
    std::size_t noted_ = 0;
    std::mutex searching_;
    mutable std::mutex mutex_;
    std::shared_ptr<Searcher> searcher_;
    std::atomic<std::uint64_t> generation_{0};
};

}  // namespace app
