#pragma once
// Makes the cards of an answer ready on a thread of its own, so that neither the screen nor the next search waits.

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "firmware_like_app/kiosk/search_worker.hpp"

namespace app {

class CardWorker {
  public:
    CardWorker();
    /// Asks a running preparation to stop and waits for it.
    ~CardWorker();
    CardWorker(const CardWorker&) = delete;
    CardWorker& operator=(const CardWorker&) = delete;

    /// Hands over an answer whose cards are wanted. One at a time: not while busy().
    void start(PreparedAnswer answer);
    /// From start() until its cards are taken.
    [[nodiscard]] bool busy() const { return busy_; }
    /// The answer with its cards, once they are ready. Does not wait.
    [[nodiscard]] std::optional<PreparedAnswer> take();

  private:
    void work(const std::stop_token& stop);

    bool busy_ = false;  // only the caller's thread touches it
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<PreparedAnswer> waiting_, done_;
    CardPreparer preparer_;  // only the worker touches it
    std::jthread thread_;
};

}  // namespace app
