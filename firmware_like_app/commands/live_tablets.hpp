#pragma once
// Tablets for commands that watch them until Ctrl-C or a time is over.

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "input/sources/pen_source.hpp"

namespace app {

/// "auto", "hidraw", "evdev" or "libinput". BadArgument for another word.
[[nodiscard]] core::Result<std::unique_ptr<input::PenSource>> open_tablets(const std::string& by,
                                                                           input::DeviceNumbers& numbers);

/// Calls `each` every few milliseconds with what came, and prints what goes wrong to standard error, until Ctrl-C or
/// the time is over. `each` says whether to go on.
void watch_tablets(input::PenSource& source, std::optional<double> seconds,
                   const std::function<bool(const std::vector<input::SourceEvent>&)>& each);

}  // namespace app
