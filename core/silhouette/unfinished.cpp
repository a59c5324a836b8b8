#include "core/silhouette/unfinished.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace core {
namespace {

constexpr double kMuchLess = 0.6;
constexpr double kWorthALook = 0.5;  // of the area now: a ring smaller than this adds too little

/// What the samples enclose as a ring, the drawing's square units; a figure of eight has less than its parts.
double ring_area(const std::vector<PenSample>& samples) {
    double twice = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const PenSample &a = samples[i], &b = samples[(i + 1) % samples.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return std::abs(twice) / 2;
}

/// In the drawing's square units.
double area(const Silhouette& silhouette) {
    const auto& pixels = silhouette.image.pixels;
    const auto object = static_cast<double>(std::count(pixels.begin(), pixels.end(), std::uint8_t{1}));
    return object / (silhouette.raster.scale * silhouette.raster.scale);
}

}  // namespace

std::optional<Silhouette> UnfinishedReading::look_ahead(const Drawing& drawing, const Silhouette& plain) {
    if (drawing.strokes.empty() || drawing.strokes.back().samples.size() < 3) return std::nullopt;
    const std::vector<PenSample>& samples = drawing.strokes.back().samples;
    const double now = area(plain);
    if (ring_area(samples) < kWorthALook * now) return std::nullopt;
    Drawing closed = drawing;
    closed.strokes.push_back({{samples.back(), samples.front()}});
    closed_.follow(closed);
    Result<Silhouette> silhouette = closed_.silhouette();
    if (!silhouette || now >= kMuchLess * area(*silhouette)) return std::nullopt;
    return std::move(*silhouette);
}

}  // namespace core
