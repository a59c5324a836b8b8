#include "core/garment/fill_topology.hpp"

#include <cstdlib>
#include <optional>
#include <string>

#include "core/garment/fill_builder.hpp"
#include "core/garment/fill_plan.hpp"

namespace core {
namespace {

constexpr int kMostIrregular = 16;
/// With more edges a thorough search costs milliseconds and seldom finds what a quick one does not.
constexpr int kThoroughEdges = 60;

Result<SideCounts> checked(std::span<const int> side_edges) {
    const auto bad = [](std::string what) { return unexpected(ErrorCode::BadArgument, std::move(what)); };
    if (side_edges.size() < kFewestSides || side_edges.size() > kMostSides)
        return bad("The region has " + std::to_string(side_edges.size()) + " sides; " + std::to_string(kFewestSides) +
                   " to " + std::to_string(kMostSides) + " can be filled: mark or unmark corners.");
    SideCounts sides;
    for (const int count : side_edges) {
        if (count < 1 || count > kMostSideEdges)
            return bad("Side " + std::to_string(sides.n + 1) + " of the region has " + std::to_string(count) +
                       " edges; 1 to " + std::to_string(kMostSideEdges) + " are possible.");
        sides.push_back(count);
    }
    if (sides.total() % 2 != 0)
        return bad("The boundary has " + std::to_string(sides.total()) +
                   " edges, an odd number, which quads cannot fill: add a point to one side or take one away.");
    if (sides.total() < 4)
        return bad("The boundary has " + std::to_string(sides.total()) + " edges; quads need 4 at least.");
    return sides;
}

/// The best plan of a list that can be built: the first without more irregular vertices than planned, else the one with
/// the fewest.
void try_plans(const SideCounts& sides, int irregular, FillSearch search, std::optional<RegionTopology>& best) {
    for (const FillPlan& plan : fill_plans(sides, irregular, search)) {
        std::optional<RegionTopology> built = build_fill(sides, plan);
        if (!built || (best && built->counts.irregular() >= best->counts.irregular())) continue;
        best = std::move(built);
        if (best->counts.irregular() <= irregular) return;
    }
}

}  // namespace

Result<RegionTopology> fill_topology(std::span<const int> side_edges) {
    const Result<SideCounts> sides = checked(side_edges);
    if (!sides) return unexpected(sides.error());
    std::optional<RegionTopology> best;
    for (int irregular = std::abs(sides->n - 4); irregular <= kMostIrregular; irregular += 2)
        for (const FillSearch search : {FillSearch::Quick, FillSearch::Thorough, FillSearch::Joining}) {
            if (search == FillSearch::Thorough && sides->n > 5 && sides->total() > kThoroughEdges) continue;
            try_plans(*sides, irregular, search, best);
            if (best && best->counts.irregular() <= irregular) return std::move(*best);
        }
    if (best) return std::move(*best);
    return unexpected(ErrorCode::Internal,
                      "No way to fill the region with quads was found: add points to its short sides.");
}

}  // namespace core
