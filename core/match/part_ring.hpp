#pragma once
// A descriptor made ready for matching: its parts read anti-clockwise or clockwise, weights multiplied in, the
// inter-distance matrix of thesis 5.4 filled.

#include <array>
#include <vector>

#include "core/match/lanes.hpp"
#include "core/match/outline_profile.hpp"
#include "core/parts/descriptor.hpp"
#include "core/skeleton/shape_parameters.hpp"

namespace core {

/// (d_E, d_BE, d_A) from the end of one part to the start of a later one, each times its weight.
struct InterDistance {
    float d_e = 0.0F;   ///< straight distance / perimeter
    float d_be = 0.0F;  ///< per cent of the bending energy between them
    float d_a = 0.0F;   ///< angle between their directions, degrees in [0, 180]
};

/// One part in the order of the ring.
struct RingPart {
    int part = 0;   ///< index into ShapeDescriptor::parts
    int first = 0;  ///< first terminal, counted in the ring's direction
    int count = 1;
    OutlinePlace from = 0, to = 0;  ///< of its arc, in the ring's direction
    std::array<float, kFeatureCount> weighted{};
    std::array<float, kSignatureSize> signature{};
    float norm = 0.0F;  ///< eq. 5.3
    float spared =
        0.0F;  ///< sum of the norms of its terminals: what leaving them all out would cost, in steps of 2^-11
};

/// The ring cut open before one stop point: parts that run over the cut are gone.
struct OpenedRing {
    struct Member {
        int part = 0;    ///< index into PartRing::parts
        int before = 0;  ///< as many members end before this one starts, and they are the first in `members`
    };
    /// Inter-distances from a group of kWideLanes members to a later one; d_e is infinite from members that do not end
    /// before it.
    struct Step {
        WideLanes d_e{}, d_be{}, d_a{};
    };
    std::vector<Member> members;  ///< by the position at which they end, ascending
    std::vector<Step> steps;      ///< by the group of members they lead from, then by the one they lead to
    std::vector<int> steps_to;    ///< where each step leads to, as index into `members`
    std::vector<int> steps_from;  ///< steps of group g: steps_from[g] … steps_from[g + 1]
};

/// A group of parts, one a lane.
struct PartGroup {
    std::array<LaneGroup, kFeatureCount> weighted{};
    std::array<LaneGroup, kSignatureSize> signature{};
    LaneGroup spared;
};

struct PartRing {
    int terminal_count = 0;
    std::vector<RingPart> parts;       ///< as in the descriptor: terminals first
    std::vector<PartGroup> groups;     ///< the same parts, group by group; nought where there are no more
    std::vector<float> terminal_norm;  ///< by terminal in the ring's direction
    float norms = 0.0F;                ///< their sum, in steps of 2^-11
    std::vector<int> stop_points;      ///< in the ring's direction
    std::vector<OpenedRing> opened;    ///< one per stop point
    OutlineProfile outline;            ///< read in the ring's direction
    std::vector<InterDistance> inter;  ///< parts x parts, row: from
    [[nodiscard]] const InterDistance& between(std::size_t from, std::size_t to) const {
        return inter[from * parts.size() + to];
    }
};

/// Both readings of one shape.
struct MatchableShape {
    PartRing forwards;       ///< anti-clockwise
    PartRing backwards;      ///< clockwise: what the mirror image would read
    PairedHeights paired{};  ///< of the outline forwards: for bounds
};

/// Quadratic in the number of parts.
[[nodiscard]] MatchableShape matchable(const ShapeDescriptor& shape, const ShapeParameters& parameters = {});

/// Eq. 5.2: Euclidean distance of the weighted features plus squared distance of the signatures. >= 0, symmetric.
[[nodiscard]] float node_distance(const RingPart& a, const RingPart& b);

}  // namespace core
