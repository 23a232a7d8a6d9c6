// SPDX-License-Identifier: MIT
// Comparisons with the reference. These tests run only where the reference is available.
#include "support/scene_run.hpp"

using namespace rigor::testing;

TEST_CASE("kinematics: every step of projectile with spin is the reference's step",
          "[A1.11][kinematics][hidden]")
{
    check_every_step("a1-kinematics/projectile_with_spin");
}

TEST_CASE("kinematics: every step of spring pendulum is the reference's step",
          "[A1.11][kinematics][hidden]")
{
    check_every_step("a1-kinematics/spring_pendulum");
}
