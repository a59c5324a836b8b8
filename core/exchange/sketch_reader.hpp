#pragma once
// One way in for everything that can be a query: a picture or strokes, whatever the file is called.
//
//     const core::Result<core::Sketch> sketch = core::read_sketch("horse.ndjson:3");

#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/silhouette/image.hpp"
#include "core/stroke/stroke.hpp"

namespace core {

/// Exactly one of the two is set.
struct Sketch {
    std::optional<Drawing> drawing;
    std::optional<GrayImage> image;
};

/// Reads PNG, BMP, JPEG, SVG, InkML, a Quick, Draw! line ("file.ndjson:N", N from 0, 0 without it) or a stroke list.
/// What the file holds decides, its extension only where that leaves a doubt. UnknownFormat when it is none of these;
/// the readers' own errors otherwise, with the path in `where`.
[[nodiscard]] Result<Sketch> read_sketch(const std::string& path_spec);

}  // namespace core
