#pragma once
// Plays a recorded drawing again as if a pen drew it, on a clock that the caller holds.
//
//     input::ReplaySource pen(drawing, {.speed = 2.0});
//     for (const input::PenEvent& event : pen.next(clock.now_us())) …

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/stroke/stroke.hpp"

namespace input {

enum class PenEventKind { Down, Move, Up };

/// Down comes with a stroke's first sample, Move with each further one, Up with the last sample once more.
struct PenEvent {
    PenEventKind kind = PenEventKind::Move;
    core::PenSample sample;  ///< as recorded: its time counts from the start of the drawing, whatever the speed
};

struct ReplayOptions {
    double speed = 1.0;  ///< recorded seconds per second of the clock; > 0
    bool paced = true;   ///< false: as fast as possible, every call gives what is left whatever the clock says
    std::size_t batch = std::numeric_limits<std::size_t>::max();  ///< most events a call gives; >= 1
};

/// Strokes without samples are passed over. Deterministic: the same calls give the same events.
class ReplaySource {
  public:
    explicit ReplaySource(core::Drawing drawing, ReplayOptions options = {});

    /// The events due by `now_us`, in order. The first call starts the replay: sample time 0 is due then. A clock that
    /// stands still or runs backwards gives nothing new. Linear in the events given.
    [[nodiscard]] std::vector<PenEvent> next(std::int64_t now_us);

    /// Whether every event has been given.
    [[nodiscard]] bool finished() const { return stroke_ >= drawing_.strokes.size(); }

    /// Clock time at which the next event is due; only after the first next() and before finished().
    [[nodiscard]] std::int64_t due_us() const;

  private:
    [[nodiscard]] PenEvent event() const;
    void advance();

    core::Drawing drawing_;
    ReplayOptions options_;
    std::int64_t start_us_ = 0;
    bool started_ = false;
    std::size_t stroke_ = 0;
    std::size_t step_ = 0;  ///< within the stroke: 0 … size - 1 the samples, size the lift
};

}  // namespace input
