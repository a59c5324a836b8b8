#pragma once
// Standard input, output and error as the program finds them, and what becomes of what it writes there.

#include <optional>
#include <string>

namespace app {

/// Opens those of the three that the caller has closed, so that no file of ours takes their number and gets the
/// program's output into it: input is empty, writing to output fails, what is said on error is lost. To be called
/// first.
void open_closed_streams();

/// Writes out what is left for standard output. A sentence when that or anything before it failed, as on a full disk;
/// nothing when all was written, or nothing was there to be.
[[nodiscard]] std::optional<std::string> unwritten_output();

}  // namespace app
