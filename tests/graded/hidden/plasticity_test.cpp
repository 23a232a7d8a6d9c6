// SPDX-License-Identifier: MIT
// Comparisons with the reference. These tests run only where the reference is available.
#include "support/scene_run.hpp"

using namespace rigor::testing;

// Every step solves a linear system by conjugate gradients, down to a relative residual of 1e-7.
// This and rounding bound the difference between two correct runs.
TEST_CASE("plasticity: the stretched bar moves as the reference's", "[A6.10][plasticity][hidden]")
{
    check_solids("a6-plasticity/stretched_bar", 1e7);
}

TEST_CASE("plasticity: the bar under cyclic load moves as the reference's",
          "[A6.10][plasticity][hidden]")
{
    check_solids("a6-plasticity/cyclic_load", 1e7);
}

TEST_CASE("plasticity: the twisted bar moves as the reference's", "[A6.10][plasticity][hidden]")
{
    // by then the bar is twisted by half a turn and has flowed
    check_solids("a6-plasticity/twisted_bar", 1e7, R"({"end": 1})");
}
