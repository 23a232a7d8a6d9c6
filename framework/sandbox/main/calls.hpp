// SPDX-License-Identifier: MIT
// The tables of system calls: what a worker may call, and what a compiler may not.
#pragma once

#include <cstdint>
#include <vector>

namespace rigor::confine {

/// A condition on one argument of a call. `equals` and `lacks_bits` (no bit of `value` is set) look
/// at the lower 32 bits, enough for flags, descriptors and process ids; `is_null` looks at all 64.
struct Condition {
    enum Kind { always, equals, lacks_bits, is_null } kind = always;
    unsigned argument = 0; // counted from 0
    std::uint32_t value = 0;
};

/// What happens to a call.
enum class Verdict {
    allowed,
    refused,  // the call does not happen, and the grader learns of it
    declined, // the call fails with EPERM and nobody is told, since programs can do without it
    missing,  // the call fails with ENOSYS, so that the C library makes an older call instead
};

struct Rule {
    int call; // number of the system call, such as SYS_read
    Verdict verdict;
    Condition condition = {};
    Verdict otherwise = Verdict::refused; // the verdict if the condition does not hold
};

/// The process id and the descriptors that the rules of a worker refer to.
struct OwnNumbers {
    std::uint32_t process; // the id that getpid returns in this process
    // Both descriptors are closed when the program starts.
    std::uint32_t report;  // the descriptor of the socket to the grader
    std::uint32_t program; // the descriptor of the program's file
};

/// The calls that a worker may make, and those that are declined; all others are refused. With
/// `grader_allows_start`, the execveat that starts the program is refused too, so it waits until
/// the grader lets it happen.
std::vector<Rule> worker_rules(const OwnNumbers& own, bool grader_allows_start);

/// The calls that are forbidden to a compiler, `clone` only with some flags. All others are
/// allowed.
std::vector<Rule> compiler_rules();

} // namespace rigor::confine
