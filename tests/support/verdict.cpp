// SPDX-License-Identifier: MIT
#include "support/verdict.hpp"

#include <numeric>

namespace rigor::testing {

namespace {
unsigned base_seed = 0;
}

Verdict& verdict()
{
    static Verdict current;
    return current;
}

void current_seed(unsigned seed)
{
    verdict().seed = seed;
}

std::vector<unsigned> seeds(unsigned n)
{
    std::vector<unsigned> result(n);
    std::iota(result.begin(), result.end(), base_seed);
    return result;
}

void set_base_seed(unsigned seed)
{
    base_seed = seed;
}

} // namespace rigor::testing
