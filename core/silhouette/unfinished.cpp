#include "core/silhouette/unfinished.hpp"

#include <algorithm>
#include <utility>

namespace core {
namespace {

constexpr double kMuchLess = 0.6;

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
    Drawing closed = drawing;
    closed.strokes.push_back({{samples.back(), samples.front()}});
    closed_.follow(closed);
    Result<Silhouette> silhouette = closed_.silhouette();
    if (!silhouette || area(plain) >= kMuchLess * area(*silhouette)) return std::nullopt;
    return std::move(*silhouette);
}

}  // namespace core
