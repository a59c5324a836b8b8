// croquis: one program, its subcommands (see commands/).

#include <cstdio>
#include <exception>
#include <new>

#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/standard_streams.hpp"

int main(int argc, char** argv) try {
    app::open_closed_streams();
    app::CommandLine line("croquis", "Croquis: draw it, find it.", CROQUIS_VERSION);
    app::Command croquis = line.root();
    app::CommandState state;
    app::add_kiosk_command(croquis, state);
    app::add_config_command(croquis, state);
    app::add_doctor_command(croquis, state);
    app::add_index_commands(croquis, state);
    app::add_query_command(croquis, state);
    app::add_describe_command(croquis, state);
    app::add_match_command(croquis, state);
    app::add_eval_commands(croquis, state);
    app::add_starter_command(croquis, state);
    app::add_trace_commands(croquis, state);
    app::add_tablet_commands(croquis, state);
    app::add_mannequin_command(croquis, state);
    app::add_garment_commands(croquis, state);
    const int wrong_call = line.run(argc, argv);
    int exit_code = wrong_call != 0 ? wrong_call : state.exit_code;
    if (const auto unwritten = app::unwritten_output()) {
        std::fprintf(stderr, "croquis: %s\n", unwritten->c_str());
        if (exit_code == 0) exit_code = 1;
    }
    return exit_code;
} catch (const std::bad_alloc&) {
    std::fprintf(stderr, "croquis: there is not enough memory; close other programs and try again\n");
    return 1;
} catch (const std::exception& error) {  // no command lets its own errors out
    std::fprintf(stderr, "croquis: %s\n", error.what());
    return 1;
}
