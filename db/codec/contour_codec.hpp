#pragma once
// The whole-contour descriptor of a shape as a blob: 1.67 kB, every number exact, so that stored and fresh descriptors
// match alike to the last bit.
//
// Another layout of the numbers, or another count of points, stretches, rings or sectors in core: a new version number,
// and a reader of its own in contour_codec.cpp or Damaged for the old one, which makes the index describe the model
// again.

#include "core/base/result.hpp"
#include "core/contour/contour_descriptor.hpp"
#include "db/codec/bytes.hpp"

namespace db {

/// BadArgument for a descriptor that breaks the promises of contour_descriptor.hpp: a height or a distance ahead beyond
/// its greatest, a complexity that is not in [0, 1].
[[nodiscard]] core::Result<Blob> encode_contour(const core::ContourDescriptor& descriptor);

/// Damaged for bytes that encode_contour cannot have written: what comes out keeps the promises of
/// contour_descriptor.hpp.
[[nodiscard]] core::Result<core::ContourDescriptor> decode_contour(BlobView blob);

}  // namespace db
