#pragma once
// Mouse and touch as fallback pens. The window hands its events in; nothing here knows a window.
//
//     input::PointerSource pointer({.numbers = &numbers});
//     pointer.touch_down(finger, x, y, pressure, now_ns);
//     pointer.pen(sample);                  // every sample of a real pen: its hand is not taken for a finger

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "input/pipeline/palm_rejection.hpp"
#include "input/sources/pen_source.hpp"

namespace input {

struct PointerSourceOptions {
    DeviceNumbers* numbers = nullptr;
    PalmOptions palm;
    double width_mm = 0.0, height_mm = 0.0;  ///< of the sheet; 0: samples have no millimetres
};

/// One touch draws at a time: the first that may. The mouse draws while its first button is pressed. All calls from one
/// thread. x and y are shares of the sheet, 0 … 1.
class PointerSource final : public PenSource {
  public:
    explicit PointerSource(PointerSourceOptions options);

    /// From other sources: a pen that is near, or no longer.
    void pen(const PenSample& sample);
    void pen_detached(std::uint32_t device, std::int64_t now_ns);

    void mouse(double x, double y, bool pressed, std::int64_t time_ns);
    void mouse_left(std::int64_t time_ns);
    void touch_down(std::int64_t finger, double x, double y, std::optional<double> pressure, std::int64_t time_ns);
    void touch_move(std::int64_t finger, double x, double y, std::optional<double> pressure, std::int64_t time_ns);
    void touch_up(std::int64_t finger, std::int64_t time_ns);

    /// A touch that was drawing turned out to be the palm: what its stroke drew is to be undone. Once for each.
    [[nodiscard]] bool take_cancelled();

    void drain(std::vector<SourceEvent>& out) override;
    [[nodiscard]] TraceDevice device(std::uint32_t number) const override;
    [[nodiscard]] std::uint64_t lost() const override { return 0; }
    [[nodiscard]] std::string_view name() const override { return "pointer"; }

  private:
    void push(std::uint32_t device, double x, double y, bool tip, PenTool tool, std::optional<double> pressure,
              std::int64_t time_ns);
    void push_gone(std::uint32_t device, std::int64_t time_ns);
    void attach(TraceDevice& device, const char* name, std::int64_t time_ns);

    PointerSourceOptions options_;
    PalmRejection palm_;
    TraceDevice mouse_, touch_;
    std::optional<std::int64_t> drawing_finger_;
    bool cancelled_ = false;
    std::vector<SourceEvent> events_;
};

}  // namespace input
