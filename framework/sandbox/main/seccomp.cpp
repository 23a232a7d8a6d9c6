// SPDX-License-Identifier: MIT
// Makes a filter of system calls from rules. A filter is a program for the kernel's packet filter
// (BPF), which reads the number and the arguments of a call and returns an action. This filter
// first ends the process if the call is one for another architecture or of the x32 interface. Then
// it compares the number with that of each rule. The kernel remembers which calls are always
// allowed, so the length of the list does not slow these calls down.
#include "sandbox/main/seccomp.hpp"

#include "sandbox/main/failure.hpp"

#include <cerrno>
#include <cstddef>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace rigor::confine {

namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#endif
// On x86-64, numbers from here on are those of the x32 interface, which has the same calls again.
constexpr std::uint32_t second_interface = 0x40000000;

class Program {
public:
    explicit Program(std::uint32_t refusal) : refusal_(refusal)
    {
        load(offsetof(seccomp_data, arch));
        jump(BPF_JEQ, architecture, 1, 0);
        end(SECCOMP_RET_KILL_PROCESS);
        load(offsetof(seccomp_data, nr));
        jump(BPF_JGE, second_interface, 0, 1);
        end(SECCOMP_RET_KILL_PROCESS);
    }

    void add(const Rule& rule)
    {
        load(offsetof(seccomp_data, nr));
        const std::size_t start = code_.size();
        // The second 0, the length of the jump if the numbers differ, is replaced below.
        jump(BPF_JEQ, static_cast<std::uint32_t>(rule.call), 0, 0);
        check(rule);
        code_[start].jf = static_cast<std::uint8_t>(code_.size() - start - 1);
    }

    void end(Verdict verdict) { end(action(verdict)); }

    sock_fprog code() { return {static_cast<unsigned short>(code_.size()), code_.data()}; }

private:
    void check(const Rule& rule)
    {
        const Condition& condition = rule.condition;
        const auto low = offsetof(seccomp_data, args) + 8 * condition.argument;
        switch (condition.kind) {
        case Condition::always:
            return end(rule.verdict);
        case Condition::equals:
            load(low);
            jump(BPF_JEQ, condition.value, 0, 1);
            break;
        case Condition::lacks_bits:
            load(low);
            jump(BPF_JSET, condition.value, 1, 0);
            break;
        case Condition::is_null:
            load(low);
            jump(BPF_JEQ, 0, 0, 3);
            load(low + 4);
            jump(BPF_JEQ, 0, 0, 1);
            break;
        }
        end(rule.verdict);
        end(rule.otherwise);
    }

    std::uint32_t action(Verdict verdict) const
    {
        switch (verdict) {
        case Verdict::allowed:
            return SECCOMP_RET_ALLOW;
        case Verdict::declined:
            return SECCOMP_RET_ERRNO | EPERM;
        case Verdict::missing:
            return SECCOMP_RET_ERRNO | ENOSYS;
        case Verdict::refused:
            break;
        }
        return refusal_;
    }

    void load(std::size_t offset)
    {
        code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
    }
    // `yes` and `no` are the numbers of instructions to skip if the comparison is true or false.
    void jump(unsigned comparison, std::uint32_t value, std::uint8_t yes, std::uint8_t no)
    {
        const auto instruction = static_cast<std::uint16_t>(BPF_JMP | BPF_K | comparison);
        code_.push_back(sock_filter{instruction, yes, no, value});
    }
    void end(std::uint32_t result) { code_.push_back(BPF_STMT(BPF_RET | BPF_K, result)); }

    std::uint32_t refusal_;
    std::vector<sock_filter> code_;
};

} // namespace

int filter_calls(const std::vector<Rule>& rules, Verdict others, bool notify)
{
    Program program(notify ? SECCOMP_RET_USER_NOTIF : SECCOMP_RET_KILL_PROCESS);
    for (const Rule& rule : rules)
        program.add(rule);
    program.end(others);
    const sock_fprog code = program.code();
    const unsigned flags = notify ? SECCOMP_FILTER_FLAG_NEW_LISTENER : 0;
    const long result = syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, flags, &code);
    must(result, "filter system calls");
    return notify ? static_cast<int>(result) : -1;
}

} // namespace rigor::confine
