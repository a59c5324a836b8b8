#pragma once
// Searches on a thread of its own. The newest drawing wins: at most one search runs and one waits.

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "firmware_like_app/kiosk/card_preparer.hpp"
#include "firmware_like_app/kiosk/searcher.hpp"

namespace app {

/// An answer, and its cards once they are ready for the graphics card.
struct PreparedAnswer {
    std::uint64_t ticket = 0;
    SearchAnswer answer;
    CardPreparer::Cards cards;  ///< see CardPreparer; empty when not prepared
    std::string failure;        ///< what the searcher threw; empty when all is well
    double waited_ms = 0;       ///< from handing over the drawing until its search began
    double ready_ms = 0;        ///< from handing over the drawing until the answer was there
};

class SearchWorker {
  public:
    /// `searcher` must outlive the worker.
    explicit SearchWorker(Searcher& searcher);
    /// Asks a running search to stop and waits for it.
    ~SearchWorker();
    SearchWorker(const SearchWorker&) = delete;
    SearchWorker& operator=(const SearchWorker&) = delete;

    /// Hands over a drawing and returns at once; one that still waits is replaced. Tickets grow. `unfinished`: its last
    /// stroke is still being drawn.
    std::uint64_t submit(core::Drawing drawing, bool unfinished = false);
    /// The newest answer since the last call, if any. Does not wait.
    [[nodiscard]] std::optional<PreparedAnswer> take();
    /// Waits until a search with this ticket or a newer one is done and takes it. Nothing when it was taken before.
    [[nodiscard]] std::optional<PreparedAnswer> wait_for(std::uint64_t ticket);
    /// What waits is not searched, what is done is dropped, and of the search that runs nothing comes: its drawing was
    /// put away. Returns at once.
    void forget();
    /// Searches done so far.
    [[nodiscard]] std::uint64_t searches() const;

  private:
    struct Job {
        std::uint64_t ticket;
        core::Drawing drawing;
        bool unfinished;
        std::chrono::steady_clock::time_point since;
    };
    void work(const std::stop_token& stop);
    PreparedAnswer run(const Job& job, const std::stop_token& stop);

    Searcher& searcher_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> waiting_;
    std::optional<PreparedAnswer> done_;
    std::uint64_t last_ticket_ = 0, done_ticket_ = 0, forgotten_ticket_ = 0, searches_ = 0;
    std::jthread thread_;
};

}  // namespace app
