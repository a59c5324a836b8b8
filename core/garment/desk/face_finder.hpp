#pragma once
// Outlines close by themselves: the smallest faces between the lines of a layer, on the body's side of space, and what
// keeps the others open.
//
// About each vertex lines are put in order by their angle in the plane across the way out of the body, and faces are
// walked with the next line to the left, as in a plane map. Where that angle says little (an armpit, a line that leaves
// straight away from the body) the order is the one that leaves the map without handles. Of all faces those are cloth
// that turn once about themselves: the sum of the turns at their vertices and along their lines, measured about the way
// out of the body, is that of a disc (2 pi less the curvature of the body below, Gauss and Bonnet). The opening of a
// sleeve or a hem turns by about 0, what lies outside of a piece by -2 pi. Besides, cloth faces the way out of the body
// somewhere on its border, and an opening nowhere. Nothing depends on a view or on the order in which lines were drawn.

#include <string>
#include <vector>

#include "core/garment/network.hpp"
#include "core/garment/obstacle.hpp"

namespace core {

struct NetworkFace {
    std::vector<LineUse> ring;  ///< anti-clockwise seen from outside of the body
    double turn_rad = 0.0;      ///< cloth: above pi
    double facing = 0.0;        ///< cosine between the face's normal and the way out that a tenth of its border exceeds
    bool is_opening = false;    ///< a limb, the trunk or the head passes through it
    [[nodiscard]] bool is_cloth() const;
};

/// Every face of the layer, cloth or not, without loose ends; those of one component in the order of their first line.
/// Faces that pass a line twice are left out. Cost: some field samples a point of a line.
[[nodiscard]] std::vector<NetworkFace> find_faces(const Network& network, int layer, const Obstacle& body);

/// A face that is cloth and that no region fills.
struct OpenFace {
    std::vector<LineUse> ring;
    std::string part_of;  ///< the region that lines drawn across it part into this face and others; mostly empty
};

/// In the order of their first lines. Outlines of regions that were taken away, and holes, are none.
[[nodiscard]] std::vector<OpenFace> open_faces(const Network& network, int layer, const Obstacle& body);

/// An end of a line that meets no other. Lines drawn a little past another (up to twice snap_cm) are no fault.
struct OpenEnd {
    Vec3 place;
    std::string line;
    double gap_cm = 0.0;  ///< to the nearest place of another line, or of its own other end; 0 where there is none
    std::string nearest;  ///< that line
    Vec3 nearest_place;
};
[[nodiscard]] std::vector<OpenEnd> open_ends(const Network& network, int layer);

/// The names of a ring's lines as a Region step has them: once where all pieces of the name are in the ring, else with
/// their numbers. In ring order.
[[nodiscard]] std::vector<std::string> names_of_ring(const Network& network, int layer,
                                                     const std::vector<LineUse>& ring);

}  // namespace core
