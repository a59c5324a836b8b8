#pragma once
// The subcommands of croquis. Each adds itself to the command line and sets the exit code when it runs:
// 0 success, 1 the input or the data is at fault, 2 a wrong call.

#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "firmware_like_app/commands/command_line.hpp"

namespace app {

/// Of --jobs: every thread takes memory of its own.
inline constexpr int kMostJobs = 256;

struct CommandState {
    int exit_code = 0;
};

void add_describe_command(Command cli, CommandState& state);
void add_match_command(Command cli, CommandState& state);
void add_eval_commands(Command cli, CommandState& state);
void add_index_commands(Command cli, CommandState& state);
void add_query_command(Command cli, CommandState& state);
void add_starter_command(Command cli, CommandState& state);
void add_tablet_commands(Command cli, CommandState& state);
void add_trace_commands(Command cli, CommandState& state);
void add_garment_commands(Command cli, CommandState& state);
void add_mannequin_command(Command cli, CommandState& state);
void add_kiosk_command(Command cli, CommandState& state);
void add_config_command(Command cli, CommandState& state);
void add_doctor_command(Command cli, CommandState& state);

/// One sentence on standard error, exit code 1.
void fail(CommandState& state, const core::Error& error);
/// The same for a call that nothing can answer: exit code 2.
void fail_call(CommandState& state, const core::Error& error);

/// BadArgument where the name of a file to write does not end in one of these, given without dot in small letters.
[[nodiscard]] core::Result<void> check_ending(const std::string& path, const std::vector<std::string>& endings);

}  // namespace app
