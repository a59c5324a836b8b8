#include "input/sources/replay_source.hpp"

#include <cassert>
#include <cmath>
#include <utility>

namespace input {

ReplaySource::ReplaySource(core::Drawing drawing, ReplayOptions options)
    : drawing_(std::move(drawing)), options_(options) {
    assert(options_.speed > 0.0 && options_.batch >= 1);
    std::erase_if(drawing_.strokes, [](const core::Stroke& stroke) { return stroke.samples.empty(); });
}

std::vector<PenEvent> ReplaySource::next(std::int64_t now_us) {
    if (!started_) {
        start_us_ = now_us;
        started_ = true;
    }
    std::vector<PenEvent> events;
    while (!finished() && events.size() < options_.batch && (!options_.paced || due_us() <= now_us)) {
        events.push_back(event());
        advance();
    }
    return events;
}

std::int64_t ReplaySource::due_us() const {
    assert(started_ && !finished());
    return start_us_ + std::llround(static_cast<double>(event().sample.time_us) / options_.speed);
}

PenEvent ReplaySource::event() const {
    const std::vector<core::PenSample>& samples = drawing_.strokes[stroke_].samples;
    if (step_ == samples.size()) return {PenEventKind::Up, samples.back()};
    return {step_ == 0 ? PenEventKind::Down : PenEventKind::Move, samples[step_]};
}

void ReplaySource::advance() {
    if (++step_ > drawing_.strokes[stroke_].samples.size()) {
        ++stroke_;
        step_ = 0;
    }
}

}  // namespace input
