// SPDX-License-Identifier: MIT
#include "support/random.hpp"
#include "support/seeds.hpp"
#include "support/verdict.hpp"

#include <vector>

namespace rigor::testing {

namespace {

// Sets another first seed for one test case and restores that of the run.
class FirstSeed {
public:
    explicit FirstSeed(unsigned seed) : of_run_(first_seed()) { set_first_seed(seed); }
    ~FirstSeed() { set_first_seed(of_run_); }
    FirstSeed(const FirstSeed&) = delete;

private:
    unsigned of_run_;
};

} // namespace

TEST_CASE("seeds: they follow the first in a row and the verdict knows the running one",
          "[support]")
{
    const FirstSeed first(40);
    std::vector<unsigned> found;
    for (unsigned seed : seeds(3)) {
        REQUIRE(verdict().seed == seed);
        found.push_back(seed);
    }
    REQUIRE(found == std::vector<unsigned>{40, 41, 42});
    for (unsigned seed : seeds(0))
        FAIL(seed);
}

TEST_CASE("seeds: a random case is that of its seed", "[support]")
{
    unsigned seed = first_seed();
    for (Random random : seeds(3))
        REQUIRE(random.bits() == Random(seed++).bits());
}

} // namespace rigor::testing
