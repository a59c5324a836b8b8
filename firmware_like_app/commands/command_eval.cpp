// croquis eval shapes, sketches, models: the retrieval figures.

#include <CLI/CLI.hpp>
#include <memory>

#include "firmware_like_app/commands/eval_lists.hpp"

namespace app {

void add_eval_commands(CLI::App& cli, CommandState& state) {
    CLI::App* eval = cli.add_subcommand("eval", "Retrieval figures");
    eval->require_subcommand(1);
    auto options = std::make_shared<EvalOptions>();
    const auto add = [&](const char* name, const char* what, void (*run)(const EvalOptions&, CommandState&)) {
        CLI::App* command = eval->add_subcommand(name, what);
        command->add_option("--jobs", options->jobs, "threads")->check(CLI::PositiveNumber);
        command->add_flag("--json", options->json, "one JSON object on standard output");
        command->callback([options, &state, run] { run(*options, state); });
        return command;
    };
    CLI::App* shapes = add("shapes", "Every shape of a list queries the others", run_eval_shapes);
    CLI::App* sketches = add("sketches", "Sketches of a list query a collection", run_eval_sketches);
    CLI::App* models = add("models", "Every model of a collection queries the others", run_eval_models);
    for (CLI::App* command : {shapes, sketches}) {
        command->add_option("LIST", options->list, "path<TAB>class lines, or a Princeton .cla file")->required();
        command->add_option("--files", options->files, "folder of the files that a .cla numbers");
    }
    for (CLI::App* command : {sketches, models}) {
        command->add_option("--db", options->database, "the index")->required();
    }
    shapes->add_option("--ranks", options->ranks, "nearest results that count; default: class size less one")
        ->check(CLI::PositiveNumber);
    shapes->add_option("--shuffle", options->shuffle, "reorder the list first, by this seed; changes no rank");
}

}  // namespace app
