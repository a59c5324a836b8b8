#pragma once
// Points of the plane on a grid of 16 bits, and polygons as blobs of their own.
//
// The grid step is a power of two, the finest for which the bounding box has at most 65535 steps a side, and the grid
// passes through the origin. So a point moves by at most half a step, less than box / 65534 (or |coordinate| / 2^40,
// where the box is tiny and far away). Points that came out of a blob are grid points: encoding them again changes
// nothing. Points with pixel or half-pixel coordinates are exact as long as the box is less than 32767 pixels wide.

#include <vector>

#include "core/base/result.hpp"
#include "core/geometry/point.hpp"
#include "db/codec/bytes.hpp"

namespace db {

/// Appends the points, in order: 2 to 6 bytes each, about 4 for 100 samples of an outline. The coordinates must be
/// finite and at most 2^30 in size, else BadOutline.
[[nodiscard]] core::Result<void> write_points(ByteWriter& out, const std::vector<core::Point>& points);

/// What write_points wrote. Faults are kept in the reader, and the points are then worthless.
[[nodiscard]] std::vector<core::Point> read_points(ByteReader& in);

/// A polygon (also an empty one) as a blob. BadOutline as write_points.
[[nodiscard]] core::Result<Blob> encode_polygon(const core::Polygon& ring);

/// Damaged for bytes that encode_polygon cannot have written.
[[nodiscard]] core::Result<core::Polygon> decode_polygon(BlobView blob);

}  // namespace db
