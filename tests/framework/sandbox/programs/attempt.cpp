// SPDX-License-Identifier: MIT
// Tries what its arguments name.
#include "attempts.hpp"

int main(int count, char** arguments)
{
    if (count > 1) rigor::testing::attempt(arguments[1], count > 2 ? arguments[2] : "");
}
