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
    void start(PreparedAnswer answer) { worker_.start(std::move(answer)); }
    /// From start() until its cards are taken, forgotten, or cannot be made.
    [[nodiscard]] bool busy() const { return worker_.busy(); }
    /// The answer with its cards, once they are ready. Does not wait.
    [[nodiscard]] std::optional<PreparedAnswer> take() { return worker_.take(); }
    /// Nothing comes of what was handed over.
    void forget() { worker_.forget(); }

  private:
    PreparedAnswer prepare(const PreparedAnswer& wanted, const std::stop_token& stop);

    CardPreparer preparer_;  // only the worker touches it
    NewestWorker<PreparedAnswer, PreparedAnswer> worker_;
};

}  // namespace app
