#include "ui/draw/ink_curve.hpp"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr double kCornerCosine = 0.342;  // cosine of 70 degrees
constexpr double kStraightPx = 0.5;      // tangents this little off the chord bend it by less than a tenth of a pixel
constexpr double kPiecePx = 4.0;         // longest chord of a bent span

/// Tangent at b for the curve a, b, c with centripetal parameters, per unit of parameter; zero at a corner.
core::Point tangent(core::Point a, core::Point b, core::Point c) {
    const double ab = core::distance(a, b), bc = core::distance(b, c);
    if (ab < 1e-9 || bc < 1e-9) return {};
    if (core::dot(b - a, c - b) / (ab * bc) < kCornerCosine) return {};
    const double t0 = std::sqrt(ab), t1 = std::sqrt(bc);
    return (b - a) * (1 / t0) - (c - a) * (1 / (t0 + t1)) + (c - b) * (1 / t1);
}

InkPiece piece(core::Point a, core::Point b, double ra, double rb) {
    return {static_cast<float>(a.x), static_cast<float>(a.y), static_cast<float>(b.x),
            static_cast<float>(b.y), static_cast<float>(ra),  static_cast<float>(rb)};
}

}  // namespace

double ink_radius_px(double pressure, double width_px) {
    return 0.5 * width_px * (0.3 + 0.7 * std::clamp(pressure, 0.0, 1.0));
}

std::size_t ink_span_count(const std::vector<core::PenSample>& samples) {
    return samples.size() < 2 ? samples.size() : samples.size() - 1;
}

void append_ink_span(const std::vector<core::PenSample>& samples, std::size_t span, const InkFrame& frame,
                     double width_px, std::vector<InkPiece>& out) {
    const auto at = [&](std::size_t i) { return frame.to_px({samples[i].x, samples[i].y}); };
    const core::Point b = at(span);
    const double rb = ink_radius_px(samples[span].pressure, width_px);
    if (samples.size() < 2) {
        out.push_back(piece(b, b, rb, rb));
        return;
    }
    const core::Point c = at(span + 1);
    const double rc = ink_radius_px(samples[span + 1].pressure, width_px);
    const double chord = core::distance(b, c), parameter = std::sqrt(chord);
    const core::Point mb = (span > 0 ? tangent(at(span - 1), b, c) : core::Point{}) * parameter;
    const core::Point mc = (span + 2 < samples.size() ? tangent(b, c, at(span + 2)) : core::Point{}) * parameter;
    const double sideways = std::max(std::abs(core::cross(mb, c - b)), std::abs(core::cross(mc, c - b)));
    const bool bent = sideways > kStraightPx * chord;
    const int pieces = bent ? std::clamp(static_cast<int>(std::ceil(chord / kPiecePx)), 1, 48) : 1;
    core::Point from = b;
    double r_from = rb;
    for (int i = 1; i <= pieces; ++i) {
        const double t = static_cast<double>(i) / pieces, t2 = t * t, t3 = t2 * t;
        // a missing tangent is the one that bends least: towards the other end
        const core::Point straight = c - b;
        const core::Point tb = mb != core::Point{} ? mb : straight, tc = mc != core::Point{} ? mc : straight;
        const core::Point to =
            i == pieces ? c
                        : b * (2 * t3 - 3 * t2 + 1) + tb * (t3 - 2 * t2 + t) + c * (3 * t2 - 2 * t3) + tc * (t3 - t2);
        const double r_to = rb + (rc - rb) * t;
        out.push_back(piece(from, to, r_from, r_to));
        from = to;
        r_from = r_to;
    }
}

}  // namespace ui
