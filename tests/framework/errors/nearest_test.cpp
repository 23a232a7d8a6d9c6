// SPDX-License-Identifier: MIT
#include "errors/nearest.hpp"
#include "support/catch.hpp"

#include <array>

using namespace rigor;

TEST_CASE("nearest: a misspelt word gets the name that needs the fewest changes", "[errors]")
{
    constexpr std::array<std::string_view, 3> names = {"friction", "restitution", "density"};
    CHECK(nearest("restituton", names) == "restitution"); // a letter is missing
    CHECK(nearest("frictoin", names) == "friction");      // two letters changed places
    CHECK(nearest("densityy", names) == "density");       // a letter too many
}

TEST_CASE("nearest: a word that is cut short gets the name that it begins", "[errors]")
{
    constexpr std::array<std::string_view, 3> names = {"youngs_modulus", "yield_stress",
                                                       "yield_strain"};
    CHECK(nearest("young", names) == "youngs_modulus");
    CHECK(nearest("yield", names).empty()); // either of two
    CHECK(nearest("yo", names).empty());    // too short
}

TEST_CASE("nearest: a word unlike every name gets none", "[errors]")
{
    constexpr std::array<std::string_view, 2> names = {"box", "ball"};
    CHECK(nearest("velocity", names).empty());
    CHECK(nearest("", names).empty());
    CHECK(nearest(std::string(100, 'b'), names).empty());
}

TEST_CASE("nearest: a suggestion is the nearest name in quotes or else what the caller says",
          "[errors]")
{
    constexpr std::array<std::string_view, 2> names = {"box", "sphere"};
    CHECK(suggestion("sphre", names, "there are two") == "; did you mean \"sphere\"?");
    CHECK(suggestion("velocity", names, "there are two") == "; there are two");
    CHECK(suggestion("velocity", names).empty());
    const std::array<std::string, 1> escaped = {"a\nball"};
    CHECK(suggestion("a ball", escaped) == "; did you mean \"a\\nball\"?");
}
