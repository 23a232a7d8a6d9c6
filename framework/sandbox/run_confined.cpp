// SPDX-License-Identifier: MIT
// Waits for three events at once: output, the end of the monitor, and a blocked call, but not
// longer than the limit on time. Ten times a second, it also looks whether the program has stopped
// itself. The rest of the output is read after all processes have ended, unless the program has
// printed too much.
#include "sandbox/run_confined.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <poll.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace rigor {

namespace {

using Clock = std::chrono::steady_clock;

// How many processes the kernel has ended because memory ran out, since the machine was started.
std::uint64_t count_of_oom_kills()
{
    std::ifstream counts("/proc/vmstat");
    std::uint64_t count = 0;
    for (std::string name; counts >> name >> count;)
        if (name == "oom_kill") return count;
    return 0;
}

class Run {
public:
    Run(const Confinement& confinement, const std::vector<std::string>& arguments,
        const RunLimits& limits, int input)
        : limits_(limits), empty_(no_input()), output_(output_pipe()),
          program_(
              confinement, arguments,
              std::array<int, 3>{input >= 0 ? input : int(empty_), output_.write, output_.write}),
          ended_(static_cast<int>(syscall(SYS_pidfd_open, program_.monitor(), 0)), "pidfd_open")
    {
        output_.write = {};
    }

    ConfinedRun to_the_end()
    {
        while (!is_over())
            wait_a_moment();
        look_at_ending();
        result_.oom_kills = count_of_oom_kills() - oom_kills_before_;
        result_.seconds = seconds();
        const rusage used = program_.end();
        for (const timeval& time : {used.ru_utime, used.ru_stime})
            result_.processor_seconds +=
                static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        drain();
        return std::move(result_);
    }

private:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    bool is_over()
    {
        drain();
        result_.blocked_call = program_.blocked_call();
        result_.stopped = has_stopped();
        result_.timed_out = seconds() > limits_.time.count();
        return has_ended_ || result_.blocked_call || result_.stopped || result_.timed_out ||
               result_.flooded;
    }

    // The monitor stops if the program has stopped.
    bool has_stopped() const
    {
        siginfo_t info{};
        return waitid(P_PID, program_.monitor(), &info, WSTOPPED | WNOHANG | WNOWAIT) == 0 &&
               info.si_pid != 0;
    }

    void wait_a_moment()
    {
        pollfd waiting[] = {{ended_, POLLIN, 0},
                            {output_is_open_ ? int(output_.read) : -1, POLLIN, 0},
                            {listener_is_open_ ? program_.listener() : -1, POLLIN, 0}};
        constexpr double longest = 0.1; // [s]; nothing here tells that the monitor has stopped
        const double left = std::clamp(limits_.time.count() - seconds(), 0.0, longest);
        poll(waiting, 3, static_cast<int>(1000 * left) + 1);
        has_ended_ = waiting[0].revents != 0;
        // A listener whose processes have all ended would be ready forever, so it is left out.
        if (waiting[2].revents & POLLHUP) listener_is_open_ = false;
    }

    void drain()
    {
        std::array<char, 65536> buffer;
        while (!result_.flooded && output_is_open_) {
            const ssize_t n = read(output_.read, buffer.data(), buffer.size());
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) return; // no more output for now
            output_is_open_ = n > 0;
            printed_ += static_cast<std::size_t>(n);
            const std::size_t room = limits_.output_kept - result_.output.size();
            result_.output.append(buffer.data(), std::min<std::size_t>(n, room));
            result_.flooded = printed_ > limits_.output;
        }
    }

    void look_at_ending()
    {
        siginfo_t info{};
        if (waitid(P_PID, program_.monitor(), &info, WEXITED | WNOHANG | WNOWAIT) != 0) return;
        if (info.si_pid == 0) return; // the program still runs: a limit or a blocked call ends it
        (info.si_code == CLD_EXITED ? result_.status : result_.signal) = info.si_status;
    }

    RunLimits limits_;
    Clock::time_point start_ = Clock::now();
    std::uint64_t oom_kills_before_ = count_of_oom_kills();
    Descriptor empty_;
    Ends output_;
    Confined program_;
    Descriptor ended_; // readable when the monitor has ended
    bool has_ended_ = false, output_is_open_ = true, listener_is_open_ = true;
    std::size_t printed_ = 0; // [bytes]
    ConfinedRun result_;
};

} // namespace

ConfinedRun run_confined(const Confinement& confinement, const std::vector<std::string>& arguments,
                         const RunLimits& limits, int input)
{
    return Run(confinement, arguments, limits, input).to_the_end();
}

} // namespace rigor
