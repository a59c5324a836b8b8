#pragma once
// Outlines laid into small black and white pictures, for tests of everything that starts from pixels.

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/geometry/point.hpp"
#include "core/silhouette/image.hpp"

namespace support {

/// The pixels whose centres lie inside the rings (even-odd, so overlaps are holes). Integer coordinates are the middles
/// of pixels; y up, so the top row is the highest. Pixels outside the page are not drawn.
inline core::BinaryImage rastered(const std::vector<core::Polygon>& rings, int width, int height) {
    core::BinaryImage image(width, height);
    for (int row = 0; row < height; ++row) {
        const double y = height - 1 - row;
        std::vector<double> crossings;
        for (const core::Polygon& ring : rings) {
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const core::Point a = ring[i], b = ring[(i + 1) % ring.size()];
                if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
            }
        }
        std::sort(crossings.begin(), crossings.end());
        for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
            const int from = std::max(0, static_cast<int>(std::ceil(crossings[k])));
            const int to = std::min(width - 1, static_cast<int>(std::floor(crossings[k + 1])));
            for (int x = from; x <= to; ++x) image.at(x, row) = 1;
        }
    }
    return image;
}

/// The outline scaled so that its box's longer side has `size` pixels, on a page with a margin around it.
inline core::BinaryImage silhouette_of(core::Polygon ring, double size, double margin = 8) {
    core::Point low = ring.front(), high = ring.front();
    for (const core::Point& p : ring) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double scale = size / std::max(high.x - low.x, high.y - low.y);
    for (core::Point& p : ring) p = (p - low) * scale + core::Point{margin, margin};
    return rastered({ring}, static_cast<int>(std::ceil((high.x - low.x) * scale + 2 * margin)),
                    static_cast<int>(std::ceil((high.y - low.y) * scale + 2 * margin)));
}

/// Ink black, page white, or the other way round.
inline core::GrayImage as_gray(const core::BinaryImage& image, bool white_ink) {
    core::GrayImage gray(image.width, image.height);
    for (std::size_t i = 0; i < gray.pixels.size(); ++i) gray.pixels[i] = (image.pixels[i] != 0) == white_ink ? 255 : 0;
    return gray;
}

}  // namespace support
