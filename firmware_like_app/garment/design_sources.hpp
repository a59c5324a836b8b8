#pragma once
// Where a design's own bodies and objects come from.

#include <string>

#include "firmware_like_app/garment/dressed_design.hpp"

namespace app {

/// Bodies by file: a closed mesh, stood up. Sentences name the file.
[[nodiscard]] core::FormSource bodies_by_file();

/// Models of a collection by the path they were added from, or else by name. The file is opened by the first call, and
/// again for a model that it did not have then; without one every call says that there is no collection. Each call
/// reads one mesh, some milliseconds.
[[nodiscard]] ModelSource models_of_index(const std::string& database);

}  // namespace app
