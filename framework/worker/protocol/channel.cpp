// SPDX-License-Identifier: MIT
// Waiting on a word of shared memory. A process that waits first spins for some microseconds, in
// which it also yields its processor to other processes, and then sleeps in a futex until the other
// process wakes it. The time to spin adapts to whether spinning has helped. If a client finds out
// that it shares its processor with the worker, it moves to another one.
#include "worker/protocol/channel.hpp"

#include "formulas/table.hpp"
#include "worker/protocol/processor.hpp"

#include <climits>
#include <ctime>
#include <linux/futex.h>
#include <optional>
#include <sched.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

namespace {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

// If both processes have a processor, an answer comes in under a microsecond, while waking a
// process that sleeps on another processor takes 50 µs. If there is only one processor, or all are
// busy, spinning only keeps the other process from answering. So the time to spin is halved each
// time that spinning fails, down to zero, and spinning is tried again from time to time. The
// longest time to spin is longer than a test needs to compare an answer and to ask again: when it
// was 20 µs, most calls of a test had to wake a process. In its first waits, a process waits for
// the start of the other one, which takes longer than any spinning; so it begins with the short
// time.
constexpr Microseconds longest_spin(100), spin_of_a_try(20);
constexpr int waits_between_tries = 32;

// The scheduler often puts both processes on one processor, and leaves them there for milliseconds
// although another one is idle. Then each answer comes in a `sched_yield`, and takes several times
// as long. So after this many such answers in a row, the client moves if a processor is idle, which
// it does not ask too often.
constexpr int yields_before_move = 8;
constexpr std::chrono::milliseconds between_moves(3);
std::atomic<bool> may_move = false;

struct Spinning {
    // With one processor, the other process cannot answer as long as this one spins.
    bool is_useless = has_one_processor();
    Microseconds time = spin_of_a_try;
    int waits_without = 0;
    int answers_after_yield = 0;
    Clock::time_point last_move;

    // @param after_yield  whether the answer was there as soon as `sched_yield` returned
    void succeeded(bool after_yield)
    {
        time = longest_spin;
        answers_after_yield = after_yield ? answers_after_yield + 1 : 0;
        if (answers_after_yield < yields_before_move || !may_move) return;
        answers_after_yield = 0;
        const Clock::time_point now = Clock::now();
        if (now - last_move < between_moves) return;
        last_move = now;
        if (has_idle_processor()) leave_processor();
    }
    void failed() { time = time > Microseconds(4) ? time / 2 : Microseconds(0); }
    Microseconds next()
    {
        if (is_useless) return Microseconds(0);
        if (time > Microseconds(0)) return time;
        if (++waits_without < waits_between_tries) return Microseconds(0);
        waits_without = 0;
        return spin_of_a_try;
    }
};
thread_local Spinning spinning;

void pause_processor()
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

} // namespace

std::uint64_t contract_fingerprint()
{
    std::uint64_t hash = 14695981039346656037u; // FNV-1a (Fowler, Noll and Vo)
    const auto add = [&](std::string_view text) {
        for (const char c : text)
            hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    };
    add("rigor worker 4");
    for (const Formula& formula : formulas) {
        add(formula.tag);
        add(formula.name);
        add(formula.arguments);
    }
    return hash;
}

void allow_moves()
{
    may_move = true;
}

void wake(std::atomic<std::uint32_t>& word, const std::atomic<std::uint32_t>& awaited)
{
    if (awaited.load() != 0) syscall(SYS_futex, &word, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

// One process sets the word and then reads `awaited`; the other one sets `awaited` and then reads
// the word. All four accesses are sequentially consistent, so at least one process sees what the
// other has set.
void post(std::atomic<std::uint32_t>& word, const std::atomic<std::uint32_t>& awaited,
          std::uint32_t value)
{
    word.store(value);
    wake(word, awaited);
}

std::uint32_t await_change(std::atomic<std::uint32_t>& word, std::atomic<std::uint32_t>& awaited,
                           std::uint32_t old, std::chrono::nanoseconds longest, const Until* other)
{
    const auto other_has_changed = [&] { return other && other->word.load() != other->old; };
    if (const Microseconds spin = spinning.next(); spin > Microseconds(0)) {
        // The word is read 32 times before the clock is read for the first time, because most
        // answers come earlier.
        for (std::optional<Clock::time_point> start;;) {
            for (int i = 0; i < 32; ++i) {
                if (const std::uint32_t now = word.load(std::memory_order_acquire); now != old) {
                    spinning.succeeded(start && i == 0);
                    return now;
                }
                if (other_has_changed()) {
                    spinning.succeeded(start && i == 0);
                    return old;
                }
                pause_processor();
            }
            const Clock::time_point now = Clock::now();
            if (!start) start = now;
            if (now - *start >= spin) break;
            sched_yield(); // to the other process, if it waits for this processor
        }
        spinning.failed();
    }
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(longest);
    const timespec timeout = {whole.count(), (longest - whole).count()};
    awaited.store(1);
    // The futex call returns at once if the word has changed meanwhile. It may also return although
    // the word has not changed; then the caller waits again.
    if (word.load() == old && !other_has_changed())
        syscall(SYS_futex, &word, FUTEX_WAIT, old, &timeout, nullptr, 0);
    awaited.store(0, std::memory_order_relaxed);
    return word.load(std::memory_order_acquire);
}

} // namespace rigor
