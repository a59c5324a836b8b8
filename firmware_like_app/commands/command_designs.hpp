#pragma once
// The designs that a station keeps, below the command "garment".

#include "firmware_like_app/commands/commands.hpp"

namespace app {

void add_designs_command(Command garment, CommandState& state);

}  // namespace app
