#include "firmware_like_app/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <utility>

namespace app {

CommandOption& CommandOption::required() {
    option_->required();
    return *this;
}

CommandOption& CommandOption::positive() {
    option_->check(CLI::PositiveNumber);
    return *this;
}

CommandOption& CommandOption::range(int least, int most) {
    option_->check(CLI::Range(least, most));
    return *this;
}

CommandOption& CommandOption::range(double least, double most) {
    option_->check(CLI::Range(least, most));
    return *this;
}

CommandOption& CommandOption::show_default() {
    option_->capture_default_str();
    return *this;
}

CommandOption& CommandOption::repeated() {
    option_->take_all()->expected(1);
    return *this;
}

Command Command::command(const char* name, const char* what) {
    return Command(app_->add_subcommand(name, what));
}

Command Command::group(const char* name, const char* what) {
    CLI::App* group = app_->add_subcommand(name, what);
    group->require_subcommand(1);
    return Command(group);
}

Command Command::one_of(const char* name) {
    CLI::App* options = app_->add_option_group(name);
    options->require_option(1);
    return Command(options);
}

CommandOption Command::option(const char* name, std::string& value, const char* what) {
    return CommandOption(app_->add_option(name, value, what));
}

CommandOption Command::option(const char* name, std::vector<std::string>& values, const char* what) {
    return CommandOption(app_->add_option(name, values, what));
}

CommandOption Command::option(const char* name, int& value, const char* what) {
    return CommandOption(app_->add_option(name, value, what));
}

CommandOption Command::option(const char* name, std::optional<unsigned>& value, const char* what) {
    return CommandOption(app_->add_option(name, value, what));
}

CommandOption Command::option(const char* name, std::int64_t& value, const char* what) {
    return CommandOption(app_->add_option(name, value, what));
}

CommandOption Command::option(const char* name, double& value, const char* what) {
    return CommandOption(app_->add_option(name, value, what));
}

CommandOption Command::option(const char* name, const std::function<void(const std::string&)>& call, const char* what) {
    return CommandOption(app_->add_option_function<std::string>(name, call, what));
}

void Command::flag(const char* name, bool& value, const char* what) {
    app_->add_flag(name, value, what);
}

void Command::flag(const char* name, std::function<void()> call, const char* what) {
    app_->add_flag_callback(name, std::move(call), what);
}

void Command::runs(std::function<void()> run) {
    app_->callback(std::move(run));
}

CommandLine::CommandLine(const char* name, const char* what, const char* version)
    : app_(std::make_unique<CLI::App>(what, name)) {
    app_->require_subcommand(1);
    app_->set_version_flag("--version", version);
}

CommandLine::~CommandLine() = default;

Command CommandLine::root() {
    return Command(app_.get());
}

int CommandLine::run(int argc, char** argv) try {
    app_->parse(argc, argv);
    return 0;
} catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? 0 : 2;
}

}  // namespace app
