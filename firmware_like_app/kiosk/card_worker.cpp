#include "firmware_like_app/kiosk/card_worker.hpp"

#include <exception>
#include <utility>

namespace app {

CardWorker::CardWorker()
    : worker_([this](const PreparedAnswer& wanted, const std::stop_token& stop) { return prepare(wanted, stop); }) {}

PreparedAnswer CardWorker::prepare(const PreparedAnswer& wanted, const std::stop_token& stop) {
    PreparedAnswer answer = wanted;
    try {
        answer.cards = preparer_.prepare(answer.answer, stop);
    } catch (const std::exception& e) {  // out of memory: the cards show names alone
        answer.cards.clear();
        answer.failure = e.what();
    }
    return answer;
}

}  // namespace app
