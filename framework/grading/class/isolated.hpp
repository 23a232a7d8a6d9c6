// SPDX-License-Identifier: MIT
// Work in processes of its own: a crash of the framework costs only what crashed. A process costs a
// millisecond, and threads would share the crash.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <sys/types.h>

namespace rigor {

/// A function that runs in a forked process. It must not rely on threads of this process. The
/// process ends when this one does. What it prints is kept from the terminal.
class Isolated {
public:
    /// @throws InputError if the machine has no memory or no process for it
    explicit Isolated(const std::function<std::string()>& work);
    /// Ends the process if it still runs.
    ~Isolated();
    Isolated(const Isolated&) = delete;
    Isolated& operator=(const Isolated&) = delete;

    /// Whether the process has ended. Does not wait.
    bool has_ended();
    /// Ends the process, and with it all that it started.
    void stop();
    /// What the function returned; nothing if it threw or crashed.
    std::optional<std::string> text() const;
    /// What went wrong, in one line.
    std::string fault() const;

private:
    pid_t process_ = -1;
    int text_, said_; // files in memory: the result, and what the process printed
    int state_ = 0;
    bool has_ended_ = false;
};

/// For work that may take any time.
inline constexpr std::chrono::duration<double> no_limit{std::numeric_limits<double>::infinity()};

/// How one piece of work ended.
struct WorkDone {
    std::size_t index = 0;
    std::optional<std::string> text; // what the function returned
    std::string fault;               // why there is no text
    bool was_tried_twice = false;
};

/// Runs `work(i)` for each `i < count`, up to `jobs` at a time, each isolated. What fails is tried
/// once more. What takes longer than `longest` is ended, and not tried again. `on_done` is called
/// in this process, in the order in which they end, and `on_wait` while it waits.
void run_isolated(std::size_t count, unsigned jobs,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(const WorkDone&)>& on_done,
                  const std::function<void()>& on_wait = {},
                  std::chrono::duration<double> longest = no_limit);

} // namespace rigor
