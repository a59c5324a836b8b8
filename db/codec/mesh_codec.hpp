#pragma once
// A triangle mesh for display as a blob: its normalised frame on a grid of 16 bits, neighbours written as differences.
//
// A vertex moves by at most 1/65534 per axis, half a step of the 65535 lines from -1 to 1, and a mesh that came out of
// a blob goes in and out again unchanged. Colours, the order of vertices and triangles, and winding are exact.

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"
#include "db/codec/bytes.hpp"

namespace db {

/// 3 to 9 bytes a vertex, 3 or more a triangle, 4 or more a run of vertices of one colour. BadMesh for a vertex outside
/// [-1, 1] (by more than 1e-6), an index without a vertex, or colours that are neither none nor one a vertex.
[[nodiscard]] core::Result<Blob> encode_mesh(const core::TriangleMesh& mesh);

/// Damaged for bytes that encode_mesh cannot have written. Time and memory linear in the size of the blob.
[[nodiscard]] core::Result<core::TriangleMesh> decode_mesh(BlobView blob);

}  // namespace db
