// SPDX-License-Identifier: MIT
#include "grading/machine/allotment.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sched.h>
#include <string>
#include <thread>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

// The smallest limit in the files of this name in a group and in those around it.
std::uint64_t smallest_limit(fs::path folder, const fs::path& group, const char* file)
{
    std::uint64_t smallest = no_limit;
    const auto look = [&] {
        std::uint64_t limit = no_limit;
        std::ifstream in(folder / file);
        if (in >> limit) smallest = std::min(smallest, limit); // not if the word `max` stands there
    };
    look();
    for (const fs::path& part : group.relative_path()) {
        folder /= part;
        look();
    }
    return smallest;
}

} // namespace

std::vector<int> allowed_processors()
{
    cpu_set_t allowed[16]; // for more processors than any machine has
    if (sched_getaffinity(0, sizeof allowed, allowed) != 0) return {};
    std::vector<int> numbers;
    for (int number = 0; number < 16 * CPU_SETSIZE; ++number)
        if (CPU_ISSET_S(number, sizeof allowed, allowed)) numbers.push_back(number);
    return numbers;
}

unsigned usable_processors()
{
    std::size_t count = allowed_processors().size();
    if (count == 0) count = std::thread::hardware_concurrency();
    if (const char* words = std::getenv("SLURM_CPUS_PER_TASK"))
        if (const unsigned long given = std::strtoul(words, nullptr, 10); given > 0)
            count = std::min<std::size_t>(count, given);
    return static_cast<unsigned>(std::max<std::size_t>(count, 1));
}

std::uint64_t usable_memory()
{
    const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE),
               processors = sysconf(_SC_NPROCESSORS_ONLN);
    const std::uint64_t limit = limit_of_groups("/proc/self/cgroup", "/sys/fs/cgroup");
    if (pages <= 0 || size <= 0 || processors <= 0) return limit == no_limit ? 0 : limit;
    const double all = static_cast<double>(pages) * static_cast<double>(size),
                 part = std::min(1.0, usable_processors() / static_cast<double>(processors));
    return std::min(limit, static_cast<std::uint64_t>(all * part));
}

std::uint64_t limit_of_groups(const fs::path& process, const fs::path& groups)
{
    std::uint64_t smallest = no_limit;
    std::ifstream lines(process);
    // A line is "number:controllers:group". Version 2 has one group, without controllers.
    for (std::string line; std::getline(lines, line);) {
        const std::size_t first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) continue;
        const std::string kinds = ',' + line.substr(first + 1, second - first - 1) + ',';
        const fs::path group = line.substr(second + 1);
        if (kinds == ",,")
            smallest = std::min(smallest, smallest_limit(groups, group, "memory.max"));
        if (kinds.find(",memory,") != std::string::npos)
            smallest = std::min(smallest,
                                smallest_limit(groups / "memory", group, "memory.limit_in_bytes"));
    }
    return smallest;
}

} // namespace rigor
