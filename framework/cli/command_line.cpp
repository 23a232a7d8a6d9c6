// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "errors/input_error.hpp"
#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "grading/places.hpp"

#include <CLI/CLI.hpp>

#include <cerrno>
#include <cstdio>
#include <exception>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace rigor {

namespace {

int complain(const std::string& what, int status)
{
    std::fprintf(stderr, "rigor: %s\n", what.c_str());
    return status;
}

using Commands = std::span<const CommandEntry>;

// Reports that the first word of the command line is neither an option nor a command.
int unknown_command(const std::string& word, Commands commands)
{
    std::vector<std::string_view> names;
    for (const CommandEntry& command : commands)
        names.push_back(command.name);
    return complain("unknown command " + in_quotes(word) +
                        suggestion(word, names, "`rigor --help` lists them"),
                    exit_input);
}

// The command of this name; nullptr if there is none.
const CommandEntry* find_command(const std::string& name, Commands commands)
{
    for (const CommandEntry& command : commands)
        if (name == command.name) return &command;
    return nullptr;
}

// Becomes the program `rigor_class`, with the same command line.
int run_by_class_program(char** argv)
{
    constexpr const char* program = "rigor_class";
    prepare_targets({program});
    execv(places().program(program).c_str(), argv);
    throw std::system_error(errno, std::generic_category(), places().program(program).string());
}

// CLI11's error message, joined into one line.
std::string one_line(std::string text)
{
    for (char& c : text)
        if (c == '\n') c = ' ';
    return text;
}

int run_action(const Action& action)
{
    try {
        return action();
    } catch (const InputError& error) {
        return complain(error.what(), exit_input);
    } catch (const std::exception& error) {
        return complain(error.what(), exit_fault);
    }
}

} // namespace

int run_command_line(int argc, char** argv, Commands commands)
{
    // Whatever the umask is, nothing is made that every user may change.
    umask(umask(0) | S_IWOTH);
    CLI::App app("Rigor: rigid-body animation, assignments and their grading.", "rigor");
    app.set_version_flag("--version", RIGOR_VERSION);
    app.require_subcommand(1);
    app.footer("`rigor COMMAND --help` shows a command's options and examples.\n"
               "Exit status: 0 done, 1 what was checked is wrong, 2 bad usage or input, 3 a fault "
               "of Rigor's own.");
    app.get_formatter()->column_width(Options::name_width);

    std::vector<std::pair<CLI::App*, Action>> actions;
    for (const CommandEntry& command : commands) {
        CLI::App* subcommand = app.add_subcommand(command.name, command.summary);
        if (!command.declare) continue;
        Options options(*subcommand);
        actions.emplace_back(subcommand, command.declare(options));
    }
    const std::string first = argc > 1 ? argv[1] : "";
    const bool is_option = first.starts_with('-');
    if (is_option && first != "-h" && first != "--help" && first != "--version")
        return complain("unknown option '" + first + "' before a command", exit_input);
    const CommandEntry* command = find_command(first, commands);
    if (argc > 1 && !is_option && !command) return unknown_command(first, commands);
    if (command && !command->declare)
        return run_action([argv] { return run_by_class_program(argv); });
    if (argc == 1) {
        std::fputs(app.help().c_str(), stderr);
        return complain("expected a command", exit_input);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) { // the user asked for --help or --version
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        return complain(one_line(error.what()), exit_input);
    }
    for (const auto& [subcommand, action] : actions)
        if (subcommand->parsed()) return run_action(action);
    return complain("expected a command", exit_input);
}

} // namespace rigor
