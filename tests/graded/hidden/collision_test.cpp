// SPDX-License-Identifier: MIT
// Comparisons with the reference. These tests run only where the reference is available.
#include "support/scene_run.hpp"

using namespace rigor::testing;

TEST_CASE("collision: every step of bouncing spheres is the reference's step",
          "[A4.13][collision][hidden]")
{
    check_every_step("a4-collision/bouncing_spheres");
}

TEST_CASE("collision: every step of rod tip is the reference's step", "[A4.13][collision][hidden]")
{
    check_every_step("a4-collision/rod_tip");
}

TEST_CASE("collision: every step of slip to roll is the reference's step",
          "[A4.13][collision][hidden]")
{
    check_every_step("a4-collision/slip_to_roll");
}

TEST_CASE("collision: every step of billiard break is the reference's step",
          "[A4.13][collision][hidden]")
{
    // by then the balls have met each other and the cushions, and they roll
    check_every_step("a4-collision/billiard_break", R"({"end": 1.2})");
}
