// SPDX-License-Identifier: MIT
#include "support/seeds.hpp"

#include "seeds/drawn_seed.hpp"
#include "support/verdict.hpp"

#include <utility>

namespace rigor::testing {

namespace {
unsigned first = 0;
std::string key_of_seeds;
} // namespace

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

std::uint64_t one_way(unsigned number)
{
    constexpr int rounds = 100; // 0.03 ms; a day for all first seeds
    std::string digest = std::to_string(first) + ' ' + std::to_string(number);
    for (int i = 0; i < rounds; ++i)
        digest = sha256(digest);
    return std::stoull(digest.substr(0, 16), nullptr, 16);
}

void draw_first_seed(const std::string& test)
{
    if (!key_of_seeds.empty()) first = drawn_seed(key_of_seeds, test);
}

void set_seed_key(std::string key)
{
    key_of_seeds = std::move(key);
}

} // namespace rigor::testing
