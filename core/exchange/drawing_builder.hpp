#pragma once
// Collects what a file says about strokes and makes a Drawing that keeps its promises, whatever the file says.

#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/result.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// Speed of the pen where a file has no times: the diagonal of the drawing in one second, and a fifth of a second in
/// the air between strokes. (People draw a shape of a few diagonals' length in a few seconds.)
inline constexpr std::int64_t kUntimedDiagonal_us = 1'000'000;
inline constexpr std::int64_t kUntimedPause_us = 200'000;

inline constexpr std::size_t kMaxDrawingSamples = 1'000'000;
inline constexpr double kMaxCoordinate = 1e7;  ///< larger coordinates are refused, as are NaN and infinities

class DrawingBuilder {
  public:
    /// Samples that follow belong to a new stroke. A stroke that stays without samples is dropped.
    void begin_stroke();

    /// Adds a sample to the current stroke (the first call begins one). Once something is refused, finish() reports the
    /// first reason and later calls do nothing; false from then on. A pressure outside 0 … 1 is clamped.
    bool add(double x, double y, std::optional<double> time_us = {}, std::optional<double> pressure = {});

    /// The drawing: first sample at time 0, times never falling. If any sample came without a time, all times are made
    /// at the constant speed above. A stroke whose times begin before the end of the one before is moved behind it by
    /// the pause; inside a stroke a falling time is held. EmptyDrawing without samples, BadFormat after a refusal.
    [[nodiscard]] Result<Drawing> finish() &&;

  private:
    bool refuse(const char* why);
    void keep_times();
    void make_times();

    Drawing drawing_;
    std::size_t samples_ = 0;
    bool timed_ = true;
    const char* refusal_ = nullptr;
};

}  // namespace core
