#pragma once
// Small images drawn as text: '#' is the object, anything else the page.

#include <initializer_list>
#include <string_view>

#include "core/silhouette/image.hpp"

namespace support {

/// One string a row, all of the length of the first.
inline core::BinaryImage text_shape(std::initializer_list<std::string_view> rows) {
    core::BinaryImage image(static_cast<int>(rows.begin()->size()), static_cast<int>(rows.size()));
    int y = 0;
    for (const std::string_view row : rows) {
        for (std::size_t x = 0; x < row.size(); ++x) image.at(static_cast<int>(x), y) = row[x] == '#' ? 1 : 0;
        ++y;
    }
    return image;
}

/// The image in the middle of a page that is larger by these margins.
inline core::BinaryImage with_margin(const core::BinaryImage& image, int left, int top, int right, int bottom) {
    core::BinaryImage page(image.width + left + right, image.height + top + bottom);
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) page.at(x + left, y + top) = image.at(x, y);
    }
    return page;
}

}  // namespace support
