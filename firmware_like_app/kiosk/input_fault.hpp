#pragma once
// A station on the bare console that draws and cannot be controlled: what is at fault, in a code of two letters.

#include <string>

namespace app {

/// "I1": there is no event device in the folder (/dev/input). "I2": there are some, and none may be opened by this
/// user. Empty: at least one may be read.
[[nodiscard]] std::string input_fault(const std::string& folder);

}  // namespace app
