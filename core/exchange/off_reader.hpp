#pragma once
// Reads the text of an Object File Format (.off) mesh, the format of the Princeton Shape Benchmark.

#include <string_view>

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// The triangles of an OFF text. Read are: the header words OFF, COFF, NOFF, CNOFF, STOFF and their like, a header with
/// the counts on its own line or run into it ("OFF490 518 0"), or none at all; comments from # to the end of the line;
/// one vertex a line, with colours where the header promises them; faces of any number of corners (concave ones are cut
/// properly), each with a colour after its corners as 3 or 4 numbers, 0 … 255 or 0.0 … 1.0. Normals, texture
/// coordinates, colour-table numbers and whatever follows the last face are passed over; so are faces of fewer than
/// three corners, with a corner that is not finite, or with two corners in one place. Nothing is reserved on the word
/// of the header: counts that the text is too short for give BadFormat, as do binary and four-dimensional files, a word
/// that is no number, and an end in the middle. A corner number out of range gives BadMesh, and no usable face
/// EmptyMesh. Errors name the line; `where` is left empty. Linear time and memory.
[[nodiscard]] Result<TriangleMesh> read_off(std::string_view text);

}  // namespace core
