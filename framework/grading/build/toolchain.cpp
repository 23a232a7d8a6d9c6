// SPDX-License-Identifier: MIT
#include "grading/build/toolchain.hpp"

#include "errors/input_error.hpp"
#include "grading/build/await_no_writer.hpp"
#include "grading/build/ninja.hpp"
#include "grading/build/shown_errors.hpp"
#include "grading/build/write_file.hpp"
#include "grading/machine/disk_room.hpp"
#include "grading/machine/permissions.hpp"
#include "grading/machine/tool_turn.hpp"
#include "grading/places.hpp"
#include "sandbox/blocked_calls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <unistd.h>
#include <utility>

namespace rigor {

namespace fs = std::filesystem;

namespace {

// The words of a command line, without the shell's quotes.
std::vector<std::string> words_of(const std::string& command)
{
    std::vector<std::string> words;
    std::string word;
    bool is_open = false; // whether a word has begun
    char quote = 0;
    for (std::size_t i = 0; i < command.size(); ++i) {
        const char c = command[i];
        if (quote != 0 && c == quote) {
            quote = 0;
        } else if (quote == 0 && (c == '\'' || c == '"')) {
            quote = c;
            is_open = true;
        } else if (quote == 0 && c == ' ') {
            if (is_open) words.push_back(std::exchange(word, {}));
            is_open = false;
        } else {
            if (c == '\\' && quote != '\'' && i + 1 < command.size()) ++i;
            word += command[i];
            is_open = true;
        }
    }
    if (is_open) words.push_back(word);
    return words;
}

// Removes the words before the compiler, such as a compiler cache.
void drop_launcher(std::vector<std::string>& words)
{
    const auto option = std::find_if(words.begin(), words.end(),
                                     [](const std::string& word) { return word[0] == '-'; });
    if (option - words.begin() > 1) words.erase(words.begin(), option - 1);
}

bool is_student_object(const std::string& word)
{
    return word.find("formulas_student.dir/") != std::string::npos;
}

// Replaces the build's compiler by the one that RIGOR_COMPILER names. A compiler of another family
// (gcc or Clang) cannot read the precompiled header. It includes the source of the header instead.
void exchange_compiler(std::vector<std::string>& words)
{
    const std::string chosen = chosen_compiler();
    if (chosen.empty()) return;
    const bool is_clang = chosen.find("clang") != std::string::npos,
               was_clang = words[0].find("clang") != std::string::npos;
    words[0] = chosen;
    if (is_clang == was_clang) return;
    // Only gcc has the option --param, with which the build sets how gcc uses memory.
    std::erase_if(words, [](const std::string& word) { return word.starts_with("--param="); });
    const auto at = std::find(words.begin(), words.end(), "-include");
    if (at == words.end())
        throw std::runtime_error("RIGOR_COMPILER: the build's precompiled header is not for it");
    // Without -Xclang, the driver of Clang would try to load gcc's precompiled header.
    words.insert(words.erase(at), {"-Xclang", "-include", "-Xclang"});
}

void take_compile(Toolchain& tools, const std::string& command)
{
    std::vector<std::string> words = words_of(command);
    drop_launcher(words);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const bool has_file =
            words[i] == "-MT" || words[i] == "-MF" || words[i] == "-o" || words[i] == "-c";
        // The path of the precompiled header is recognized by its name, because the option before
        // it depends on the compiler.
        if (words[i].find("/cmake_pch.hxx") != std::string::npos)
            tools.precompiled = fs::path(words[i]).parent_path();
        if (has_file)
            ++i;
        else if (words[i] != "-MD")
            tools.compile.push_back(words[i]);
    }
    exchange_compiler(tools.compile);
    // no_file_queries.hpp follows the precompiled header, which has to come first.
    const bool is_clang = tools.compile[0].find("clang") != std::string::npos;
    const std::string queries = no_file_queries().string();
    if (is_clang)
        tools.compile.insert(tools.compile.end(), {"-Xclang", "-include", "-Xclang", queries});
    else
        tools.compile.insert(tools.compile.end(), {"-include", queries});
    // With -pipe the assembler reads from a pipe, so its messages do not name a temporary file.
    tools.compile.emplace_back("-pipe");
    // The same file gives the same result at any time, so it cannot ask for the time (__TIME__).
    tools.compile.emplace_back("-Werror=date-time");
    // A file that includes itself could cause endless errors. Clang limits their number by itself.
    if (!is_clang) tools.compile.emplace_back("-fmax-errors=20");
}

void take_link(Toolchain& tools, const std::string& command)
{
    const std::vector<std::string> words = words_of(command);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string ending = fs::path(words[i]).extension().string();
        if (words[i] == ":" || words[i] == "&&" || is_student_object(words[i])) continue;
        // CMake 3.27 asks for a list of what was linked, in a folder that is read-only here.
        if (words[i].starts_with("-Wl,--dependency-file=")) continue;
        if (words[i] == "-o") {
            ++i;
        } else {
            const bool is_input =
                words[i][0] != '-' && words[i][0] != '/' && (ending == ".o" || ending == ".a");
            if (is_input) tools.linked_inputs.push_back(words[i]);
            tools.link.push_back(is_input ? (places().build / words[i]).string() : words[i]);
        }
    }
    // An object may hold code for the optimizer of the linker, which gcc's plugin would compile.
    if (tools.link[0].find("clang") == std::string::npos)
        tools.link.emplace_back("-fno-use-linker-plugin");
    // With this option, a name that is defined nowhere does not make the link fail. Only the
    // formulas that use the name fail.
    tools.link.emplace_back("-Wl,--warn-unresolved-symbols");
}

// A tool may run as another user, and the umask may have been strict. In a mount namespace, a tool
// reaches its paths without the folders around them.
void let_others_use(const ToolRun& tool, const Walls& walls)
{
    if (!walls.another_user) return;
    std::vector<fs::path> paths = tool.readable;
    paths.push_back(tool.folder);
    for (const fs::path& path : paths)
        if (path != tool.out) let_others_read(path);
    paths.push_back(tool.out);
    if (walls.namespaces == Walls::Namespaces::none)
        for (const fs::path& path : paths)
            let_others_pass(path);
}

// Whether a tool, or perhaps a program that it started, was killed although it had time left. The
// message of a compiler that says so is not asked: a submission can make it print the same text.
bool was_ended_by_system(const ConfinedRun& run, double time)
{
    const bool was_killed = run.signal == SIGKILL && limit_met(run, time) != ToolLimit::time;
    return was_killed || (!run.ok() && run.oom_kills > 0);
}

// The largest ratio of wall-clock time to processor time that is expected on a busy machine.
constexpr double busy = 4;

} // namespace

std::string chosen_compiler()
{
    const char* chosen = std::getenv("RIGOR_COMPILER");
    if (!chosen) return "";
    if (chosen[0] != '/' || access(chosen, X_OK) != 0)
        throw InputError(
            fmt::format("RIGOR_COMPILER: expected the path of a C++ compiler, found '{}'", chosen));
    return chosen;
}

fs::path no_file_queries()
{
    return places().source / "framework/grading/build/no_file_queries.hpp";
}

Toolchain student_toolchain()
{
    Toolchain tools;
    const std::vector<std::string> commands = ninja_commands("worker_student");
    const auto compiles = [](const std::string& command) {
        return is_student_object(command) && command.find(" -c ") != std::string::npos;
    };
    const auto compile = std::find_if(commands.begin(), commands.end(), compiles);
    if (compile == commands.end())
        throw std::runtime_error("the build has no command that compiles a file of student/");
    take_compile(tools, *compile);
    if (tools.precompiled.empty())
        throw std::runtime_error("the build compiles student/ without a precompiled header");
    take_link(tools, commands.back());
    return tools;
}

ConfinedRun run_tool(const ToolRun& tool)
{
    Confinement walls{Profile::compiler, usual_tier()};
    walls.readable = tool.readable;
    walls.readable.push_back(tool.folder);
    walls.writable = {tool.out};
    walls.folder = tool.folder;
    let_others_use(tool, walls_of(walls.tier));
    // The last one keeps Clang from starting a symbolizer, which opens a socket, where it crashes.
    walls.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C", "TMPDIR=" + tool.out.string(),
                         "LLVM_DISABLE_SYMBOLIZATION=1"};
    const ToolTurn turn;
    walls.limits.address_space = own_tool_share().memory;
    // A compiler starts an assembler, and a linker starts some threads for each processor.
    walls.limits.processes = 64 + 4 * std::thread::hardware_concurrency();
    walls.limits.processor_time = static_cast<std::uint64_t>(tool.time);
    walls.limits.file_size = tool.largest_file;
    RunLimits limits;
    limits.time = std::chrono::duration<double>(busy * tool.time);
    ConfinedRun run = run_confined(walls, tool.arguments, limits);
    if (was_ended_by_system(run, tool.time))
        throw std::runtime_error(tool.arguments[0] +
                                 " was ended by the system, perhaps because memory ran out");
    // Whatever a tool says when it fails, a full disk may be the reason. Others may have given back
    // meanwhile what they used of the disk, so there must be room for several files.
    if (!run.ok()) require_room(tool.out, std::max(4 * largest_output, tool.largest_file));
    return run;
}

ConfinedRun make_local(const fs::path& object, const std::vector<std::string>& names,
                       const fs::path& copy)
{
    const fs::path out = copy.parent_path(), list = copy.string() + ".names";
    // With a part of the list, objcopy would leave some names visible without a word.
    write_file(list, fmt::format("{}\n", fmt::join(names, "\n")));
    const auto copied = [&](const std::string& option, const fs::path& from, const fs::path& to) {
        return run_tool({{"/usr/bin/objcopy", option + list.string(), from.string(), to.string()},
                         out,
                         {from, list, out},
                         out});
    };
    // A name that must be unique in a process (GNU unique) becomes local only if it is made weak
    // first.
    const fs::path weak = copy.string() + ".weak";
    const ConfinedRun weakened = copied("--weaken-symbols=", object, weak);
    return weakened.ok() ? copied("--localize-symbols=", weak, copy) : weakened;
}

std::string why_it_does_not_start(const fs::path& worker)
{
#ifdef RIGOR_SANITIZED // a sanitizer needs system calls that the sandbox forbids
    Confinement walls{Profile::worker, Tier::c};
#else
    Confinement walls{Profile::worker, usual_tier()};
    walls.limits.address_space = std::uint64_t{2} << 30;
#endif
    constexpr int longest_start = 2; // [s]; the start takes milliseconds
    walls.limits.processor_time = longest_start;
    RunLimits limits;
    limits.time = std::chrono::duration<double>(busy * longest_start);
    // A worker that was started without a client ends its main function with this status.
    constexpr int without_client = 2;
    ConfinedRun run;
    try {
        run = run_confined(walls, {worker.string()}, limits);
    } catch (const CannotRun& failure) {
        return fmt::format("makes a program that the system cannot run ({}): look for code for the "
                           "assembler or the linker\n",
                           failure.code().message());
    }
    if (run.status == without_client && run.signal == 0 && !run.blocked_call && !run.timed_out)
        return "";
    const std::string when = " before any function is called: look at what it defines globally\n";
    const bool is_out_of_time = run.signal == SIGXCPU || run.signal == SIGKILL;
    if (run.timed_out || is_out_of_time) return "does not return" + when;
    if (run.stopped) return "stops itself" + when;
    if (run.flooded) return "prints too much" + when;
    if (run.blocked_call) return "tries to " + words_for_blocked_call(*run.blocked_call) + when;
    if (run.signal != 0) return std::string("crashes (") + strsignal(run.signal) + ")" + when;
    return "ends the program" + when;
}

bool is_plain_file(const fs::path& path)
{
    std::error_code error;
    return fs::symlink_status(path, error).type() == fs::file_type::regular;
}

void take_over(const fs::path& made, const fs::path& place)
{
    if (!is_plain_file(made)) throw std::runtime_error(made.string() + ": expected a file");
    const fs::path draft = place.string() + ".new";
    fs::remove(draft);
    write_copy(made, draft);
    await_no_writer(draft);
    fs::rename(draft, place);
    fs::remove(made);
}

} // namespace rigor
