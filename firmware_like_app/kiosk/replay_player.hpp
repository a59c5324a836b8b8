#pragma once
// Plays recorded drawings back as pen events at their recorded times, one drawing after the other.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/stroke/stroke.hpp"

namespace app {

struct NamedDrawing {
    std::string name;
    core::Drawing drawing;
};

/// One step of a replay, in the drawing's own units.
struct ReplayEvent {
    enum class Kind { DrawingStarts, Down, Move, Up, DrawingEnds };
    Kind kind = Kind::Move;
    std::size_t drawing = 0;  ///< index into the drawings
    core::PenSample sample;   ///< of Down and Move
    double ink_share = 0;     ///< of the drawing's line length drawn with this sample, 0 … 1
};

class ReplayPlayer {
  public:
    /// Times that do not grow are replaced by those of a steady hand: a drawing takes four seconds then. Each drawing
    /// stays `rest_us` on the sheet after its last stroke.
    ReplayPlayer(const std::vector<NamedDrawing>& drawings, std::int64_t rest_us);

    /// The next event when its time has come.
    [[nodiscard]] std::optional<ReplayEvent> next(std::int64_t now_us);
    [[nodiscard]] bool ended() const { return at_ == events_.size(); }

  private:
    struct Timed {
        std::int64_t time_us;
        ReplayEvent event;
    };
    std::vector<Timed> events_;
    std::size_t at_ = 0;
};

}  // namespace app
