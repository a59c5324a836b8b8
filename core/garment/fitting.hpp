#pragma once
// Cloth comes off the body: what is inside is moved out, and the cloth is made even again, in turn (thesis 3.3).
//
// Each vertex keeps to the side of the body that the cloth was drawn on: it moves out along the cloth's own outward
// direction where the body's surface would lead it elsewhere (between the legs, under an arm).

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
    double mean_stretch = 0.0, largest_stretch = 0.0;        ///< of edges, against their lengths before: 0.02 is 2 %
};

/// Fits a cloth to an obstacle. Drawn vertices move only to come off it. Cost: some 20 field samples a vertex and
/// round.
FittingReport fit_cloth(Cloth& cloth, const Obstacle& obstacle, const FittingOptions& options);

}  // namespace core
