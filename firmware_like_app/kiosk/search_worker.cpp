#include "firmware_like_app/kiosk/search_worker.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "firmware_like_app/kiosk/background.hpp"

namespace app {
namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

SearchWorker::SearchWorker(Searcher& searcher) : searcher_(searcher) {
    thread_ = std::jthread([this](const std::stop_token& stop) {
        yield_to_the_pen();
        work(stop);
    });
}

SearchWorker::~SearchWorker() {
    thread_.request_stop();
    thread_.join();
}

std::uint64_t SearchWorker::submit(core::Drawing drawing, bool unfinished) {
    const std::scoped_lock lock(mutex_);
    waiting_ = Job{++last_ticket_, std::move(drawing), unfinished, std::chrono::steady_clock::now()};
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

void SearchWorker::forget() {
    const std::scoped_lock lock(mutex_);
    waiting_.reset();
    done_.reset();
    forgotten_ticket_ = done_ticket_ = last_ticket_;  // nobody waits for these any more
    changed_.notify_all();
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
        done_ticket_ = std::max(done_ticket_, answer.ticket);
        if (answer.ticket > forgotten_ticket_) done_ = std::move(answer);
        ++searches_;
        changed_.notify_all();
    }
}

PreparedAnswer SearchWorker::run(const Job& job, const std::stop_token& stop) {
    PreparedAnswer out;
    out.ticket = job.ticket;
    out.waited_ms = ms_since(job.since);
    try {
        out.answer =
            job.unfinished ? searcher_.search_unfinished(job.drawing, stop) : searcher_.search(job.drawing, stop);
    } catch (const std::exception& e) {
        out.answer = {};
        out.failure = e.what();
    }
    out.ready_ms = ms_since(job.since);
    return out;
}

}  // namespace app
