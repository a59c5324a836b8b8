#pragma once
// The part descriptor of a shape as a blob. Two layouts:
//
// - 2, compact: about 190 bytes for 100 samples and 17 parts. For every descriptor whose parts are measured from its
//   samples, as core::describe makes them. What comes back is core::rounded(descriptor), in every bit: the samples lie
//   on a grid, and the parts are measured again from them. So it does not matter whether a search takes stored
//   descriptors or fresh ones that it rounded.
// - 1, full: about 90 bytes a part and 4 a sample, so 2.7 kB for 24 parts. For all others. Features, signatures, the
//   skeletal length and all numbers of samples and parts are exact; samples are rounded to the grid of points_codec.hpp
//   and differ by less than 1/65534 of the shape's box.
//
// Either way decode(encode(.)) of what was decoded is equal in every bit.
//
// A new field: a new version number, its writer, and a reader of its own; the old readers stay. Where the features of a
// part change, compact blobs give the new ones without being written anew.

#include "core/base/result.hpp"
#include "core/parts/descriptor.hpp"
#include "db/codec/bytes.hpp"

namespace db {

/// BadArgument for a descriptor that breaks the promises of descriptor.hpp: parts or stop points that name terminals or
/// samples which are not there, fewer parts than terminals, stop points out of order, numbers that are not finite.
[[nodiscard]] core::Result<Blob> encode_descriptor(const core::ShapeDescriptor& descriptor);

/// Damaged for bytes that encode_descriptor cannot have written: what comes out keeps the promises of descriptor.hpp.
/// Memory linear in the size of the blob, whatever it says; time too, with the features of a compact descriptor's parts
/// to be measured: about 2 us a part, and 50 ms at the very most for one descriptor.
[[nodiscard]] core::Result<core::ShapeDescriptor> decode_descriptor(BlobView blob);

}  // namespace db
