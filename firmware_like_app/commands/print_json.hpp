#pragma once
// What `--json` prints.

#include <nlohmann/json_fwd.hpp>

namespace app {

/// One object on standard output and a line end; on one line, or for people to read at an indent. Names of files may be
/// of any bytes: what is no UTF-8 is replaced.
void print_json(const nlohmann::ordered_json& object, int indent = -1);

}  // namespace app
