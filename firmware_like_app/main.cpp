// croquis: one program, its subcommands (see commands/).

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "firmware_like_app/commands/commands.hpp"

int main(int argc, char** argv) try {
    CLI::App cli{"Croquis: draw it, find it.", "croquis"};
    cli.require_subcommand(1);
    cli.set_version_flag("--version", CROQUIS_VERSION);
    app::CommandState state;
    app::add_kiosk_command(cli, state);
    app::add_config_command(cli, state);
    app::add_doctor_command(cli, state);
    app::add_index_commands(cli, state);
    app::add_query_command(cli, state);
    app::add_describe_command(cli, state);
    app::add_match_command(cli, state);
    app::add_eval_commands(cli, state);
    app::add_starter_command(cli, state);
    app::add_trace_commands(cli, state);
    app::add_tablet_commands(cli, state);
    app::add_mannequin_command(cli, state);
    app::add_garment_commands(cli, state);
    try {
        cli.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return cli.exit(error) == 0 ? 0 : 2;
    }
    return state.exit_code;
} catch (const std::exception& error) {  // out of memory and the like: no command lets its own errors out
    std::fprintf(stderr, "croquis: %s\n", error.what());
    return 1;
}
