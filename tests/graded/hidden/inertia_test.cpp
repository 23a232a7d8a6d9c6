// SPDX-License-Identifier: MIT
// Comparisons with the reference. These tests run only where the reference is available.
#include "support/scene_run.hpp"

using namespace rigor::testing;

TEST_CASE("inertia: every step of spinning box is the reference's step", "[A2.16][inertia][hidden]")
{
    check_every_step("a2-inertia/spinning_box", other_boxes("a2-inertia/spinning_box"));
}

TEST_CASE("inertia: every step of hammer is the reference's step", "[A2.16][inertia][hidden]")
{
    check_every_step("a2-inertia/hammer", other_boxes("a2-inertia/hammer"));
}

TEST_CASE("inertia: every step of tumbling plate is the reference's step",
          "[A2.16][inertia][hidden]")
{
    check_every_step("a2-inertia/tumbling_plate", other_boxes("a2-inertia/tumbling_plate"));
}
