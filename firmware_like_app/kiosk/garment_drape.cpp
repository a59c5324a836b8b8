#include "firmware_like_app/kiosk/garment_drape.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "core/garment/drape.hpp"
#include "firmware_like_app/kiosk/background.hpp"

namespace app {
namespace {

constexpr int kStepsPerSecond = 60, kMostSteps = 20 * kStepsPerSecond;
constexpr int kLeastSteps = 40;      // cloth that has only begun to fall is slow as well
constexpr double kRest_cm_s = 0.25;  // mean speed of cloth that hangs still
constexpr int kMostBehind = 3;       // steps; a slower machine shows it in slow motion rather than in leaps

}  // namespace

/// A garment on its way down.
class GarmentDrape::Hanging {
  public:
    explicit Hanging(Job job)
        : job_(std::move(job)),
          layers_(copies(job_.layers)),
          drape_(core::joined_layers(layers_), job_.form->obstacle, {}, core::banded(layers_, job_.form->obstacle),
                 core::sewn(layers_)) {}

    void step() {
        drape_.step();
        ++steps_;
        rested_ = steps_ >= kMostSteps || (steps_ >= kLeastSteps && drape_.mean_speed_cm_s() < kRest_cm_s);
    }
    [[nodiscard]] int steps() const { return steps_; }
    [[nodiscard]] bool rested() const { return rested_; }
    [[nodiscard]] HangingPlaces places() const {
        HangingPlaces out;
        std::size_t first = 0;
        for (std::size_t k = 0; k < layers_.size(); ++k) {
            const std::size_t count = layers_[k].fitted.mesh.vertices.size();
            const auto begin = drape_.places().begin() + static_cast<std::ptrdiff_t>(first);
            out[job_.layers[k].layer].assign(begin, begin + static_cast<std::ptrdiff_t>(count));
            first += count;
        }
        return out;
    }

  private:
    static std::vector<core::FinishedLayer> copies(const std::vector<core::BuiltLayer>& layers) {
        std::vector<core::FinishedLayer> out;
        for (const core::BuiltLayer& layer : layers) out.push_back(*layer.cloth);
        return out;
    }

    Job job_;  // the form must outlive the drape
    std::vector<core::FinishedLayer> layers_;
    core::Drape drape_;
    int steps_ = 0;
    bool rested_ = false;
};

GarmentDrape::GarmentDrape(bool own_thread) {
    if (!own_thread) return;
    thread_ = std::jthread([this](const std::stop_token& stop) {
        yield_to_the_pen();
        work(stop);
    });
}

GarmentDrape::~GarmentDrape() {
    if (!thread_.joinable()) return;
    thread_.request_stop();
    thread_.join();
}

void GarmentDrape::start(std::vector<core::BuiltLayer> layers, std::shared_ptr<const core::WornForm> form,
                         std::int64_t now_us) {
    layers.erase(std::remove_if(layers.begin(), layers.end(), [](const core::BuiltLayer& l) { return !l.cloth; }),
                 layers.end());
    on_ = true;
    layers_ = layers;
    start_us_ = now_us;
    Job job{std::move(layers), std::move(form)};
    if (!thread_.joinable()) {
        here_ = std::make_unique<Hanging>(std::move(job));
        moving_ = true;
        newest_.reset();
        return;
    }
    const std::scoped_lock lock(mutex_);
    ++number_;
    waiting_ = std::move(job);
    newest_.reset();
    moving_ = true;
    changed_.notify_all();
}

void GarmentDrape::stop() {
    on_ = false;
    layers_.clear();
    here_.reset();
    const std::scoped_lock lock(mutex_);
    ++number_;
    waiting_.reset();
    newest_.reset();
    moving_ = false;
    changed_.notify_all();
}

bool GarmentDrape::moving() const {
    const std::scoped_lock lock(mutex_);
    return moving_;
}

bool GarmentDrape::hangs(const std::vector<core::BuiltLayer>& layers) const {
    std::size_t next = 0;
    for (const core::BuiltLayer& layer : layers) {
        if (!layer.cloth) continue;
        if (next == layers_.size() || layers_[next].cloth != layer.cloth) return false;
        ++next;
    }
    return next == layers_.size();
}

void GarmentDrape::advance(std::int64_t now_us) {
    if (!here_ || here_->rested()) return;
    const std::int64_t due = (now_us - start_us_) * kStepsPerSecond / 1'000'000;
    bool moved = false;
    while (here_->steps() < due && !here_->rested()) {
        here_->step();
        moved = true;
    }
    if (!moved) return;
    const std::scoped_lock lock(mutex_);
    newest_ = here_->places();
    moving_ = !here_->rested();
}

std::optional<HangingPlaces> GarmentDrape::take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(newest_, std::nullopt);
}

void GarmentDrape::publish(const Hanging& hanging, std::uint64_t of) {
    HangingPlaces places = hanging.places();
    const std::scoped_lock lock(mutex_);
    if (of != number_) return;
    newest_ = std::move(places);
    moving_ = !hanging.rested();
}

void GarmentDrape::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::optional<Job> job;
        std::uint64_t of = 0;
        {
            std::unique_lock lock(mutex_);
            if (!changed_.wait(lock, stop, [this] { return waiting_.has_value(); })) return;
            job = std::exchange(waiting_, std::nullopt);
            of = number_;
        }
        try {
            hang(std::move(*job), of, stop);
        } catch (const std::exception&) {  // out of memory: it stays where it hangs
            const std::scoped_lock lock(mutex_);
            if (of == number_) moving_ = false;
        }
    }
}

/// Until it rests, or something else is to hang.
void GarmentDrape::hang(Job job, std::uint64_t of, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    constexpr auto kStep = std::chrono::microseconds(1'000'000 / kStepsPerSecond);
    Hanging hanging(std::move(job));
    Clock::time_point due = Clock::now();
    while (!hanging.rested()) {
        {
            std::unique_lock lock(mutex_);
            changed_.wait_until(lock, stop, due, [this, of] { return number_ != of; });
            if (stop.stop_requested() || number_ != of) return;
        }
        hanging.step();
        publish(hanging, of);
        due = std::max(due + kStep, Clock::now() - kMostBehind * kStep);
    }
}

}  // namespace app
