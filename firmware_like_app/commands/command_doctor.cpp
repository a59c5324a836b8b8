// croquis doctor: what is fine, what is not, what to do.

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "firmware_like_app/commands/commands.hpp"
#include "firmware_like_app/commands/print_json.hpp"
#include "firmware_like_app/health/self_test.hpp"

namespace app {
namespace {

struct DoctorOptions {
    std::string config, database;
    bool json = false;
};

void print_for_people(const std::vector<Check>& checks) {
    for (const Check& check : checks) {
        std::printf("%-8s %-10s %s\n", check.good ? "fine" : "look at", check.name.c_str(), check.found.c_str());
        if (!check.advice.empty()) std::printf("%-8s %-10s -> %s\n", "", "", check.advice.c_str());
    }
}

void print_as_json(const std::vector<Check>& checks, bool good) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const Check& check : checks) {
        all.push_back({{"name", check.name}, {"good", check.good}, {"found", check.found}, {"advice", check.advice}});
    }
    const nlohmann::ordered_json out{{"good", good}, {"checks", all}};
    print_json(out);
}

void run_doctor(const DoctorOptions& options, CommandState& state) {
    Config config;
    if (!options.config.empty()) {
        const core::Result<Config> file = read_config(options.config);
        if (!file) return fail(state, file.error());
        config = *file;
    }
    if (!options.database.empty()) config.collection.database = options.database;
    std::vector<Check> checks = check_machine();
    for (Check& check : check_station(config, options.config)) checks.push_back(std::move(check));
    checks.push_back(check_permissions(config, options.config));
    const auto bad = std::count_if(checks.begin(), checks.end(), [](const Check& check) { return !check.good; });
    const bool good = bad == 0;
    if (options.json) {
        print_as_json(checks, good);
    } else {
        print_for_people(checks);
    }
    if (!good) {
        std::fprintf(stderr,
                     "croquis: %td of %zu things are not fine; standard output names them and says what to do\n", bad,
                     checks.size());
        state.exit_code = 1;
    }
}

}  // namespace

void add_doctor_command(Command cli, CommandState& state) {
    auto options = std::make_shared<DoctorOptions>();
    Command command =
        cli.command("doctor", "Looks at screen, graphics, tablets, fonts, database, disk and permissions");
    command.option("--config", options->config, "the settings of the station");
    command.option("--db", options->database, "the index, where no settings name it");
    command.flag("--json", options->json, "one JSON object on standard output");
    command.runs([options, &state] { run_doctor(*options, state); });
}

}  // namespace app
