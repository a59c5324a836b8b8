#pragma once
// Where the pen will be when the next frame is seen. For ink that is shown early and drawn over; never part of a
// stroke.

#include <cstdint>
#include <optional>

#include "input/pen_sample.hpp"
#include "input/pipeline/options.hpp"

namespace input {

/// One Kalman filter for each coordinate: place and speed, driven by a random acceleration. The filter's own place is
/// not shown, only its speed is used, so a prediction begins at the pen.
class PenPredictor {
  public:
    explicit PenPredictor(const PredictionOptions& options, double unsized_width_mm = 200.0)
        : options_(options), unsized_width_mm_(unsized_width_mm) {}

    /// Every sample of the pen. A lifted or absent tip forgets the stroke.
    void see(const PenSample& sample);
    /// The sample that the pen would give `ahead_ns` after its last one; nothing while it does not draw, in the first
    /// three samples of a stroke, or when prediction is off.
    [[nodiscard]] std::optional<PenSample> predict() const;

  private:
    struct Track {
        double place = 0.0, speed = 0.0;
        double var_place = 0.0, var_both = 0.0, var_speed = 0.0;
        void start(double at);
        void step(double measured, double seconds);
    };
    PredictionOptions options_;
    double unsized_width_mm_;
    std::optional<PenSample> last_;
    Track x_, y_;
    int seen_ = 0;
};

}  // namespace input
