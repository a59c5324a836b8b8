#include "input/pipeline/prediction.hpp"

#include <algorithm>
#include <cmath>

namespace input {
namespace {

constexpr double kJitter_mm = 0.05;             ///< of a reported place
constexpr double kAcceleration_mm_s2 = 4000.0;  ///< of a drawing hand, as a spread
constexpr double kFirstSpeedSpread_mm_s = 500.0;
constexpr int kFewestSamples = 3;

}  // namespace

void PenPredictor::Track::start(double at) {
    *this = {};
    place = at;
    var_place = kJitter_mm * kJitter_mm;
    var_speed = kFirstSpeedSpread_mm_s * kFirstSpeedSpread_mm_s;
}

void PenPredictor::Track::step(double measured, double t) {
    // predict
    place += speed * t;
    const double q = kAcceleration_mm_s2 * kAcceleration_mm_s2;
    var_place += 2 * t * var_both + t * t * var_speed + q * t * t * t * t / 4;
    var_both += t * var_speed + q * t * t * t / 2;
    var_speed += q * t * t;
    // correct
    const double sum = var_place + kJitter_mm * kJitter_mm, gain_place = var_place / sum, gain_speed = var_both / sum;
    const double error = measured - place;
    place += gain_place * error;
    speed += gain_speed * error;
    var_speed -= gain_speed * var_both;
    var_both -= gain_place * var_both;
    var_place -= gain_place * var_place;
}

void PenPredictor::see(const PenSample& s) {
    if (!s.tip || !s.x || !s.y) {
        last_.reset();
        seen_ = 0;
        return;
    }
    const double x = s.x_mm.value_or(*s.x * unsized_width_mm_), y = s.y_mm.value_or(*s.y * unsized_width_mm_);
    if (!last_ || s.device != last_->device) {
        x_.start(x);
        y_.start(y);
        seen_ = 1;
    } else if (s.time_ns > last_->time_ns) {
        const double seconds = static_cast<double>(s.time_ns - last_->time_ns) * 1e-9;
        x_.step(x, seconds);
        y_.step(y, seconds);
        ++seen_;
    }
    last_ = s;
}

std::optional<PenSample> PenPredictor::predict() const {
    if (!options_.on || !last_ || seen_ < kFewestSamples) return std::nullopt;
    const double seconds = static_cast<double>(options_.ahead_ns) * 1e-9;
    double dx = x_.speed * seconds, dy = y_.speed * seconds;
    const double length = std::hypot(dx, dy);
    if (length > options_.longest_mm) {
        dx *= options_.longest_mm / length;
        dy *= options_.longest_mm / length;
    }
    PenSample p = *last_;
    p.time_ns += options_.ahead_ns;
    const auto move = [this](std::optional<double>& share, std::optional<double>& mm, double by) {
        const double width = mm && *share > 0.0 ? *mm / *share : unsized_width_mm_;
        share = std::clamp(*share + by / width, 0.0, 1.0);
        if (mm) mm = *share * width;
    };
    move(p.x, p.x_mm, dx);
    move(p.y, p.y_mm, dy);
    return p;
}

}  // namespace input
