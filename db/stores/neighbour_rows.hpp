#pragma once
// One place of a neighbour list <-> its row in `neighbour`, checksum included. Of use inside db/stores only.

#include <cstdint>

#include "db/stores/two_view_index.hpp"

namespace db {

struct NeighbourRow {
    std::int64_t model_id = 0, place = 0;
    StoredNeighbour neighbour;
    bool sound = true;  ///< it has the checksum it was written with
};

/// All rows, list by list.
inline constexpr const char* kNeighbourRows =
    "SELECT model_id, place, other_id, distance, checksum FROM neighbour ORDER BY model_id, place";

/// The present row of kNeighbourRows.
[[nodiscard]] NeighbourRow neighbour_row(const Statement& row);

}  // namespace db
