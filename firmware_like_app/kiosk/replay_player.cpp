#include "firmware_like_app/kiosk/replay_player.hpp"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr std::int64_t kSteadyHand_us = 4'000'000;
constexpr std::int64_t kLongestLift_us = 1'500'000;  // a visitor who thinks longer is not waited for

core::Point at(const core::PenSample& s) {
    return {s.x, s.y};
}

double ink_length(const core::Drawing& drawing) {
    double total = 0;
    for (const core::Stroke& stroke : drawing.strokes) {
        for (std::size_t i = 1; i < stroke.samples.size(); ++i) {
            total += core::distance(at(stroke.samples[i - 1]), at(stroke.samples[i]));
        }
    }
    return total;
}

bool has_times(const core::Drawing& drawing) {
    std::int64_t first = 0, last = 0;
    bool any = false;
    for (const core::Stroke& stroke : drawing.strokes) {
        for (const core::PenSample& s : stroke.samples) {
            if (!any) first = s.time_us;
            any = true;
            last = s.time_us;
        }
    }
    return last > first;
}

}  // namespace

ReplayPlayer::ReplayPlayer(const std::vector<NamedDrawing>& drawings, std::int64_t rest_us) {
    std::int64_t clock_us = 0;
    for (std::size_t d = 0; d < drawings.size(); ++d) {
        const core::Drawing& drawing = drawings[d].drawing;
        const double total = std::max(ink_length(drawing), 1e-9);
        const bool timed = has_times(drawing);
        double drawn = 0;
        std::int64_t before_us = 0;
        bool first = true;
        events_.push_back({clock_us, {ReplayEvent::Kind::DrawingStarts, d, {}, 0}});
        for (const core::Stroke& stroke : drawing.strokes) {
            for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
                const core::PenSample& s = stroke.samples[i];
                const double step = i > 0 ? core::distance(at(stroke.samples[i - 1]), at(s)) : 0.0;
                drawn += step;
                const std::int64_t recorded = first ? 0 : std::max<std::int64_t>(s.time_us - before_us, 0);
                const std::int64_t steady = std::llround(step / total * static_cast<double>(kSteadyHand_us));
                clock_us += timed ? std::min(recorded, kLongestLift_us) : steady;
                before_us = s.time_us;
                first = false;
                events_.push_back(
                    {clock_us, {i == 0 ? ReplayEvent::Kind::Down : ReplayEvent::Kind::Move, d, s, drawn / total}});
            }
            events_.push_back({clock_us, {ReplayEvent::Kind::Up, d, {}, drawn / total}});
        }
        clock_us += rest_us;
        events_.push_back({clock_us, {ReplayEvent::Kind::DrawingEnds, d, {}, 1}});
    }
}

std::optional<ReplayEvent> ReplayPlayer::next(std::int64_t now_us) {
    if (ended() || events_[at_].time_us > now_us) return std::nullopt;
    return events_[at_++].event;
}

}  // namespace app
