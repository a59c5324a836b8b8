#include "firmware_like_app/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <utility>

namespace app {
namespace {

/// Holds a number to a range, with words for the fault and for --help. CLI's own ranges take "nan", and for numbers
/// above 0 their words name the largest double.
template <typename Good>
void must_be(CLI::Option& option, const std::string& words, const Good& good) {
    option.check(
        [words, good](const std::string& text) {
            double value = 0.0;
            const bool fits = CLI::detail::lexical_cast(text, value) && good(value);
            return fits ? std::string() : text + " is not a number " + words;
        },
        words);
}

/// A word in the place of a command that none has.
std::string unknown_command(const CLI::App& app) {
    const std::vector<std::string> left = app.remaining(true);
    return left.empty() ? "" : left.front();
}

}  // namespace

CommandOption& CommandOption::required() {
    option_->required();
    return *this;
}

CommandOption& CommandOption::positive() {
    must_be(*option_, "above 0", [](double value) { return value > 0.0 && std::isfinite(value); });
    return *this;
}

CommandOption& CommandOption::range(int least, int most) {
    return range(static_cast<double>(least), static_cast<double>(most));
}

CommandOption& CommandOption::range(double least, double most) {
    std::ostringstream words;
    words << "from " << least << " to " << most;
    must_be(*option_, words.str(), [least, most](double value) { return value >= least && value <= most; });
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
} catch (const CLI::RequiredError& error) {
    const std::string word = unknown_command(*app_);
    if (word.empty()) return app_->exit(error) == 0 ? 0 : 2;
    std::fprintf(stderr, "croquis: there is no command or option \"%s\" here; --help shows those there are\n",
                 word.c_str());
    return 2;
} catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? 0 : 2;
}

}  // namespace app
