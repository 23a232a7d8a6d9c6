// SPDX-License-Identifier: MIT
// Comparisons with the reference. These tests run only where the reference is available.
#include "support/scene_run.hpp"

using namespace rigor::testing;

TEST_CASE("rotation: every step of spinning box is the reference's step",
          "[A3.18][rotation][hidden]")
{
    check_every_step("a3-rotation/spinning_box");
}

TEST_CASE("rotation: every step of tennis racket is the reference's step",
          "[A3.18][rotation][hidden]")
{
    check_every_step("a3-rotation/tennis_racket");
}

TEST_CASE("rotation: every step of symmetric top is the reference's step",
          "[A3.18][rotation][hidden]")
{
    check_every_step("a3-rotation/symmetric_top");
}
