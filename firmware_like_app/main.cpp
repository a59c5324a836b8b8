// croquis: one program, its subcommands (see commands/).

#include <cstdio>
#include <exception>

#include "firmware_like_app/commands/commands.hpp"

int main(int argc, char** argv) try {
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
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        std::fprintf(stderr, "croquis: standard output cannot be written to; see that there is room where it goes\n");
        return 1;
    }
    return wrong_call != 0 ? wrong_call : state.exit_code;
} catch (const std::exception& error) {  // out of memory and the like: no command lets its own errors out
    std::fprintf(stderr, "croquis: %s\n", error.what());
    return 1;
}
