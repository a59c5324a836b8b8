#pragma once
// The part descriptor of a shape as a blob: about 90 bytes a part and 4 a sample, so 2.7 kB for 24 parts.
//
// Features, signatures, the skeletal length and all numbers of samples and parts are exact. The outline samples, which
// serve for pictures and chords, are rounded to the grid of points_codec.hpp: decode(encode(d)) differs from d in them
// by less than 1/65534 of the shape's box, and decode(encode(.)) of that again is equal in every bit.
//
// A new field: a new version number, its writer, and a reader of its own in descriptor_codec.cpp; the old readers stay.

#include "core/base/result.hpp"
#include "core/parts/descriptor.hpp"
#include "db/codec/bytes.hpp"

namespace db {

/// BadArgument for a descriptor that breaks the promises of descriptor.hpp: parts or stop points that name terminals or
/// samples which are not there, fewer parts than terminals, stop points out of order, numbers that are not finite.
[[nodiscard]] core::Result<Blob> encode_descriptor(const core::ShapeDescriptor& descriptor);

/// Damaged for bytes that encode_descriptor cannot have written: what comes out keeps the promises of descriptor.hpp.
/// Time and memory linear in the size of the blob, whatever it says.
[[nodiscard]] core::Result<core::ShapeDescriptor> decode_descriptor(BlobView blob);

}  // namespace db
