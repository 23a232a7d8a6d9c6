// SPDX-License-Identifier: MIT
// A run of the pile in a forked process, which sends its result back through a pipe.
#include "run.hpp"

#include "rigid/parallel/keep_memory.hpp"

#include <cstdio>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

namespace {

template <class T> bool write_all(std::FILE* file, const std::vector<T>& values)
{
    const std::size_t n = values.size();
    return std::fwrite(&n, sizeof n, 1, file) == 1 &&
           std::fwrite(values.data(), sizeof(T), n, file) == n;
}

template <class T> bool read_all(std::FILE* file, std::vector<T>& values)
{
    std::size_t n = 0;
    if (std::fread(&n, sizeof n, 1, file) != 1) return false;
    values.resize(n);
    return std::fread(values.data(), sizeof(T), n, file) == n;
}

[[noreturn]] void answer(int descriptor, const std::function<PileRun()>& run)
{
    keep_freed_memory(); // the same for every engine
    bool done = false;
    try {
        const PileRun result = run();
        std::FILE* file = fdopen(descriptor, "wb");
        done = file && write_all(file, result.step_seconds) && write_all(file, result.cubes) &&
               write_all(file, std::vector<double>{result.asleep}) && std::fflush(file) == 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
    }
    _exit(done ? 0 : 1);
}

} // namespace

PileRun in_fresh_process(const std::function<PileRun()>& run)
{
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe to a process of its own");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process of its own");
    if (child == 0) {
        close(ends[0]);
        answer(ends[1], run);
    }
    close(ends[1]);
    PileRun result;
    std::vector<double> asleep;
    std::FILE* file = fdopen(ends[0], "rb");
    const bool read = file && read_all(file, result.step_seconds) && read_all(file, result.cubes) &&
                      read_all(file, asleep) && asleep.size() == 1;
    if (file) std::fclose(file);
    int status = 0;
    waitpid(child, &status, 0);
    if (!read || status != 0) throw std::runtime_error("a run of the pile did not come to its end");
    result.asleep = asleep[0];
    return result;
}

} // namespace rigor
