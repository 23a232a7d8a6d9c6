// SPDX-License-Identifier: MIT
// Runs each piece of work in a separate process, so that a crash of the framework costs only this
// piece. In a thread, a crash would end the whole program. Starting a process takes about 1 ms.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <sys/types.h>

namespace rigor {

/// A function that runs in a forked process. It must not need other threads of the parent process,
/// which a fork does not copy. The forked process ends when its parent ends. What it prints does
/// not reach the terminal.
class Isolated {
public:
    /// @throws InputError if the machine has no memory or no process left
    explicit Isolated(const std::function<std::string()>& work);
    /// Ends the process if it still runs.
    ~Isolated();
    Isolated(const Isolated&) = delete;
    Isolated& operator=(const Isolated&) = delete;

    /// Whether the process has ended. Does not wait.
    bool has_ended();
    /// Kills the process. The programs that it started by `run` or `Confined` then get SIGTERM from
    /// the kernel.
    void stop();
    /// What the function returned; no value before the process has ended or if it threw or crashed.
    std::optional<std::string> text() const;
    /// Why the function returned nothing, in one line.
    std::string fault() const;

private:
    pid_t process_ = -1;
    int text_, said_; // files in memory: the result, and what the process printed
    int state_ = 0;
    bool has_ended_ = false;
};

/// How `run_isolated` runs its work.
struct Isolation {
    unsigned jobs = 1; // how many pieces of work run at the same time
    /// Whether a piece of work, with all that it starts, keeps to one processor.
    bool on_one_processor = false;
    /// Work that takes longer is ended.
    std::chrono::duration<double> longest{std::numeric_limits<double>::infinity()};
};

/// How one piece of work ended.
struct WorkDone {
    std::size_t index = 0;
    std::optional<std::string> text; // what the function returned
    std::string fault;               // why there is no text
    bool was_tried_twice = false;
};

/// Runs `work(i)` for each `i < count`, each in a separate process. Work that fails is tried once
/// more, but not work that took too long. This process calls `on_done` each time that a piece of
/// work is done, and `on_wait` repeatedly while it waits.
void run_isolated(std::size_t count, const Isolation& how,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(const WorkDone&)>& on_done,
                  const std::function<void()>& on_wait = {});

} // namespace rigor
