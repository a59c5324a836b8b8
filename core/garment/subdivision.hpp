#pragma once
// Cloth made finer and smooth: Catmull-Clark surfaces with creases on hems and seams.

#include "core/base/result.hpp"
#include "core/garment/cloth.hpp"

namespace core {

/// The cloth after `levels` (1 to 3) of Catmull-Clark subdivision, each quad four. Hems and seams stay where they are
/// but for their own smoothing along themselves; the corners of hems stay. Pieces keep their names and order,
/// and texture, where there is any, follows each piece on its own.
/// ErrorCode:: BadArgument for another number of levels, ErrorCode::BadMesh for quads that subdivide badly. Linear in
/// the result.
[[nodiscard]] Result<Cloth> subdivided(const Cloth& cloth, int levels);

}  // namespace core
