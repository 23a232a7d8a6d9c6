// SPDX-License-Identifier: MIT
// Finds out which tier is possible. The launcher tries each wall, that is, each part of the sandbox
// (sandbox/main/probe.cpp), and prints which ones work. A tier is a set of walls that together can
// be relied on (`is_possible`). Without a filter of system calls there is only tier C, limits on
// resources. The same is true if there is a filter but neither its listener in the grader
// (seccomp's user notification) nor Landlock, because then a program could start other programs.
#include "sandbox/tier.hpp"

#include "errors/input_error.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/launcher.hpp"
#include "sandbox/notice_children.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <optional>
#include <random>
#include <spawn.h>
#include <sstream>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace rigor {

namespace {

// What the launcher prints with --probe: the walls that work, in one line.
std::string probed()
{
    notice_children();
    Ends ends = output_pipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends.write, STDOUT_FILENO);
    std::string user = "--user=" + std::to_string(unused_user()), option = "--probe";
    char* arguments[] = {const_cast<char*>(launcher_path), option.data(), user.data(), nullptr};
    pid_t pid = -1;
    const int error = posix_spawn(&pid, launcher_path, &actions, nullptr, arguments, arguments + 3);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::system_error(error, std::generic_category(), launcher_path);
    while (waitpid(pid, nullptr, 0) < 0 && errno == EINTR) {
    }
    std::string line(512, '\0');
    const ssize_t n = read(ends.read, line.data(), line.size());
    line.resize(n > 0 ? n : 0);
    return line;
}

Walls read_walls(const std::string& line)
{
    Walls walls;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
        if (word == "namespaces=plain") walls.namespaces = Walls::Namespaces::plain;
        if (word == "namespaces=user") walls.namespaces = Walls::Namespaces::user;
        if (word == "user") walls.another_user = true;
        if (word == "seccomp=notify") walls.filter = walls.listener = true;
        if (word == "seccomp=kill") walls.filter = true;
        if (word == "landlock") walls.landlock = true;
    }
    return walls;
}

std::optional<Tier> wanted_tier()
{
    const char* wanted = std::getenv("RIGOR_TIER");
    if (!wanted) return {};
    const std::string name = wanted;
    if (name == "A") return Tier::a;
    if (name == "B") return Tier::b;
    if (name == "C") return Tier::c;
    throw InputError(fmt::format("RIGOR_TIER: expected A, B or C, found '{}'", name));
}

} // namespace

const Walls& possible_walls()
{
    static const Walls walls = read_walls(probed());
    return walls;
}

bool is_possible(Tier tier, const Walls& walls)
{
    switch (tier) {
    case Tier::a:
        return walls.filter && (walls.landlock || walls.listener) &&
               walls.namespaces != Walls::Namespaces::none;
    case Tier::b: // without namespaces, only Landlock keeps the compiler from reading other files
        return walls.filter && walls.landlock;
    case Tier::c:
        return true;
    }
    return false;
}

Tier strongest(const Walls& walls)
{
    return is_possible(Tier::a, walls) ? Tier::a : is_possible(Tier::b, walls) ? Tier::b : Tier::c;
}

Tier usual_tier()
{
    const Tier possible = strongest(possible_walls()), tier = wanted_tier().value_or(possible);
    if (!is_possible(tier, possible_walls()))
        throw InputError(
            tier < possible ? fmt::format("RIGOR_TIER: this machine and user allow no more than {}",
                                          description(possible))
                            : "RIGOR_TIER: tier B needs Landlock, which this machine lacks");
    return tier;
}

bool has_too_weak_walls()
{
    return usual_tier() == Tier::c && !wanted_tier();
}

Walls walls_of(Tier tier)
{
    if (tier == Tier::c) return {};
    Walls walls = possible_walls();
    if (tier == Tier::b) walls.namespaces = Walls::Namespaces::none;
    // In a user namespace there is only the user who made it, so no other user can be taken.
    if (walls.namespaces == Walls::Namespaces::user) walls.another_user = false;
    return walls;
}

std::string description(Tier tier)
{
    if (tier == Tier::c) return "C: limits on resources only";
    const Walls walls = walls_of(tier);
    return fmt::format("{}{}{}seccomp, {}Landlock", tier == Tier::a ? "A: " : "B: ",
                       walls.namespaces == Walls::Namespaces::none ? "" : "namespaces, ",
                       walls.another_user ? "uid, " : "", walls.landlock ? "" : "no ");
}

unsigned unused_user()
{
    // Debian and systemd keep both ranges of user ids free. The second one is for containers that
    // have only 65536 user ids.
    constexpr unsigned first = 0x70000000, count = 1u << 24;
    constexpr unsigned first_in_container = 60706, count_in_container = 478;
    std::ifstream map("/proc/self/uid_map");
    std::uint64_t inside = 0, outside = 0, length = 0;
    bool has_large_numbers = false;
    while (map >> inside >> outside >> length)
        has_large_numbers |= inside <= first && inside + length >= std::uint64_t{first} + count;
    std::random_device random;
    if (has_large_numbers) return first + random() % count;
    return first_in_container + random() % count_in_container;
}

} // namespace rigor
