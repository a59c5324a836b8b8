#pragma once
// The searcher that stays while collections come and go: several threads may ask, a collection may be replaced while it
// is searched.

#include <atomic>
#include <memory>
#include <mutex>

#include "firmware_like_app/kiosk/searcher.hpp"

namespace app {

class LiveSearcher final : public Searcher {
  public:
    /// Without a collection every answer is empty.
    explicit LiveSearcher(std::shared_ptr<Searcher> searcher = nullptr) : searcher_(std::move(searcher)) {}

    /// One search at a time; others wait for it.
    SearchAnswer search(const core::Drawing& drawing, std::stop_token stop) override {
        const std::lock_guard lock(searching_);
        const std::shared_ptr<Searcher> searcher = current();
        return searcher ? searcher->search(drawing, std::move(stop)) : SearchAnswer{};
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

  private:
    std::mutex searching_;
    mutable std::mutex mutex_;
    std::shared_ptr<Searcher> searcher_;
    std::atomic<std::uint64_t> generation_{0};
};

}  // namespace app
