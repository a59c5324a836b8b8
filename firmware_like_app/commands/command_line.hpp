#pragma once
// The command line as the subcommands see it: names, options, what runs. The library that reads it shows in
// command_line.cpp alone, for it takes longer to compile than any command.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace app {

/// An option or a positional argument of a command, for saying more of it.
class CommandOption {
  public:
    explicit CommandOption(CLI::Option* option) : option_(option) {}

    CommandOption& required();
    /// Only numbers above 0.
    CommandOption& positive();
    /// Only numbers from least to most, both included.
    CommandOption& range(int least, int most);
    CommandOption& range(double least, double most);
    /// Help tells the value that holds where the option is not given.
    CommandOption& show_default();
    /// May be given again and again, with one value each time.
    CommandOption& repeated();

  private:
    CLI::Option* option_;
};

/// One command, or a group of commands. A handle: copies are the same command. What is bound to an option has to live
/// as long as the command line. A name that begins with a dash is an option, any other a positional argument.
class Command {
  public:
    explicit Command(CLI::App* app) : app_(app) {}

    /// A command below this one.
    Command command(const char* name, const char* what);
    /// A group is no command of its own: one of those below has to be given.
    Command group(const char* name, const char* what);
    /// Exactly one of the options that are added to what is returned has to be given.
    Command one_of(const char* name);

    CommandOption option(const char* name, std::string& value, const char* what);
    CommandOption option(const char* name, std::vector<std::string>& values, const char* what);
    CommandOption option(const char* name, int& value, const char* what);
    CommandOption option(const char* name, std::optional<unsigned>& value, const char* what);
    CommandOption option(const char* name, std::int64_t& value, const char* what);
    CommandOption option(const char* name, double& value, const char* what);
    /// Calls for each value given.
    CommandOption option(const char* name, const std::function<void(const std::string&)>& call, const char* what);
    void flag(const char* name, bool& value, const char* what);
    void flag(const char* name, std::function<void()> call, const char* what);
    /// What runs once all is read and good.
    void runs(std::function<void()> run);

  private:
    CLI::App* app_;
};

/// The whole command line of a program.
class CommandLine {
  public:
    CommandLine(const char* name, const char* what, const char* version);
    ~CommandLine();

    /// What all commands are added to.
    Command root();
    /// Reads the arguments and runs the command they name. Exit code: 0 where they were good or asked for help, 2 after
    /// a wrong call, of which a sentence then stands on standard error.
    int run(int argc, char** argv);

  private:
    std::unique_ptr<CLI::App> app_;
};

}  // namespace app
