#pragma once
// The network of lines a garment is drawn with, and the regions of cloth between them (thesis 3.1).
//
//     core::Network net;
//     net.add_line("waist", points);  net.add_line("side", more);  …
//     net.add_region("front", {"waist", "side", "hem", "middle"}, &body);
//     net.cut("front", points, "yoke");
//
// Lines meet at vertices only: an end drawn near a vertex or a line is welded to it, and a line that is met in its
// middle is split, both halves keeping its name. Every line has an even number of edges, whatever is cut or split, so
// that every region has an even boundary and can be filled. Lines run along both regions they part: seams have equal
// edges on both sides. A network is a value; keep a copy to undo (see NetworkHistory).

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/garment/obstacle.hpp"
#include "core/garment/region.hpp"
#include "core/geometry/space_line.hpp"
#include "core/mannequin/part_set.hpp"

namespace core {

/// A line as a region passes it.
struct LineUse {
    int line = 0;
    bool reversed = false;
    friend bool operator==(const LineUse&, const LineUse&) = default;
};

struct NetworkVertex {
    Vec3 place;
    int layer = 0;
    bool alive = true;
};

struct NetworkLine {
    std::string name;
    int from = 0, to = 0;  ///< vertices
    SpaceLine shape;       ///< from the one to the other, as drawn
    int layer = 0;
    bool alive = true;
};

struct NetworkRegion {
    std::string name;
    std::vector<LineUse> ring;  ///< anti-clockwise seen from the outer side of the cloth
    std::set<int> corners;      ///< vertices of the ring between its sides
    double alpha = kCoonsAlpha;
    int layer = 0;
    bool alive = true;
    PartSet parts = 0;  ///< of the body that it lies over; 0: not known
};

inline constexpr double kLeastEdge_cm = 0.3, kMostEdge_cm = 20.0;

struct NetworkOptions {
    double edge_cm = 2.5;     ///< length of quads along lines, about; kLeastEdge_cm to kMostEdge_cm
    double snap_cm = 2.0;     ///< how near an end must be to a vertex or line to be welded to it
    double corner_rad = 0.6;  ///< turns sharper than this are corners
};

/// One point of a boundary: a vertex, or the index-th point of a line.
struct BoundaryKey {
    int vertex = -1, line = -1, index = 0;
    // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of a comparison for a pointer
    friend auto operator<=>(const BoundaryKey&, const BoundaryKey&) = default;
};

/// What fills a region: the outline of fill_region, and the network's name of each point of its ring.
struct RegionBoundary {
    RegionOutline outline;
    std::vector<BoundaryKey> keys;
};

class Network {
  public:
    explicit Network(NetworkOptions options = {}) : options_(options) {}

    /// What is drawn from here on belongs to this layer; nothing is welded to lines of another.
    void begin_layer(int layer) { layer_ = layer; }

    /// A line through these points, split at its sharp turns; ends that meet close it. Ends nearer to the symmetry
    /// plane x = 0 than snap_cm are put on it when `to_middle`. ErrorCode::BadArgument for fewer than 2 points, a point
    /// that is not finite, a line shorter than half an edge, and an empty name.
    [[nodiscard]] Result<void> add_line(const std::string& name, SpaceLine points, bool to_middle = true);

    /// The region that the lines with these names enclose; pieces of them that lead nowhere are left out. A name stands
    /// for all its pieces, "hem/2" for the second of them. Its outer
    /// side is the one away from the body, or without one the side from which the lines, as named, run anti-clockwise.
    /// ErrorCode::BadOutline naming the region and the line at fault where they are not closed or no simple ring.
    [[nodiscard]] Result<void> add_region(const std::string& name, const std::vector<std::string>& lines,
                                          const Obstacle* body);

    /// Parts a region along a line that starts and ends on its ring; what lies to the right of the line becomes
    /// `new_name`, with the same alpha and layer.
    [[nodiscard]] Result<void> cut(const std::string& region, SpaceLine points, const std::string& new_name);

    /// Takes a hole, a closed line inside, out of a region, which is cut in two from the hole to its ring: the second
    /// half becomes `new_name`.
    [[nodiscard]] Result<void> cut_hole(const std::string& region, SpaceLine loop, const std::string& new_name);

    /// A region is none any more; its lines stay, and its outline may become another's. Nothing for an unknown name.
    void release_region(const std::string& name);

    /// Removes a region, and the lines that no other region has.
    [[nodiscard]] Result<void> remove_region(const std::string& name);

    /// Makes the vertex of the region's ring that is nearest to `place` a corner or none. A place within no snap_cm of
    /// a vertex splits the ring there first.
    [[nodiscard]] Result<void> set_corner(const std::string& region, Vec3 place, bool corner);

    [[nodiscard]] Result<void> set_alpha(const std::string& region, double alpha);

    /// Says which parts of the body a region lies over. Halves of a cut region keep them.
    [[nodiscard]] Result<void> associate(const std::string& region, PartSet parts);

    /// Moves the vertex nearest to `from`, or without one the nearest place of a line, to `to`, and all lines of its
    /// layer within `radius` (cm) of it with it, less the farther they are. `keeps_middle`: what lies on the symmetry
    /// plane x = 0 stays on it, as a garment that is mirrored there needs it.
    [[nodiscard]] Result<void> move(Vec3 from, Vec3 to, double radius, bool keeps_middle = false);

    /// Joins the vertices nearest to two places, which must not be the ends of one line; the second comes to the first.
    [[nodiscard]] Result<void> weld(Vec3 keep, Vec3 move);

    /// Takes a piece of a line away, "hem" or "hem/2", and the regions that it bounds; their other lines stay.
    [[nodiscard]] Result<void> erase_line(const std::string& piece);

    /// Brings the vertex nearest to `end` to a piece of a line, at its nearest place, which is split there.
    [[nodiscard]] Result<void> join(Vec3 end, const std::string& piece);

    /// Splits two pieces of lines where they cross, near these places, and joins them there; a piece may cross itself.
    [[nodiscard]] Result<void> meet(const std::string& one, Vec3 at, const std::string& other, Vec3 to);

    /// Takes the waves shorter than about 10 cm out of a piece of a line between the places nearest to `at` and `to`.
    [[nodiscard]] Result<void> smooth(const std::string& piece, Vec3 at, Vec3 to);

    /// Lays waves into a piece of a line between the places nearest to `at` and `to`: `wave` long, as nearly as a whole
    /// number of them fits, reaching `depth` to either side along `outward` of each place, fading in and out over the
    /// first and last one. Its ends stay.
    [[nodiscard]] Result<void> bump(const std::string& piece, Vec3 at, Vec3 to, double wave, double depth,
                                    const std::function<Vec3(Vec3)>& outward);

    /// How long quads are along lines from now on, those that were drawn too. Corners stay as they were found.
    /// ErrorCode::BadArgument outside of kLeastEdge_cm to kMostEdge_cm.
    [[nodiscard]] Result<void> set_edge(double cm);

    [[nodiscard]] Result<void> rename_region(const std::string& region, const std::string& name);

    /// Every place to where `map` takes it; what lies on the plane x = 0 stays there.
    void carry(const std::function<Vec3(Vec3)>& map);

    /// The living line of the layer with this name, "hem" or "hem/2" as above; -1 for none, and for a name of several
    /// pieces without a number.
    [[nodiscard]] int line_named(const std::string& piece) const;
    /// The name that finds this line: with its number where the name has several pieces on its layer.
    [[nodiscard]] std::string piece_name(int line) const;

    [[nodiscard]] Result<RegionBoundary> boundary(const NetworkRegion& region) const;

    [[nodiscard]] const NetworkRegion* find_region(const std::string& name) const;
    [[nodiscard]] const std::vector<NetworkVertex>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<NetworkLine>& lines() const { return lines_; }
    [[nodiscard]] const std::vector<NetworkRegion>& regions() const { return regions_; }
    [[nodiscard]] const NetworkOptions& options() const { return options_; }

    /// Edges that a line is cut into: even, 2 at least.
    [[nodiscard]] int edge_count(const NetworkLine& line) const;

    /// What is not as it must be, for tests: ends that are not where their vertex is, rings that do not join, dead
    /// parts in use. Empty when all is well.
    [[nodiscard]] std::string inconsistency() const;

  private:
    [[nodiscard]] int add_vertex(Vec3 place);
    [[nodiscard]] int vertex_for_end(Vec3 place);
    [[nodiscard]] int nearest_vertex(Vec3 place, double reach) const;
    [[nodiscard]] int split_at(int line, double along);
    void link(const std::string& name, int from, int to, SpaceLine shape);
    [[nodiscard]] std::vector<int> pieces_of(const std::string& name) const;
    [[nodiscard]] Result<std::vector<LineUse>> ring_of(const std::string& region,
                                                       const std::vector<std::string>& names) const;
    [[nodiscard]] std::set<int> detected_corners(const std::vector<LineUse>& ring) const;
    [[nodiscard]] int start_of(LineUse use) const;
    [[nodiscard]] SpaceLine shape_of(LineUse use) const;
    [[nodiscard]] std::vector<LineUse> ring_in_order(const NetworkRegion& region) const;
    [[nodiscard]] Vec3 ring_normal(const std::vector<LineUse>& ring) const;
    void turn_outward(std::vector<LineUse>& ring, const Obstacle& body) const;
    [[nodiscard]] int vertex_on_ring(const NetworkRegion& region, Vec3 place);
    [[nodiscard]] NetworkRegion* region_named(const std::string& name);
    [[nodiscard]] Result<void> part_ring(int region, const std::vector<int>& lines, int from, int to,
                                         const std::string& new_name);
    [[nodiscard]] int vertex_along(int line, double along);
    [[nodiscard]] Result<void> weld_vertices(int stays, int goes);
    void drop_unused_vertices();

    NetworkOptions options_;
    int layer_ = 0;
    std::vector<NetworkVertex> vertices_;
    std::vector<NetworkLine> lines_;
    std::vector<NetworkRegion> regions_;
};

/// Every state a network was in, for undo and redo without limit.
class NetworkHistory {
  public:
    explicit NetworkHistory(Network first) { states_.push_back(std::move(first)); }
    [[nodiscard]] const Network& now() const { return states_[at_]; }
    /// A new state; what was undone before is forgotten.
    void push(Network next) {
        states_.resize(at_ + 1);
        states_.push_back(std::move(next));
        ++at_;
    }
    bool undo() { return at_ > 0 && (--at_, true); }
    bool redo() { return at_ + 1 < states_.size() && (++at_, true); }

  private:
    std::vector<Network> states_;
    std::size_t at_ = 0;
};

}  // namespace core
