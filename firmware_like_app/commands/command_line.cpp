#include "firmware_like_app/commands/command_line.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>
#include <type_traits>
#include <utility>

namespace app {

namespace {

/// The number that a text is, and nothing but the number.
template <typename Number>
std::optional<Number> number_of(const std::string& text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end) return std::nullopt;
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(number)) return std::nullopt;
    }
    return number;
}

std::string short_text(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", number);
    return text;
}

/// Has the text read as such a number before the library does, whose own sentences nobody understands.
template <typename Number>
CLI::Option* numeric(CLI::Option* option, const std::string& kind) {
    return option->check(
        [kind](const std::string& text) {
            return number_of<Number>(text) ? std::string() : "give " + kind + ", not \"" + text + "\"";
        },
        "");
}

template <typename Number>
void limit(CLI::Option* option, Number least, Number most) {
    const std::string bounds = short_text(least) + " to " + short_text(most);
    option->check(
        [=](const std::string& text) {
            const std::optional<Number> number = number_of<Number>(text);
            const bool good = number && *number >= least && *number <= most;
            return good ? std::string() : "give a number from " + bounds + ", not \"" + text + "\"";
        },
        "from " + bounds);
}

/// The command that was reached before the fault, with those above it: "croquis index build".
std::string name_of_call(const CLI::App* app) {
    std::string name = app->get_name();
    while (!app->get_subcommands().empty()) {
        app = app->get_subcommands().front();
        name += " " + app->get_name();
    }
    return name;
}

const CLI::App* innermost(const CLI::App* app) {
    while (!app->get_subcommands().empty()) app = app->get_subcommands().front();
    return app;
}

std::string what_is_wrong(const CLI::App* app, const CLI::Error& error) {
    std::string what = error.what();
    const std::vector<std::string> left_over = innermost(app)->remaining();
    const bool lacks_command = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && !left_over.empty() &&
                               !innermost(app)->get_subcommands({}).empty();
    if (lacks_command) return "there is no command \"" + left_over.front() + "\"";
    if (const std::size_t at = what.find(": At Most 1 required"); at != std::string::npos) {
        return what.substr(0, at) + " may be given once only";
    }
    if (!what.empty() && what.back() == '.') what.pop_back();
    return what;
}

/// One sentence, as for every other fault.
std::string wrong_call(const CLI::App* app, const CLI::Error& error) {
    return "croquis: " + what_is_wrong(app, error) + "; see " + name_of_call(app) + " --help\n";
}

}  // namespace

CommandOption& CommandOption::required() {
    option_->required();
    return *this;
}

CommandOption& CommandOption::positive() {
    option_->check(
        [](const std::string& text) {
            const std::optional<double> number = number_of<double>(text);
            return number && *number > 0.0 ? std::string() : "give a number above 0, not \"" + text + "\"";
        },
        "above 0");
    return *this;
}

CommandOption& CommandOption::range(int least, int most) {
    limit(option_, least, most);
    return *this;
}

CommandOption& CommandOption::range(double least, double most) {
    limit(option_, least, most);
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
    return CommandOption(numeric<int>(app_->add_option(name, value, what), "a whole number"));
}

CommandOption Command::option(const char* name, std::optional<unsigned>& value, const char* what) {
    const std::string kind = "a whole number from 0 to " + std::to_string(std::numeric_limits<unsigned>::max());
    return CommandOption(numeric<unsigned>(app_->add_option(name, value, what), kind));
}

CommandOption Command::option(const char* name, std::int64_t& value, const char* what) {
    return CommandOption(numeric<std::int64_t>(app_->add_option(name, value, what), "a whole number"));
}

CommandOption Command::option(const char* name, double& value, const char* what) {
    return CommandOption(numeric<double>(app_->add_option(name, value, what), "a number"));
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
    app_->failure_message(wrong_call);
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
