#pragma once
// A body that a user brings, stood up like a mannequin.

#include "core/base/result.hpp"
#include "core/mesh/triangle_mesh.hpp"

namespace core {

/// The mesh in centimetres, y up, feet on y = 0, facing +z, its middle on x = 0, faces anti-clockwise seen from
/// outside, without colours. What is up is found from the legs, two like pieces of a low cut, and the head, one piece
/// of a high one; front is where the toes are; the unit is the one of metres, centimetres, millimetres, inches and feet
/// that makes a height from 120 to 215 cm, and without any the height becomes 170 cm. Legs that touch below the knee
/// are not found. ErrorCode::BadMesh when it is not closed, ErrorCode::EmptyMesh without faces, ErrorCode::BadMesh when
/// no side up shows legs and a head.
[[nodiscard]] Result<TriangleMesh> stand_body(const TriangleMesh& mesh);

}  // namespace core
