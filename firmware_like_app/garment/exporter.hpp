#pragma once
// Exports a design on a thread of its own: makes the garment, its files and pictures, writes them to a place.
//
//     exporter.start({.design = desk.design(), .plan = {}, .place = sticks.front()});
//     const ExportState now = exporter.state();      // each frame: draw now.share; now.stage Saved, Failed: it ended

#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "firmware_like_app/garment/export_files.hpp"
#include "firmware_like_app/garment/safe_folder.hpp"
#include "firmware_like_app/garment/stick_finder.hpp"

namespace app {

struct ExportJob {
    core::Design design;
    core::FormSource bodies = {};
    ModelSource models = {};  ///< called on the exporter's thread
    ExportPlan plan = {};
    ExportPlace place;
};

struct ExportState {
    enum class Stage { Idle, Dressing, Pictures, Writing, Saved, Failed };
    Stage stage = Stage::Idle;
    double share = 0;                        ///< of all the work, 0 … 1
    std::filesystem::path folder = {};       ///< Saved: where
    std::optional<ExportFault> fault = {};   ///< Failed: why
    std::vector<std::string> warnings = {};  ///< what could not be made and is missing
};

/// All of it on the calling thread. `report` is called with each change. What runs out of memory has failed.
[[nodiscard]] ExportState run_export(const ExportJob& job, const std::function<void(const ExportState&)>& report,
                                     const std::stop_token& stop);

class Exporter {
  public:
    Exporter() = default;
    /// Stops what is running, within some tenths of a second; nothing is left of it then.
    ~Exporter() = default;
    Exporter(const Exporter&) = delete;
    Exporter& operator=(const Exporter&) = delete;

    /// False, and nothing happens, while another export runs.
    bool start(ExportJob job);
    void cancel() { thread_.request_stop(); }
    /// Whoever wanted it has left: what ended is told no more, of what runs only that it does. Its files are written
    /// all the same.
    void forget() { forgotten_ = true; }
    [[nodiscard]] ExportState state() const;
    [[nodiscard]] bool is_running() const;

  private:
    [[nodiscard]] ExportState whole_state() const;
    mutable std::mutex mutex_;
    ExportState state_;
    bool forgotten_ = false;  // only the caller's thread touches it
    std::jthread thread_;     // last: ends before the rest goes
};

}  // namespace app
