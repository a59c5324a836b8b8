#pragma once
// The second layout of a part descriptor: what cannot be measured again, in as few bits as that takes. Of use inside
// db/codec only; descriptor_codec.hpp is the way in.
//
// Samples lie on the grid of core/parts/rounding.hpp. Each is written as its distance from where the two before it lead
// to, which is small between corners; then where each part starts and ends, and for a wing which terminals it groups.
// Features, signatures and `whole` are measured when it is read. About 190 bytes for 100 samples and 17 parts:
//
//     samples (varint), grid (u8), order of the code (u8), first sample (2 svarint), terminals (varint), wings
//     (varint), stop points are those of the parts or follow (u8), skeletal length (f32), then bits: the other samples,
//     the terminals (start, end, salient), the wings (first, count - 1, start, end, salient), stop points if they
//     follow.

#include "core/parts/descriptor.hpp"
#include "db/codec/bytes.hpp"

namespace db {

/// Whether the layout can hold the descriptor once it is rounded: terminals stand first and in order, there are at most
/// 512 samples, 255 parts, so that reading takes bounded time, and no coordinate is beyond 2^29.
[[nodiscard]] bool fits_compact(const core::ShapeDescriptor& descriptor);

/// Appends a descriptor that fits and came from core::rounded.
void write_compact(ByteWriter& out, const core::ShapeDescriptor& rounded);

/// Faults are kept in the reader, and the descriptor is then worthless. About 2 us a part.
[[nodiscard]] core::ShapeDescriptor read_compact(ByteReader& in);

}  // namespace db
