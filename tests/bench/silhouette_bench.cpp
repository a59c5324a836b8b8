// What a sample costs the silhouette that grows with the pen, and what the whole costs in one go.

#include <catch2/catch.hpp>
#include <cmath>

#include "core/silhouette/live_silhouette.hpp"

namespace {

/// A body with a tail in one line of a steady hand, 400 × 300 units, that closes with its last sample.
core::Drawing body() {
    core::Stroke stroke;
    for (int i = 0; i <= 360; ++i) {
        const double a = i * 3.14159265358979 / 180;
        const double r = 90 + 22 * std::sin(3 * a) + 45 * std::exp(-std::pow((i - 200) / 14.0, 2));
        stroke.samples.push_back({i * 8'000, 200 + 1.4 * r * std::cos(a), 150 + r * std::sin(a), 1.0});
    }
    return {{stroke}};
}

core::Drawing first_samples(const core::Drawing& whole, std::size_t count) {
    core::Drawing part = whole;
    part.strokes[0].samples.resize(count);
    return part;
}

}  // namespace

TEST_CASE("the silhouette of a growing drawing", "[silhouette]") {
    const core::Drawing whole = body();
    std::vector<core::Drawing> steps;
    for (std::size_t n = 1; n <= whole.strokes[0].samples.size(); ++n) steps.push_back(first_samples(whole, n));

    BENCHMARK("all 361 samples one by one, with a silhouette after each") {
        core::LiveSilhouette live;
        std::size_t pixels = 0;
        for (const core::Drawing& step : steps) {
            live.follow(step);
            if (const auto s = live.silhouette()) pixels += s->image.pixels.size();
        }
        return pixels;
    };
    BENCHMARK_ADVANCED("one sample more, at two thirds")(Catch::Benchmark::Chronometer meter) {
        std::vector<core::LiveSilhouette> live;
        for (int i = 0; i < meter.runs(); ++i) {
            live.emplace_back();
            live.back().follow(steps[240]);
        }
        meter.measure([&](int i) { live[static_cast<std::size_t>(i)].follow(steps[241]); });
    };
    BENCHMARK("the whole in one go") {
        return core::find_silhouette(whole, {}).has_value();
    };
}
