// SPDX-License-Identifier: MIT
// Runs a program as a child process. Its output comes through one pipe, and what it writes to
// `message_descriptor` through another. Both are split into lines while the program runs. A program
// that is silent for too long gets SIGTERM, and two seconds later SIGKILL.
#include "grading/process.hpp"

#include "sandbox/argument_pointers.hpp"
#include "sandbox/notice_children.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// A pipe. What arrives at its read end is split into lines.
class LinePipe {
public:
    explicit LinePipe(const OnLine& on_line) : on_line_(on_line)
    {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0)
            throw std::runtime_error("pipe: " + std::string(std::strerror(errno)));
        read_ = ends[0];
        write_ = ends[1];
        fcntl(read_, F_SETFL, O_NONBLOCK);
    }
    ~LinePipe()
    {
        close_end(read_);
        close_end(write_);
    }
    LinePipe(const LinePipe&) = delete;
    LinePipe& operator=(const LinePipe&) = delete;

    int read_end() const { return read_; }
    int write_end() const { return write_; }
    bool is_open() const { return read_ >= 0; }
    void close_write() { close_end(write_); }

    // Reads everything that is available. @return whether there was anything
    bool drain()
    {
        std::array<char, 65536> buffer;
        bool any = false;
        while (is_open()) {
            const ssize_t n = read(read_, buffer.data(), buffer.size());
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) break; // EAGAIN: no more data at present
            if (n == 0) {
                if (!pending_.empty()) on_line_(pending_);
                close_end(read_);
                break;
            }
            any = true;
            pending_.append(buffer.data(), static_cast<std::size_t>(n));
            hand_over();
        }
        return any;
    }

private:
    void hand_over()
    {
        std::size_t from = 0;
        for (std::size_t end; (end = pending_.find('\n', from)) != std::string::npos;
             from = end + 1)
            on_line_(std::string_view(pending_).substr(from, end - from));
        pending_.erase(0, from);
        constexpr std::size_t longest_line = 1 << 20; // [bytes], limits the memory for a line
        if (pending_.size() < longest_line) return;
        on_line_(pending_);
        pending_.clear();
    }

    static void close_end(int& end)
    {
        if (end >= 0) close(end);
        end = -1;
    }

    const OnLine& on_line_;
    std::string pending_;
    int read_ = -1, write_ = -1;
};

std::vector<std::string> environment_with(const std::vector<std::string>& additions)
{
    // The additions come before the inherited variables: the first of two equal names counts.
    std::vector<std::string> result = additions;
    for (char** variable = environ; *variable; ++variable)
        result.emplace_back(*variable);
    return result;
}

// Runs in the child process: only calls that are safe between fork and exec are made here.
[[noreturn]] void become(const Command& command, char* const* arguments, char** variables,
                         int output, int messages, int failure)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (command.memory) {
        const rlimit limit = {command.memory, command.memory};
        setrlimit(RLIMIT_AS, &limit);
    }
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    if (!command.shares_stderr) dup2(output, STDERR_FILENO);
    if (messages == message_descriptor)
        fcntl(messages, F_SETFD, 0);
    else if (messages >= 0)
        dup2(messages, message_descriptor);
    if (command.folder.empty() || chdir(command.folder.c_str()) == 0)
        execvpe(arguments[0], arguments, variables);
    const int error = errno;
    if (write(failure, &error, sizeof error) < 0) _exit(126);
    _exit(127);
}

void collect(pid_t child, const Command& command, LinePipe& output, LinePipe& messages,
             Ended& ended)
{
    const Clock::time_point start = Clock::now();
    Clock::time_point heard = start, asked_to_end = {};
    for (int state = 0;;) {
        std::array<pollfd, 2> waiting = {pollfd{output.read_end(), POLLIN, 0},
                                         pollfd{messages.read_end(), POLLIN, 0}};
        poll(waiting.data(), waiting.size(), output.is_open() || messages.is_open() ? 20 : 2);
        const bool some_output = output.drain(), some_message = messages.drain();
        if (some_output || some_message) heard = Clock::now();

        if (waitpid(child, &state, WNOHANG) == child) {
            output.drain();
            messages.drain();
            ended.seconds = seconds_since(start);
            if (WIFSIGNALED(state)) ended.signal = WTERMSIG(state);
            if (WIFEXITED(state)) ended.status = WEXITSTATUS(state);
            return;
        }
        if (!ended.timed_out && command.silence > 0 && seconds_since(heard) > command.silence) {
            ended.timed_out = true;
            asked_to_end = Clock::now();
            kill(child, SIGTERM); // ninja passes this signal on to the compilers
        } else if (ended.timed_out && seconds_since(asked_to_end) > 2) {
            kill(child, SIGKILL);
        }
    }
}

} // namespace

Ended run(const Command& command, const OnLine& on_output, const OnLine& on_message)
{
    notice_children();
    const std::vector<char*> arguments = argument_pointers(command.arguments);
    const std::vector<std::string> environment = environment_with(command.environment);
    std::vector<char*> variables = argument_pointers(environment);
    int failure[2];
    if (pipe2(failure, O_CLOEXEC) != 0)
        throw std::runtime_error("pipe: " + std::string(std::strerror(errno)));
    // A descriptor of at least 10, because `become` overwrites the descriptors up to
    // `message_descriptor`.
    const int report = fcntl(failure[1], F_DUPFD_CLOEXEC, 10);
    close(failure[1]);
    LinePipe output(on_output), messages(on_message);

    const pid_t child = fork();
    if (child == 0)
        become(command, arguments.data(), variables.data(), output.write_end(),
               on_message ? messages.write_end() : -1, report);
    close(report);
    output.close_write();
    messages.close_write();
    int error = child < 0 ? errno : 0;
    const bool failed = child < 0 || read(failure[0], &error, sizeof error) == sizeof error;
    close(failure[0]);
    if (failed) {
        if (child > 0) waitpid(child, nullptr, 0);
        throw std::runtime_error(command.arguments[0] +
                                 " cannot be started: " + std::strerror(error));
    }
    Ended ended;
    collect(child, command, output, messages, ended);
    return ended;
}

bool is_installed(const std::string& program)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
    return false;
}

} // namespace rigor
