// SPDX-License-Identifier: MIT
#include "support/verdict.hpp"

namespace rigor::testing {

Verdict& verdict()
{
    static Verdict current;
    return current;
}

} // namespace rigor::testing
