// SPDX-License-Identifier: MIT
#include "grading/machine/allotment.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <cstdlib>
#include <limits>
#include <sched.h>
#include <thread>
#include <unistd.h>

namespace rigor::testing::allotment_test {

TEST_CASE("allotment: a process uses the processors that it is kept to, and as much memory",
          "[build]")
{
    const std::size_t all = allowed_processors().size();
    const std::uint64_t memory = usable_memory();
    REQUIRE(all > 0);
    CHECK(memory > 0);
    CHECK(memory <= static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
                        static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)));
    std::thread([&] { // a thread is kept to processors by itself
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(allowed_processors().back(), &one);
        REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
        CHECK(allowed_processors().size() == 1);
        CHECK(usable_processors() == 1);
        CHECK(usable_memory() <= memory);
    })
        .join();
}

TEST_CASE("allotment: a task of Slurm uses as many processors as it asked for", "[build]")
{
    setenv("SLURM_CPUS_PER_TASK", "1", 1);
    CHECK(usable_processors() == 1);
    setenv("SLURM_CPUS_PER_TASK", "100000", 1);
    CHECK(usable_processors() == allowed_processors().size());
    unsetenv("SLURM_CPUS_PER_TASK");
}

TEST_CASE("allotment: the smallest limit of the control groups around a process holds", "[build]")
{
    const TemporaryFolder folder;
    const auto limit = [&](const std::string& lines) {
        return limit_of_groups(folder.write("cgroup", lines), folder.path());
    };
    constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
    CHECK(limit("0::/a/b\n") == none);
    folder.write("a/b/memory.max", "max\n");
    CHECK(limit("0::/a/b\n") == none);
    folder.write("a/memory.max", "3000\n");
    CHECK(limit("0::/a/b\n") == 3000);
    folder.write("a/b/memory.max", "4000\n");
    CHECK(limit("0::/a/b\n") == 3000);
    CHECK(limit("0::/\n") == none);
    folder.write("memory.max", "2000\n"); // in a container, whose own group is the top
    CHECK(limit("0::/a/b\n") == 2000);
    CHECK(limit("0::/\n") == 2000);

    folder.write("memory/task/memory.limit_in_bytes", "1000\n");
    const std::string first = "9:name=systemd:/\n4:cpu,memory:/task/c\n";
    CHECK(limit(first) == 1000);
    CHECK(limit(first + "0::/\n") == 1000);
    CHECK(limit("4:cpu:/task\n") == none);
    CHECK(limit_of_groups("/nowhere", "/nowhere") == none);
}

} // namespace rigor::testing::allotment_test
