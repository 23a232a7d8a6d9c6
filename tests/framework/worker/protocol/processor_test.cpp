// SPDX-License-Identifier: MIT
#include "worker/protocol/processor.hpp"

#include "support/catch.hpp"

#include <sched.h>
#include <thread>

namespace processor_test {

using namespace rigor;

namespace {

cpu_set_t allowed_processors()
{
    cpu_set_t allowed;
    REQUIRE(sched_getaffinity(0, sizeof allowed, &allowed) == 0);
    return allowed;
}

} // namespace

TEST_CASE("processor: a thread that leaves its processor may still use all that it might before")
{
    const cpu_set_t before = allowed_processors();
    CHECK(leave_processor() == !has_one_processor());
    const cpu_set_t after = allowed_processors();
    CHECK(CPU_EQUAL(&before, &after));
}

TEST_CASE("processor: a thread with one processor stays there")
{
    std::thread([] {
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(sched_getcpu(), &one);
        REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
        CHECK(has_one_processor());
        CHECK_FALSE(leave_processor());
        const cpu_set_t after = allowed_processors();
        CHECK(CPU_EQUAL(&one, &after));
    }).join();
}

} // namespace processor_test
