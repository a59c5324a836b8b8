#include "firmware_like_app/kiosk/card_worker.hpp"

#include <exception>
#include <utility>

#include "firmware_like_app/kiosk/background.hpp"

namespace app {

CardWorker::CardWorker() {
    thread_ = std::jthread([this](const std::stop_token& stop) {
        yield_to_the_pen();
        work(stop);
    });
}

CardWorker::~CardWorker() {
    thread_.request_stop();
    thread_.join();
}

void CardWorker::start(PreparedAnswer answer) {
    busy_ = true;
    const std::scoped_lock lock(mutex_);
    waiting_ = std::move(answer);
    changed_.notify_all();
}

std::optional<PreparedAnswer> CardWorker::take() {
    const std::scoped_lock lock(mutex_);
    if (done_) busy_ = false;
    return std::exchange(done_, std::nullopt);
}

void CardWorker::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<PreparedAnswer> answer;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
            answer = std::exchange(waiting_, std::nullopt);
        }
        try {
            answer->cards = preparer_.prepare(answer->answer, stop);
        } catch (const std::exception& e) {  // out of memory: the cards show names alone
            answer->cards.clear();
            answer->failure = e.what();
        }
        const std::scoped_lock lock(mutex_);
        done_ = std::move(answer);
    }
}

}  // namespace app
