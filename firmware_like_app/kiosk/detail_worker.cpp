#include "firmware_like_app/kiosk/detail_worker.hpp"

#include <exception>
#include <utility>

#include "firmware_like_app/kiosk/background.hpp"

namespace app {

PreparedDetail prepare_detail(const DetailJob& job) {
    PreparedDetail out;
    out.ticket = job.ticket;
    out.lifted = ui::lift_parts(*job.surface, job.camera, job.parts);
    out.contacts = ui::find_ground_contacts(out.lifted.geometry, job.camera.up);
    return out;
}

DetailWorker::DetailWorker() {
    thread_ = std::jthread([this](const std::stop_token& stop) {
        yield_to_the_pen();
        work(stop);
    });
}

DetailWorker::~DetailWorker() {
    thread_.request_stop();
    thread_.join();
}

void DetailWorker::start(DetailJob job) {
    const std::scoped_lock lock(mutex_);
    waiting_ = std::move(job);
    changed_.notify_all();
}

std::optional<PreparedDetail> DetailWorker::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(done_, std::nullopt);
}

void DetailWorker::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<DetailJob> job;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
            job = std::exchange(waiting_, std::nullopt);
        }
        std::optional<PreparedDetail> ready;
        try {
            ready = prepare_detail(*job);
        } catch (const std::exception&) {  // out of memory: the picture stays still
            continue;
        }
        const std::scoped_lock lock(mutex_);
        done_ = std::move(ready);
    }
}

}  // namespace app
