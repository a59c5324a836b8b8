#include "core/mannequin/loft.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace core {
namespace {

constexpr double kStep = 0.75;  // of the controls, about: finer than any bend of a body
constexpr int kSmoothing = 2;   // passes of (1/4, 1/2, 1/4) over the controls

using Values = std::array<double, 5>;

Values values(const Section& s) {
    return {s.side, s.back, s.front, s.middle_x, s.middle_z};
}
Section section(double along, const Values& v) {
    return {along, v[0], v[1], v[2], v[3], v[4]};
}

/// Slopes of the monotone cubic interpolant (Fritsch and Butland 1984): no overshoot, so waists and hips stay where
/// they are put.
std::vector<double> monotone_slopes(const std::vector<Section>& s, std::size_t channel) {
    std::vector<double> slopes(s.size(), 0.0);
    const auto chord = [&](std::size_t i) {
        return (values(s[i + 1])[channel] - values(s[i])[channel]) / (s[i + 1].along - s[i].along);
    };
    for (std::size_t i = 1; i + 1 < s.size(); ++i) {
        const double before = chord(i - 1), after = chord(i);
        if (before * after <= 0.0) continue;
        const double h0 = s[i].along - s[i - 1].along, h1 = s[i + 1].along - s[i].along;
        const double share = (h0 + 2.0 * h1) / (3.0 * (h0 + h1));
        slopes[i] = before * after / (share * after + (1.0 - share) * before);
    }
    slopes.front() = chord(0);
    slopes.back() = chord(s.size() - 2);
    return slopes;
}

double hermite(double t, double h, double v0, double v1, double m0, double m1) {
    const double t2 = t * t, t3 = t2 * t;
    return v0 * (2 * t3 - 3 * t2 + 1) + v1 * (3 * t2 - 2 * t3) + h * (m0 * (t3 - 2 * t2 + t) + m1 * (t3 - t2));
}

void smooth(std::vector<Section>& controls) {
    std::vector<Section> out = controls;
    for (std::size_t i = 1; i + 1 < controls.size(); ++i) {
        const Values a = values(controls[i - 1]), b = values(controls[i]), c = values(controls[i + 1]);
        Values mean;
        for (std::size_t k = 0; k < mean.size(); ++k) mean[k] = 0.25 * a[k] + 0.5 * b[k] + 0.25 * c[k];
        out[i] = section(controls[i].along, mean);
    }
    controls = std::move(out);
}

/// |u|^p and |u|^(p-1) for the exponents of Loft::Shape.
struct Powers {
    double full, less;
};
Powers powers(double u, Loft::Shape shape) {
    if (shape == Loft::Shape::Ellipse) return {u * u, u};
    const double quarter = std::sqrt(std::sqrt(u));
    return {u * u * quarter, u * quarter};
}

}  // namespace

Loft::Loft(LoftFrame frame, const std::vector<Section>& sections, Shape shape)
    : frame_(frame), shape_(shape), first_(sections.front().along), last_(sections.back().along) {
    const int steps = std::max(2, static_cast<int>(std::ceil((last_ - first_) / kStep)));
    step_ = (last_ - first_) / steps;
    std::array<std::vector<double>, 5> slopes;
    for (std::size_t k = 0; k < slopes.size(); ++k) slopes[k] = monotone_slopes(sections, k);
    std::size_t i = 0;
    for (int n = 0; n <= steps; ++n) {
        const double along = first_ + n * step_;
        while (i + 2 < sections.size() && along > sections[i + 1].along) ++i;
        const double h = sections[i + 1].along - sections[i].along, t = (along - sections[i].along) / h;
        const Values v0 = values(sections[i]), v1 = values(sections[i + 1]);
        Values v;
        for (std::size_t k = 0; k < v.size(); ++k) v[k] = hermite(t, h, v0[k], v1[k], slopes[k][i], slopes[k][i + 1]);
        controls_.push_back(section(along, v));
    }
    controls_.insert(controls_.begin(), controls_.front());
    controls_.push_back(controls_.back());
    for (int pass = 0; pass < kSmoothing; ++pass) smooth(controls_);
}

Loft::Sloped Loft::sloped_at(double along) const {
    const double s = std::clamp((along - first_) / step_, 0.0, static_cast<double>(controls_.size() - 3) - 1e-9);
    const auto i = static_cast<std::size_t>(s);
    const double t = s - static_cast<double>(i), u = 1.0 - t;
    const std::array<double, 4> w{u * u * u / 6.0, (3 * t * t * t - 6 * t * t + 4) / 6.0,
                                  (3 * u * u * u - 6 * u * u + 4) / 6.0, t * t * t / 6.0};
    const std::array<double, 4> d{-u * u / 2.0, (3 * t * t - 4 * t) / 2.0, (4 * u - 3 * u * u) / 2.0, t * t / 2.0};
    Values value{}, slope{};
    for (std::size_t k = 0; k < 4; ++k) {
        const Values c = values(controls_[std::min(i + k, controls_.size() - 1)]);
        for (std::size_t n = 0; n < c.size(); ++n) {
            value[n] += w[k] * c[n];
            slope[n] += d[k] * c[n] / step_;
        }
    }
    return {section(along, value), section(0.0, slope)};
}

Section Loft::at(double along) const {
    return sloped_at(along).value;
}

Vec3 Loft::middle(double along) const {
    const Section s = at(along);
    return frame_.origin + frame_.along * along + frame_.side * s.middle_x + frame_.front * s.middle_z;
}

FieldSample Loft::sample(Vec3 p) const {
    const Vec3 local = p - frame_.origin;
    const double along = dot(local, frame_.along);
    const double inside = std::clamp(along, first_, last_);
    const Sloped s = sloped_at(inside);
    const double x = dot(local, frame_.side) - s.value.middle_x, z = dot(local, frame_.front) - s.value.middle_z;
    const bool before = z >= 0.0;
    const double depth = before ? s.value.front : s.value.back, depth_slope = before ? s.slope.front : s.slope.back;
    const double u = std::abs(x) / s.value.side, w = std::abs(z) / depth;
    const double sum = powers(u, shape_).full + powers(w, shape_).full;
    const double rho = shape_ == Shape::Ellipse ? std::sqrt(sum) : std::pow(sum, 1.0 / 2.25);
    FieldSample across{-std::min(s.value.side, depth), frame_.side};  // on the axis, where no direction leads out
    if (rho > 1e-9) {
        const double by_u = powers(u / rho, shape_).less, by_w = powers(w / rho, shape_).less;
        const double dx = std::copysign(by_u, x) / s.value.side, dz = std::copysign(by_w, z) / depth;
        // the slope along the axis is that of the surface across from p, so that it also holds far from the surface
        const double growth = (by_u * u * s.slope.side / s.value.side + by_w * w * depth_slope / depth) / rho;
        const double dy = along != inside ? 0.0 : -dx * s.slope.middle_x - dz * s.slope.middle_z - growth;
        const double steep = std::sqrt(dx * dx + dy * dy + dz * dz);
        across = {(rho - 1.0) / steep, (frame_.side * dx + frame_.along * dy + frame_.front * dz) * (1.0 / steep)};
    }
    const double beyond = std::max(first_ - along, along - last_);
    const Vec3 axial = frame_.along * (along > 0.5 * (first_ + last_) ? 1.0 : -1.0);
    if (beyond <= 0.0 || across.distance <= 0.0) return across.distance > beyond ? across : FieldSample{beyond, axial};
    const double distance = std::hypot(across.distance, beyond);
    return {distance, (across.gradient * across.distance + axial * beyond) * (1.0 / distance)};
}

}  // namespace core
