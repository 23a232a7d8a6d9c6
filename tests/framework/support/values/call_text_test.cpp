// SPDX-License-Identifier: MIT
// Tests of how a call is written as C++.
#include "support/catch.hpp"
#include "support/values/call_text.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("call: it can be pasted", "[support]")
{
    Matrix3d A;
    A << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    CHECK(call_text("world_point", std::tuple(A, Vector3d(0.1, 1e-300, -2))) ==
          "world_point(Matrix3d{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {0.1, 1e-300, -2})");
    const std::vector<Particle> particles = {{1, {0, 0, 0}}, {0.5, {1, 2, 3}}};
    CHECK(call_text("generalized_mass", std::tuple(particles)) ==
          "generalized_mass({{1, {0, 0, 0}}, {0.5, {1, 2, 3}}})");
    const std::vector<std::vector<int>> rests_on = {{}, {0}};
    CHECK(call_text("contact_levels", std::tuple(rests_on, std::vector<bool>{true, false})) ==
          "contact_levels({{}, {0}}, {true, false})");
}
