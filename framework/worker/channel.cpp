// SPDX-License-Identifier: MIT
#include "worker/channel.hpp"

#include "formulas/table.hpp"

#include <climits>
#include <ctime>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor {

namespace {

// A reply to a formula takes under a microsecond; waking a sleeper on another processor takes fifty.
constexpr std::chrono::microseconds spin_time(20);

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
    add("rigor worker 1");
    for (const Formula& formula : formulas) {
        add(formula.tag);
        add(formula.name);
        add(formula.arguments);
    }
    return hash;
}

void post(std::atomic<std::uint32_t>& word, std::uint32_t value)
{
    word.store(value, std::memory_order_release);
    syscall(SYS_futex, &word, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

std::uint32_t await_change(const std::atomic<std::uint32_t>& word, std::uint32_t old,
                           std::chrono::nanoseconds longest)
{
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    while (Clock::now() - start < spin_time) {
        for (int i = 0; i < 32; ++i) {
            if (const std::uint32_t now = word.load(std::memory_order_acquire); now != old)
                return now;
            pause_processor();
        }
    }
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(longest);
    const timespec timeout = {whole.count(), (longest - whole).count()};
    // Returns at once if the word has changed meanwhile; early wakes are the caller's to repeat.
    syscall(SYS_futex, &word, FUTEX_WAIT, old, &timeout, nullptr, 0);
    return word.load(std::memory_order_acquire);
}

} // namespace rigor
