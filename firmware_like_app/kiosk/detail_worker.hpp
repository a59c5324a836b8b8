#pragma once
// Makes one result ready to be turned: part colours lifted onto its whole surface. Tens of milliseconds, so on a thread
// of its own where frames are seen.

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "firmware_like_app/kiosk/searcher.hpp"
#include "ui/draw/lifted_parts.hpp"
#include "ui/draw/model_stage.hpp"

namespace app {

/// What is asked: the model of a result and its surface, as its card has it.
struct DetailJob {
    std::uint64_t ticket = 0;
    std::shared_ptr<const ui::ModelGeometry> surface;
    core::Camera camera;  ///< the view that matched
    std::vector<ui::PartRegion> parts;
};

struct PreparedDetail {
    std::uint64_t ticket = 0;
    ui::LiftedModel lifted;
    std::vector<ui::GroundContact> contacts;
};

/// 10 to 60 ms. Needs no GL.
[[nodiscard]] PreparedDetail prepare_detail(const DetailJob& job);

class DetailWorker {
  public:
    DetailWorker();
    /// Waits for what it is at.
    ~DetailWorker();
    DetailWorker(const DetailWorker&) = delete;
    DetailWorker& operator=(const DetailWorker&) = delete;

    /// Hands over a job and returns at once; one that still waits is replaced.
    void start(DetailJob job);
    /// The newest that is ready, once. Nothing came of a job that there was no memory for.
    [[nodiscard]] std::optional<PreparedDetail> take();

  private:
    void work(const std::stop_token& stop);

    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::optional<DetailJob> waiting_;
    std::optional<PreparedDetail> done_;
    std::jthread thread_;
};

}  // namespace app
