#pragma once
// Copies of a picture that show the same shape: moved, with ink and page exchanged, turned, scaled, mirrored; and what
// of a descriptor must stay the same under them.

#include <cmath>
#include <numbers>

#include "core/parts/descriptor.hpp"
#include "core/silhouette/image.hpp"

namespace support {

/// On a page that is 40 pixels wider and higher, so dx and dy go from 0 to 40.
inline core::GrayImage moved(const core::GrayImage& image, int dx, int dy) {
    core::GrayImage out(image.width + 40, image.height + 40);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) out.pixels[out.index(x + dx, y + dy)] = image.at(x, y);
    }
    return out;
}

inline core::GrayImage inverted(core::GrayImage image) {
    for (auto& p : image.pixels) p = static_cast<std::uint8_t>(255 - p);
    return image;
}

/// Between pixels, black outside the picture.
inline double bilinear(const core::GrayImage& image, double x, double y) {
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const auto at = [&](int cx, int cy) {
        return cx < 0 || cy < 0 || cx >= image.width || cy >= image.height ? 0.0 : double(image.at(cx, cy));
    };
    const double u = x - left, v = y - top;
    return (at(left, top) * (1 - u) + at(left + 1, top) * u) * (1 - v) +
           (at(left, top + 1) * (1 - u) + at(left + 1, top + 1) * u) * v;
}

/// White on black: turned about the middle and scaled, on a page that holds it, four samples a pixel.
inline core::GrayImage turned(const core::GrayImage& image, double degrees, double scale, bool mirrored) {
    const double angle = degrees * std::numbers::pi / 180.0, c = std::cos(angle), s = std::sin(angle);
    const int side = static_cast<int>(std::ceil(std::hypot(image.width, image.height) * scale)) + 8;
    core::GrayImage out(side, side);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            double sum = 0.0;
            for (const double dx : {-0.25, 0.25}) {
                for (const double dy : {-0.25, 0.25}) {
                    const double px = (x + dx - 0.5 * (side - 1)) / scale, py = (y + dy - 0.5 * (side - 1)) / scale;
                    const double turned_x = c * px + s * py, turned_y = -s * px + c * py;
                    sum += bilinear(image, (mirrored ? -turned_x : turned_x) + 0.5 * (image.width - 1),
                                    turned_y + 0.5 * (image.height - 1));
                }
            }
            out.pixels[out.index(x, y)] = sum >= 4 * 127.5 ? 255 : 0;
        }
    }
    return out;
}

/// Whether everything is the same to the last bit and the samples differ by one shift alone.
inline bool same_but_for_place(const core::ShapeDescriptor& a, const core::ShapeDescriptor& b) {
    if (a.parts != b.parts || a.stop_points != b.stop_points || a.whole != b.whole ||
        a.terminal_count != b.terminal_count || a.skeletal_length != b.skeletal_length ||
        a.samples.size() != b.samples.size()) {
        return false;
    }
    const core::Point shift = b.samples.front() - a.samples.front();
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
        if (core::distance(a.samples[i] + shift, b.samples[i]) > 1e-9) return false;
    }
    return true;
}

}  // namespace support
