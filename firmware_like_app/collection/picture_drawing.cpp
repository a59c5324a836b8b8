#include "firmware_like_app/collection/picture_drawing.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/silhouette/closing.hpp"
#include "core/silhouette/contour.hpp"

namespace app {

core::Result<core::Drawing> drawing_of_picture(const core::GrayImage& picture) {
    constexpr std::size_t kMostSamples = 800;
    constexpr std::int64_t kAround_us = 4000000;
    const core::Result<core::Silhouette> silhouette = core::find_silhouette(picture, {});
    if (!silhouette) return core::unexpected(silhouette.error());
    const core::Result<core::Polygon> ring = core::largest_contour(silhouette->image);
    if (!ring) return core::unexpected(ring.error());
    const std::size_t samples = std::min(kMostSamples, ring->size());
    core::Stroke stroke;
    for (std::size_t k = 0; k <= samples; ++k) {  // the last is the first again
        const core::Point p = (*ring)[k * ring->size() / samples % ring->size()];
        const core::Point place = silhouette->raster.to_drawing({p.x, -p.y});
        const auto time_us = static_cast<std::int64_t>(k) * kAround_us / static_cast<std::int64_t>(samples);
        stroke.samples.push_back({time_us, place.x, place.y, 1.0});
    }
    return core::Drawing{{stroke}};
}

}  // namespace app
