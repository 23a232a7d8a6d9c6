// SPDX-License-Identifier: MIT
// Comparisons with the reference. These tests run only where the reference is available.
#include "support/scene_run.hpp"

using namespace rigor::testing;

TEST_CASE("contact: every step of a seesaw resolved one at a time is the reference's step",
          "[A5.7][contact][hidden]")
{
    // not a stack, where points are equally deep, so that rounding would decide which comes first
    check_every_step("a5-contact/seesaw", R"({"contact": "one_at_a_time", "end": 1})");
}

TEST_CASE("contact: every step of stack is the reference's step", "[A5.7][contact][hidden]")
{
    check_every_step("a5-contact/stack", R"({"end": 1.5})");
}

TEST_CASE("contact: every step of seesaw is the reference's step", "[A5.7][contact][hidden]")
{
    check_every_step("a5-contact/seesaw");
}

TEST_CASE("contact: every step of a seesaw resolved simultaneously is the reference's step",
          "[A5.7][contact][hidden]")
{
    check_every_step("a5-contact/seesaw", R"({"contact": "simultaneous", "end": 1})");
}

TEST_CASE("contact: every step of arch is the reference's step", "[A5.7][contact][hidden]")
{
    check_every_step("a5-contact/arch", R"({"end": 0.5})");
}
