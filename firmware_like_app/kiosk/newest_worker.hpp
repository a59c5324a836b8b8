#pragma once
// Work on a thread of its own of which only the newest counts: at most one job runs and one waits.
//
//     NewestWorker<DetailJob, PreparedDetail> worker([](const DetailJob& job, const auto&) { return
//     prepare_detail(job); }); worker.start(job);                                  // when something is wanted if (auto
//     ready = worker.take()) …                   // once a frame

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "firmware_like_app/kiosk/background.hpp"

namespace app {

template <typename Job, typename Result>
class NewestWorker {
  public:
    /// `work` may look at the token, to end early when the worker goes.
    explicit NewestWorker(std::function<Result(const Job&, const std::stop_token&)> work) : work_(std::move(work)) {
        thread_ = std::jthread([this](const std::stop_token& stop) {
            yield_to_the_pen();
            run(stop);
        });
    }
    /// Waits for what it is at.
    ~NewestWorker() {
        thread_.request_stop();
        thread_.join();
    }
    NewestWorker(const NewestWorker&) = delete;
    NewestWorker& operator=(const NewestWorker&) = delete;

    /// Hands over a job and returns at once; one that still waits is replaced.
    void start(Job job) {
        const std::scoped_lock lock(mutex_);
        waiting_ = std::move(job);
        changed_.notify_all();
    }
    /// The newest result, once. Nothing comes of a job that threw, which is one that there was no memory for.
    [[nodiscard]] std::optional<Result> take() {
        const std::scoped_lock lock(mutex_);
        return std::exchange(done_, std::nullopt);
    }
    /// Whether a result is still to be taken, or on its way.
    [[nodiscard]] bool busy() const {
        const std::scoped_lock lock(mutex_);
        return waiting_.has_value() || done_.has_value() || wanted_;
    }
    /// What waits is not begun, what is done is dropped, and of the job that runs nothing comes: whoever wanted it has
    /// left, and nothing of theirs is kept. Returns at once.
    void forget() {
        const std::scoped_lock lock(mutex_);
        waiting_.reset();
        done_.reset();
        wanted_ = false;
    }

  private:
    void run(const std::stop_token& stop) {
        while (!stop.stop_requested()) {
            std::optional<Job> job;
            {
                std::unique_lock lock(mutex_);
                if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
                job = std::exchange(waiting_, std::nullopt);
                wanted_ = true;
            }
            std::optional<Result> result;
            try {
                result = work_(*job, stop);
            } catch (const std::exception&) {  // nothing comes of it
            }
            job.reset();
            const std::scoped_lock lock(mutex_);
            if (std::exchange(wanted_, false) && result) done_ = std::move(result);
        }
    }

    std::function<Result(const Job&, const std::stop_token&)> work_;
    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> waiting_;
    std::optional<Result> done_;
    bool wanted_ = false;  // the result of the job that runs
    std::jthread thread_;
};

}  // namespace app
