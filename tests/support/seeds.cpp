// SPDX-License-Identifier: MIT
#include "support/seeds.hpp"

#include "support/verdict.hpp"

namespace rigor::testing {

namespace {
unsigned first = 0;
}

void Seeds::begin_case(unsigned seed)
{
    verdict().seed = seed;
    message_.emplace(
        Catch::MessageBuilder("CAPTURE", CATCH_INTERNAL_LINEINFO, Catch::ResultWas::Info)
        << "seed := " << seed);
}

Seeds seeds(unsigned n)
{
    return {first, n};
}

unsigned first_seed()
{
    return first;
}

void set_first_seed(unsigned seed)
{
    first = seed;
}

} // namespace rigor::testing
