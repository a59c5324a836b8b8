#include "core/exchange/drawing_builder.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {
namespace {

constexpr double kMaxTime_us = 1e15;  // thirty years

}  // namespace

bool DrawingBuilder::refuse(const char* why) {
    if (refusal_ == nullptr) refusal_ = why;
    return false;
}

void DrawingBuilder::begin_stroke() {
    if (drawing_.strokes.empty() || !drawing_.strokes.back().samples.empty()) drawing_.strokes.emplace_back();
}

bool DrawingBuilder::add(double x, double y, std::optional<double> time_us, std::optional<double> pressure) {
    if (refusal_ != nullptr) return false;
    if (!(std::abs(x) <= kMaxCoordinate && std::abs(y) <= kMaxCoordinate)) {
        return refuse("a coordinate is no finite number within ten million; check the file");
    }
    if (time_us && !(std::abs(*time_us) <= kMaxTime_us)) {
        return refuse("a time is no finite number within thirty years; check the file");
    }
    if (pressure && std::isnan(*pressure)) return refuse("a pressure is not a number; check the file");
    if (++samples_ > kMaxDrawingSamples) {
        return refuse("the drawing has more than a million points; give a smaller one");
    }
    if (drawing_.strokes.empty()) begin_stroke();
    timed_ = timed_ && time_us.has_value();
    drawing_.strokes.back().samples.push_back(
        {std::llround(time_us.value_or(0.0)), x, y, std::clamp(pressure.value_or(1.0), 0.0, 1.0)});
    return true;
}

void DrawingBuilder::keep_times() {
    const std::int64_t start = drawing_.strokes.front().samples.front().time_us;
    std::int64_t last = 0;
    for (Stroke& stroke : drawing_.strokes) {
        std::int64_t shift = -start;
        if (stroke.samples.front().time_us + shift < last) {
            shift = last + kUntimedPause_us - stroke.samples.front().time_us;
        }
        for (PenSample& sample : stroke.samples) {
            last = std::max(last, sample.time_us + shift);
            sample.time_us = last;
        }
    }
}

void DrawingBuilder::make_times() {
    double left = kMaxCoordinate, right = -kMaxCoordinate, top = kMaxCoordinate, bottom = -kMaxCoordinate;
    for (const Stroke& stroke : drawing_.strokes) {
        for (const PenSample& s : stroke.samples) {
            left = std::min(left, s.x);
            right = std::max(right, s.x);
            top = std::min(top, s.y);
            bottom = std::max(bottom, s.y);
        }
    }
    const double diagonal = std::hypot(right - left, bottom - top);
    const double us_per_unit = diagonal > 0.0 ? static_cast<double>(kUntimedDiagonal_us) / diagonal : 0.0;
    double time_us = 0.0;
    for (Stroke& stroke : drawing_.strokes) {
        for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
            PenSample& s = stroke.samples[i];
            if (i > 0) {
                const PenSample& before = stroke.samples[i - 1];
                time_us += us_per_unit * std::hypot(s.x - before.x, s.y - before.y);
            }
            s.time_us = std::llround(time_us);
        }
        time_us += static_cast<double>(kUntimedPause_us);
    }
}

Result<Drawing> DrawingBuilder::finish() && {
    if (refusal_ != nullptr) return unexpected(ErrorCode::BadFormat, refusal_);
    if (!drawing_.strokes.empty() && drawing_.strokes.back().samples.empty()) drawing_.strokes.pop_back();
    if (drawing_.strokes.empty())
        return unexpected(ErrorCode::EmptyDrawing, "there are no strokes in it; draw something");
    if (timed_) {
        keep_times();
    } else {
        make_times();
    }
    return std::move(drawing_);
}

}  // namespace core
