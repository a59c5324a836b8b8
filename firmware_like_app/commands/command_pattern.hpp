#pragma once
// The flat pieces of a design, below the command "garment".

#include "firmware_like_app/commands/commands.hpp"

namespace app {

void add_pattern_command(Command garment, CommandState& state);

}  // namespace app
