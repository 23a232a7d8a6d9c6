// SPDX-License-Identifier: MIT
// The skip of loading a renderer: the time of a process that draws nothing, with and without the
// renderer linked in.
#include "run.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

namespace {

// Runs `program --help` with these environment variables added.
// @return the number of lines of its output
int lines_of(const std::string& program, const std::vector<std::string>& variables)
{
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe to a process");
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        for (const std::string& variable : variables)
            putenv(const_cast<char*>(variable.c_str()));
        execl(program.c_str(), program.c_str(), "--help", static_cast<char*>(nullptr));
        _exit(127);
    }
    close(ends[1]);
    int lines = 0, status = 0;
    std::FILE* output = fdopen(ends[0], "r");
    for (int c = 0; (c = std::fgetc(output)) != EOF;)
        lines += c == '\n';
    std::fclose(output);
    waitpid(child, &status, 0);
    if (status != 0) throw std::runtime_error(program + " --help did not end as it should");
    return lines;
}

SkipRun start(const std::string& program, const std::vector<std::string>& variables)
{
    SkipRun run;
    int lines = 0;
    run.seconds = seconds([&] { lines = lines_of(program, variables); });
    run.result = {static_cast<double>(lines)};
    std::vector<std::string> tracing = variables;
    tracing.emplace_back("LD_TRACE_LOADED_OBJECTS=1"); // the loader lists what it loads
    run.counter = lines_of(program, tracing);
    return run;
}

} // namespace

std::vector<SkipCase> process_skips()
{
    const std::string program = RIGOR_BINARY_DIR "/bin/rigor";
    const std::string renderer = RIGOR_MODULE_DIR "/render_osmesa.so";
    if (!std::filesystem::exists(program) || !std::filesystem::exists(renderer)) return {};
    return {{"no renderer without a picture", "a process from start to end, the renderer linked in",
             "libraries loaded", [=] { return start(program, {}); },
             [=] { return start(program, {"LD_PRELOAD=" + renderer}); }, 0}};
}

} // namespace rigor
