#include "firmware_like_app/kiosk/garment_builder.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "core/garment/texture.hpp"
#include "firmware_like_app/kiosk/background.hpp"

namespace app {

GarmentBuilder::GarmentBuilder(bool own_thread) {
    if (!own_thread) return;
    thread_ = std::jthread([this](const std::stop_token& stop) {
        yield_to_the_pen();
        work(stop);
    });
}

GarmentBuilder::~GarmentBuilder() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

void GarmentBuilder::submit(Job job) {
    if (!thread_.joinable()) {
        done_ = run(job, {});
        return;
    }
    const std::scoped_lock lock(mutex_);
    waiting_ = std::move(job);
    changed_.notify_all();
}

std::optional<BuiltGarment> GarmentBuilder::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(done_, std::nullopt);
}

void GarmentBuilder::wait() {
    if (!thread_.joinable()) return;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !waiting_ && !working_; });
}

void GarmentBuilder::forget() {
    const std::scoped_lock lock(mutex_);
    waiting_.reset();
    done_.reset();
    ++epoch_;
}

bool GarmentBuilder::busy() const {
    const std::scoped_lock lock(mutex_);
    return waiting_.has_value() || working_;
}

void GarmentBuilder::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<Job> job;
        std::uint64_t epoch = 0;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
            job = std::exchange(waiting_, std::nullopt);
            working_ = true;
            epoch = epoch_;
        }
        std::optional<BuiltGarment> built;
        try {
            built = run(*job, stop);
        } catch (const std::exception&) {  // out of memory: what is shown stays, and the next act asks again
        }
        const std::scoped_lock lock(mutex_);
        if (built && epoch == epoch_) done_ = std::move(built);
        working_ = false;
        changed_.notify_all();
    }
}

std::shared_ptr<const core::Cloth> GarmentBuilder::textured(const std::shared_ptr<const core::FinishedLayer>& layer) {
    const auto known = kept_.find(layer.get());
    if (known != kept_.end()) return known->second.second;
    auto cloth = std::make_shared<core::Cloth>(layer->fitted);
    (void)core::lay_texture(*cloth);
    return cloth;
}

BuiltGarment GarmentBuilder::run(const Job& job, const std::stop_token& stop) {
    BuiltGarment out;
    out.result = core::build(job.request, stop);
    decltype(kept_) kept;
    for (const core::BuiltLayer& layer : out.result.layers) {
        const bool woven = std::find(job.woven.begin(), job.woven.end(), layer.layer) != job.woven.end();
        out.textured.push_back(woven && layer.cloth ? textured(layer.cloth) : nullptr);
        if (out.textured.back()) kept[layer.cloth.get()] = {layer.cloth, out.textured.back()};
    }
    kept_ = std::move(kept);
    return out;
}

}  // namespace app
