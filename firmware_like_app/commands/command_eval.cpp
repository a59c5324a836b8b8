// croquis eval shapes, sketches, models: the retrieval figures.

#include <memory>

#include "firmware_like_app/commands/eval_lists.hpp"

namespace app {

void add_eval_commands(Command cli, CommandState& state) {
    Command eval = cli.group("eval", "Retrieval figures");
    auto options = std::make_shared<EvalOptions>();
    const auto add = [&](const char* name, const char* what, void (*run)(const EvalOptions&, CommandState&)) {
        Command command = eval.command(name, what);
        command.option("--jobs", options->jobs, "threads").range(1, kMostJobs);
        command.flag("--json", options->json, "one JSON object on standard output");
        command.runs([options, &state, run] { run(*options, state); });
        return command;
    };
    Command shapes = add("shapes", "Every shape of a list queries the others", run_eval_shapes);
    Command sketches = add("sketches", "Sketches of a list query a collection", run_eval_sketches);
    Command models = add("models", "Every model of a collection queries the others", run_eval_models);
    for (Command command : {shapes, sketches}) {
        command.option("LIST", options->list, "path<TAB>class lines, or a Princeton .cla file").required();
        command.option("--files", options->files, "folder of the files that a .cla numbers");
    }
    for (Command command : {sketches, models}) {
        command.option("--db", options->database, "the index").required();
    }
    shapes.option("--ranks", options->ranks, "nearest results that count; default: class size less one").positive();
    shapes.option("--shuffle", options->shuffle, "reorder the list first, by this seed; changes no rank");
}

}  // namespace app
