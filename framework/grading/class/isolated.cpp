// SPDX-License-Identifier: MIT
#include "grading/class/isolated.hpp"

#include "errors/input_error.hpp"
#include "errors/printable.hpp"
#include "grading/class/processors.hpp"
#include "sandbox/notice_children.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <exception>
#include <fcntl.h>
#include <fmt/format.h>
#include <list>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace rigor {

namespace {

constexpr int failed_status = 3;

[[noreturn]] void fail_for_want_of(const char* what, int error)
{
    throw InputError(fmt::format("expected {} for grading a submission, found none: {}", what,
                                 std::strerror(error)));
}

int file_in_memory(const char* name)
{
    const int file = memfd_create(name, MFD_CLOEXEC);
    if (file < 0) fail_for_want_of("shared memory", errno);
    return file;
}

bool write_all(int file, std::string_view text)
{
    while (!text.empty()) {
        const ssize_t n = write(file, text.data(), text.size());
        if (n <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
}

std::string content_of(int file)
{
    std::string text;
    std::array<char, 65536> block;
    for (ssize_t n;
         (n = pread(file, block.data(), block.size(), static_cast<off_t>(text.size()))) > 0;)
        text.append(block.data(), static_cast<std::size_t>(n));
    return text;
}

std::string last_line(std::string text)
{
    while (text.ends_with('\n'))
        text.pop_back();
    return printable(text.substr(text.rfind('\n') + 1).substr(0, 300));
}

[[noreturn]] void work_and_exit(const std::function<std::string()>& work, int text, int said)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
    dup2(nothing, STDIN_FILENO);
    dup2(said, STDOUT_FILENO);
    dup2(said, STDERR_FILENO);
    try {
        const bool ok = write_all(text, work());
        _exit(ok ? 0 : failed_status);
    } catch (const std::exception& error) {
        write_all(said, std::string("\n") + error.what());
    } catch (...) {
        write_all(said, "\nan exception of unknown type");
    }
    _exit(failed_status);
}

} // namespace

Isolated::Isolated(const std::function<std::string()>& work)
    : text_(file_in_memory("result")), said_(file_in_memory("said"))
{
    notice_children();
    std::fflush(nullptr); // otherwise the new process would print the buffered text again
    process_ = fork();
    if (process_ == 0) work_and_exit(work, text_, said_);
    if (process_ > 0) return;
    const int error = errno;
    close(text_);
    close(said_);
    fail_for_want_of("a process", error);
}

Isolated::~Isolated()
{
    stop();
    close(text_);
    close(said_);
}

bool Isolated::has_ended()
{
    if (!has_ended_) has_ended_ = waitpid(process_, &state_, WNOHANG) == process_;
    return has_ended_;
}

void Isolated::stop()
{
    if (has_ended_) return;
    kill(process_, SIGKILL);
    while (waitpid(process_, &state_, 0) < 0 && errno == EINTR) {
    }
    has_ended_ = true;
}

std::optional<std::string> Isolated::text() const
{
    if (!has_ended_ || !WIFEXITED(state_) || WEXITSTATUS(state_) != 0) return {};
    return content_of(text_);
}

std::string Isolated::fault() const
{
    const std::string words = last_line(content_of(said_));
    if (!WIFSIGNALED(state_)) return words.empty() ? "it gave up without a word" : words;
    return fmt::format("it was ended by signal {}{}{}", WTERMSIG(state_),
                       words.empty() ? "" : "; its last words: ", words);
}

namespace {

using Clock = std::chrono::steady_clock;

struct Running {
    std::size_t index;
    bool is_second_try;
    int processor; // from `Processors::take`
    std::unique_ptr<Isolated> process;
    Clock::time_point start = Clock::now();
};

// How a piece of work that has ended, or was ended because it took too long, is reported.
WorkDone report_of(const Running& ended, bool is_late, std::chrono::duration<double> longest)
{
    if (is_late)
        return {ended.index,
                {},
                fmt::format("it took more than {:.3g} s", longest.count()),
                ended.is_second_try};
    const std::optional<std::string> text = ended.process->text();
    return {ended.index, text, text ? "" : ended.process->fault(), ended.is_second_try};
}

} // namespace

void run_isolated(std::size_t count, const Isolation& how,
                  const std::function<std::string(std::size_t)>& work,
                  const std::function<void(const WorkDone&)>& on_done,
                  const std::function<void()>& on_wait)
{
    Processors processors;
    std::deque<std::pair<std::size_t, bool>> waiting; // index, and whether it is the second try
    for (std::size_t i = 0; i < count; ++i)
        waiting.emplace_back(i, false);
    std::list<Running> running;
    const auto start_next = [&] {
        const auto [index, is_second_try] = waiting.front();
        waiting.pop_front();
        const int processor = how.on_one_processor ? processors.take() : -1;
        running.push_back({index, is_second_try, processor,
                           std::make_unique<Isolated>([&work, processor, i = index] {
                               keep_to(processor);
                               return work(i);
                           })});
    };
    while (!waiting.empty() || !running.empty()) {
        while (!waiting.empty() && running.size() < std::max(1u, how.jobs))
            start_next();
        for (auto entry = running.begin(); entry != running.end();) {
            const bool is_late =
                !entry->process->has_ended() && Clock::now() - entry->start > how.longest;
            if (is_late) entry->process->stop();
            if (!entry->process->has_ended()) {
                ++entry;
                continue;
            }
            processors.give_back(entry->processor);
            const WorkDone done = report_of(*entry, is_late, how.longest);
            if (done.text || is_late || entry->is_second_try)
                on_done(done);
            else
                waiting.emplace_front(entry->index, true);
            entry = running.erase(entry);
        }
        if (on_wait) on_wait();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
}

} // namespace rigor
