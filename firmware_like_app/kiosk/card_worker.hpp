#pragma once
// Makes the cards of an answer ready on a thread of its own, so that neither the screen nor the next search waits.

#include <optional>

#include "firmware_like_app/kiosk/newest_worker.hpp"
#include "firmware_like_app/kiosk/search_worker.hpp"

namespace app {

/// Its destructor asks a running preparation to stop and waits for it.
class CardWorker {
  public:
    CardWorker();

    /// Hands over an answer whose cards are wanted. One at a time: not while busy().
    void start(PreparedAnswer answer);
    /// From start() until its cards are taken or forgotten.
    [[nodiscard]] bool busy() const { return busy_; }
    /// The answer with its cards, once they are ready. Does not wait.
    [[nodiscard]] std::optional<PreparedAnswer> take();
    /// Nothing comes of what was handed over.
    void forget();

  private:
    PreparedAnswer prepare(const PreparedAnswer& wanted, const std::stop_token& stop);

    bool busy_ = false;      // only the caller's thread touches it
    CardPreparer preparer_;  // only the worker touches it
    NewestWorker<PreparedAnswer, PreparedAnswer> worker_;
};

}  // namespace app
