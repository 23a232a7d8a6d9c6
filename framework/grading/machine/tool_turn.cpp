// SPDX-License-Identifier: MIT
// The turns are the bytes of a file in memory, which forked processes inherit. Whoever opens this
// file again and locks a byte of it has a turn, until what it has opened is closed.
#include "grading/machine/tool_turn.hpp"

#include "errors/input_error.hpp"
#include "grading/machine/allotment.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <thread>

namespace rigor {

namespace {

struct Turns {
    ToolShare share;
    int file;
};

Turns made_turns()
{
    const int file = memfd_create("turns", MFD_CLOEXEC);
    if (file >= 0) return {tool_share(usable_processors(), usable_memory()), file};
    throw InputError(fmt::format(
        "expected shared memory for the turns of compilers, found none: {}", std::strerror(errno)));
}

const Turns& turns()
{
    static const Turns made = made_turns();
    return made;
}

bool lock(int file, unsigned byte)
{
    struct flock one = {};
    one.l_type = F_WRLCK;
    one.l_whence = SEEK_SET;
    one.l_start = byte;
    one.l_len = 1;
    return fcntl(file, F_OFD_SETLK, &one) == 0;
}

} // namespace

// The tools get three quarters of the memory. The grader keeps the rest.
ToolShare tool_share(unsigned processors, std::uint64_t memory)
{
    constexpr std::uint64_t most = std::uint64_t{6} << 30,
                            least = std::uint64_t{1} << 30; // [bytes]; a solution needs 600 MB
    const std::uint64_t pairs = memory / 4 * 3 / 2;         // a compiler and its assembler
    ToolShare share;
    share.at_once = static_cast<unsigned>(
        std::clamp<std::uint64_t>(pairs / least, 1, std::max(1u, processors)));
    share.memory = std::clamp(pairs / share.at_once, least, most);
    return share;
}

const ToolShare& own_tool_share()
{
    return turns().share;
}

void make_tool_turns()
{
    turns();
}

ToolTurn::ToolTurn()
{
    const std::string path = fmt::format("/proc/self/fd/{}", turns().file);
    lock_ = Descriptor(open(path.c_str(), O_RDWR | O_CLOEXEC), path.c_str());
    for (unsigned i = 0; !lock(lock_, i); i = (i + 1) % turns().share.at_once)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

} // namespace rigor
