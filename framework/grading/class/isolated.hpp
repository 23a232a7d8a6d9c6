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

/// The value of the parameter `longest` of `run_isolated` for work without a time limit.
inline constexpr std::chrono::duration<double> no_limit{std::numeric_limits<double>::infinity()};

/// How one piece of work ended.
struct WorkDone {
    std::size_t index = 0;
    std::optional<std::string> text; // what the function returned
    std::string fault;               // why there is no text
    bool was_tried_twice = false;
};

/// Runs `work(i)` for each `i < count`, up to `jobs` at a time, each in a separate process. Work
/// that fails is tried once more. Work that takes longer than `longest` is ended, and not tried
/// again. This process calls `on_done` each time that a piece of work is done, and `on_wait`
/// repeatedly while it waits.
void run_isolated(std::size_t count, unsigned jobs,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(const WorkDone&)>& on_done,
                  const std::function<void()>& on_wait = {},
                  std::chrono::duration<double> longest = no_limit);

} // namespace rigor
