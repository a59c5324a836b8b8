#include "firmware_like_app/kiosk/search_worker.hpp"

#include <exception>
#include <utility>

namespace app {
SearchWorker::SearchWorker(Searcher& searcher, bool prepare_cards)
    : searcher_(searcher), prepare_cards_(prepare_cards) {
    thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

SearchWorker::~SearchWorker() {
    thread_.request_stop();
    thread_.join();
}

std::uint64_t SearchWorker::submit(core::Drawing drawing) {
    const std::scoped_lock lock(mutex_);
    waiting_ = Job{++last_ticket_, std::move(drawing)};
    changed_.notify_all();
    return last_ticket_;
}

std::optional<PreparedAnswer> SearchWorker::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(done_, std::nullopt);
}

std::optional<PreparedAnswer> SearchWorker::wait_for(std::uint64_t ticket) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return done_ticket_ >= ticket; });
    return std::exchange(done_, std::nullopt);
}

std::uint64_t SearchWorker::searches() const {
    const std::scoped_lock lock(mutex_);
    return searches_;
}

void SearchWorker::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<Job> job;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
            job = std::exchange(waiting_, std::nullopt);
        }
        PreparedAnswer answer = run(*job, stop);
        const std::scoped_lock lock(mutex_);
        done_ticket_ = answer.ticket;
        done_ = std::move(answer);
        ++searches_;
        changed_.notify_all();
    }
}

PreparedAnswer SearchWorker::run(const Job& job, const std::stop_token& stop) {
    PreparedAnswer out;
    out.ticket = job.ticket;
    try {
        out.answer = searcher_.search(job.drawing, stop);
        if (prepare_cards_) out.cards = preparer_.prepare(out.answer, stop);
    } catch (const std::exception& e) {
        out.answer = {};
        out.cards.clear();
        out.failure = e.what();
    }
    return out;
}

}  // namespace app
