#pragma once
// Cloth comes off the body: what is inside is moved out, and the cloth is made even again, in turn (thesis 3.3).
//
// Each piece keeps to the parts of the body that it is associated with (ClothPiece::parts, thesis 3.3): where a vertex
// came into another part (the other leg, the trunk under an arm) it moves back towards its own parts' surface and not
// to the nearest way out. Where parts are not known it moves out along the cloth's own outward direction if the body's
// surface would lead it elsewhere. At last cloth that passes through cloth of its own layer is parted: facing sheets
// draw back, of sheets that lie over each other the outer one moves out.

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/cloth.hpp"
#include "core/garment/obstacle.hpp"

namespace core {

enum class Fairing {
    Optimised,  ///< inner vertices go to where their neighbours' mask puts them: smooth
    Particles,  ///< the cloth's edges and diagonals keep their lengths as far as they can: XPBD (Macklin and others
                ///< 2016)
};

struct FittingOptions {
    double clearance_cm = 0.25;  ///< of vertices and of places between them, from the obstacle
    int rounds = 12;
    Fairing fairing = Fairing::Optimised;
    double strength = 0.5;  ///< of each round of fairing, 0 … 1
};

struct FittingReport {
    double deepest_before_cm = 0.0, deepest_after_cm = 0.0;  ///< of vertices and places between them inside it; 0: none
    double closest_cm = 0.0;                                 ///< least distance after; clearance_cm or a little less
    std::size_t self_crossings_before = 0, self_crossings = 0;  ///< pairs of quads of the layer through each other
    double mean_stretch = 0.0, largest_stretch = 0.0;           ///< of edges, against their lengths before: 0.02 is 2 %
};

/// Fits a cloth to an obstacle. Drawn vertices move only to come off it, and off the cloth itself. What could not be
/// resolved is in the report; fitting_warning puts it into words. Cost: some 20 field samples a vertex and round.
FittingReport fit_cloth(Cloth& cloth, const Obstacle& obstacle, const FittingOptions& options);

/// What a fit left unresolved, in one sentence that says what to do; empty when all is well.
[[nodiscard]] std::string fitting_warning(const FittingReport& report);

}  // namespace core
