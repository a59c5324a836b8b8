#include "ui/draw/palette.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

double to_linear(double v) {
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Triple times(const Matrix& m, const Triple& v) {
    Triple out{};
    for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return out;
}

constexpr Matrix kToXyz{
    {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.072175}, {0.0193339, 0.119192, 0.9503041}}};
/// Machado, Oliveira, Fernandes 2009, severity 1; on linear light.
constexpr Matrix kTypical{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kNoRed{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kNoGreen{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.01182, 0.04294, 0.968881}}};
constexpr Matrix kNoBlue{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.3039}}};

Triple linear(const ui::Colour& c) {
    return {to_linear(c.r), to_linear(c.g), to_linear(c.b)};
}

Triple lab(const ui::Colour& colour, const Matrix& sight) {
    Triple seen = times(sight, linear(colour));
    for (double& v : seen) v = std::clamp(v, 0.0, 1.0);
    const Triple xyz = times(kToXyz, seen);
    const auto f = [](double v) { return v > 216.0 / 24389 ? std::cbrt(v) : (24389.0 / 27 * v + 16) / 116; };
    const double x = f(xyz[0] / 0.95047), y = f(xyz[1]), z = f(xyz[2] / 1.08883);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// CIEDE2000 (Sharma, Wu, Dalal 2005), all weights 1.
double difference(const Triple& p, const Triple& q) {
    const double pi = std::numbers::pi, degree = pi / 180;
    const auto seventh = [](double c) { return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25.0, 7))); };
    const double g = 0.5 * (1 - seventh((std::hypot(p[1], p[2]) + std::hypot(q[1], q[2])) / 2));
    const double a1 = (1 + g) * p[1], a2 = (1 + g) * q[1];
    const double c1 = std::hypot(a1, p[2]), c2 = std::hypot(a2, q[2]);
    const auto hue = [&](double a, double b) { return std::fmod(std::atan2(b, a) / degree + 360, 360); };
    const double h1 = hue(a1, p[2]), h2 = hue(a2, q[2]);
    const double dh = std::remainder(h2 - h1, 360);
    const double turn = 2 * std::sqrt(c1 * c2) * std::sin(dh / 2 * degree);
    double h = (h1 + h2) / 2;
    if (std::abs(h1 - h2) > 180) h += h < 180 ? 180 : -180;
    const double l = (p[0] + q[0]) / 2, c = (c1 + c2) / 2;
    const double t = 1 - 0.17 * std::cos((h - 30) * degree) + 0.24 * std::cos(2 * h * degree) +
                     0.32 * std::cos((3 * h + 6) * degree) - 0.20 * std::cos((4 * h - 63) * degree);
    const double sl = 1 + 0.015 * (l - 50) * (l - 50) / std::sqrt(20 + (l - 50) * (l - 50));
    const double dl = (q[0] - p[0]) / sl, dc = (c2 - c1) / (1 + 0.045 * c), dt = turn / (1 + 0.015 * c * t);
    const double rt = -std::sin(60 * std::exp(-std::pow((h - 275) / 25, 2)) * degree) * 2 * seventh(c);
    return std::sqrt(dl * dl + dc * dc + dt * dt + rt * dc * dt);
}

double luminance(const ui::Colour& c) {
    return times(kToXyz, linear(c))[1];
}

double contrast(const ui::Colour& a, const ui::Colour& b) {
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace

TEST_CASE("the difference of colours is the published one", "[palette]") {
    CHECK(difference({50, 2.6772, -79.7751}, {50, 0, -82.7485}) == Approx(2.0425).margin(1e-4));
    CHECK(difference({50, 2.5, 0}, {73, 25, -18}) == Approx(27.1492).margin(1e-4));
    CHECK(difference({2.0776, 0.0795, -1.135}, {0.9033, -0.0636, -0.5514}) == Approx(0.9082).margin(1e-4));
}

TEST_CASE("colours of parts are told apart in any sight, and so is what is live", "[palette]") {
    using ui::palette::PartPalette;
    for (const PartPalette palette : {PartPalette::Soft, PartPalette::Strong}) {
        const ui::palette::PartColours& colours = ui::palette::part_colours(palette);
        for (const Matrix* sight : {&kTypical, &kNoRed, &kNoGreen, &kNoBlue}) {
            for (std::size_t i = 0; i < colours.parts.size(); ++i) {
                const Triple one = lab(colours.parts[i], *sight);
                CHECK(difference(one, lab(ui::palette::kSanguine, *sight)) >= 12);
                for (std::size_t k = i + 1; k < colours.parts.size(); ++k) {
                    CHECK(difference(one, lab(colours.parts[k], *sight)) >= (sight == &kTypical ? 20 : 15));
                }
            }
        }
        for (std::size_t i = 0; i < colours.parts.size(); ++i) {
            CHECK(contrast(colours.parts[i], colours.tag_text[i]) >= 4.3);
        }
    }
}

TEST_CASE("the palette that was chosen is the one in use", "[palette]") {
    const ui::palette::PartPalette before = ui::palette::chosen_parts();
    ui::palette::choose_parts(ui::palette::PartPalette::Strong);
    CHECK(ui::palette::parts() == ui::palette::part_colours(ui::palette::PartPalette::Strong).parts);
    ui::palette::choose_parts(ui::palette::PartPalette::Soft);
    CHECK(ui::palette::parts() == ui::palette::part_colours(ui::palette::PartPalette::Soft).parts);
    ui::palette::choose_parts(before);
}
