#pragma once
// Searches on a thread of its own. The newest drawing wins: at most one search runs and one waits.

#include <condition_variable>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "firmware_like_app/kiosk/searcher.hpp"
#include "ui/draw/model_geometry.hpp"

namespace app {

/// An answer with its cards ready for the graphics card.
struct PreparedAnswer {
    std::uint64_t ticket = 0;
    SearchAnswer answer;
    std::vector<std::shared_ptr<const ui::CardModel>> cards;  ///< one for each of answer.best that is shown
    std::string failure;                                      ///< what the searcher threw; empty when all is well
};

class SearchWorker {
  public:
    /// `searcher` must outlive the worker.
    explicit SearchWorker(Searcher& searcher);
    /// Asks a running search to stop and waits for it.
    ~SearchWorker();
    SearchWorker(const SearchWorker&) = delete;
    SearchWorker& operator=(const SearchWorker&) = delete;

    /// Hands over a drawing and returns at once; one that still waits is replaced. Tickets grow.
    std::uint64_t submit(core::Drawing drawing);
    /// The newest answer since the last call, if any. Does not wait.
    [[nodiscard]] std::optional<PreparedAnswer> take();
    /// Waits until a search with this ticket or a newer one is done and takes it. Nothing when it was taken before.
    [[nodiscard]] std::optional<PreparedAnswer> wait_for(std::uint64_t ticket);
    /// Searches done so far.
    [[nodiscard]] std::uint64_t searches() const;

  private:
    struct Job {
        std::uint64_t ticket;
        core::Drawing drawing;
    };
    void work(const std::stop_token& stop);
    PreparedAnswer run(const Job& job, const std::stop_token& stop);
    std::shared_ptr<const ui::ModelGeometry> geometry_of(const FoundModel& model);

    Searcher& searcher_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> waiting_;
    std::optional<PreparedAnswer> done_;
    std::uint64_t last_ticket_ = 0, done_ticket_ = 0, searches_ = 0;
    /// Of the models seen last, newest first; only the worker touches it.
    std::list<std::pair<const core::TriangleMesh*,
                        std::pair<std::shared_ptr<const core::TriangleMesh>, std::shared_ptr<const ui::ModelGeometry>>>>
        geometries_;
    std::jthread thread_;
};

}  // namespace app
