#pragma once
// The garment under gravity beside the pen: hangs at the pace of the clock on a thread of its own, and the newest
// places are there to be shown. Without a thread it hangs as far as the clock that it is given says, so that pictures
// and replays repeat.

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

#include "core/garment/desk/build_request.hpp"

namespace app {

/// Places for the vertices of the fitted cloth of layers, by the layer's number.
using HangingPlaces = std::map<int, std::vector<core::Vec3>>;

class GarmentDrape {
  public:
    /// `own_thread` false: it moves in `advance`.
    explicit GarmentDrape(bool own_thread);
    ~GarmentDrape();
    GarmentDrape(const GarmentDrape&) = delete;
    GarmentDrape& operator=(const GarmentDrape&) = delete;

    /// Lets these layers, inner ones first, hang on the form; what hung before is forgotten. Layers whose pieces were
    /// drawn on others are sewn to them (core/garment/sewing.hpp).
    void start(std::vector<core::BuiltLayer> layers, std::shared_ptr<const core::WornForm> form, std::int64_t now_us);
    /// Ends it; the cloth is as drawn again. Does not wait.
    void stop();
    [[nodiscard]] bool on() const { return on_; }
    /// Whether it still moves: false once it came to rest, or after 20 s.
    [[nodiscard]] bool moving() const;
    /// Whether these are the layers that hang.
    [[nodiscard]] bool hangs(const std::vector<core::BuiltLayer>& layers) const;

    /// The clock of a drape without a thread.
    void advance(std::int64_t now_us);
    /// The newest places, once; nothing where there are no newer ones.
    [[nodiscard]] std::optional<HangingPlaces> take();

  private:
    struct Job {
        std::vector<core::BuiltLayer> layers;
        std::shared_ptr<const core::WornForm> form;
    };
    class Hanging;
    void work(const std::stop_token& stop);
    void hang(Job job, std::uint64_t of, const std::stop_token& stop);
    void publish(const Hanging& hanging, std::uint64_t of);

    bool on_ = false;
    std::vector<core::BuiltLayer> layers_;
    std::unique_ptr<Hanging> here_;  // without a thread
    std::int64_t start_us_ = 0;

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<Job> waiting_;
    std::optional<HangingPlaces> newest_;
    bool moving_ = false;
    std::uint64_t number_ = 0;  // of starts and stops: what is of an earlier one is dropped
    std::jthread thread_;
};

}  // namespace app
