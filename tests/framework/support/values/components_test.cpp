// SPDX-License-Identifier: MIT
// Tests of the numbers of a value, their names and the text.
#include "support/values/components.hpp"

#include "support/catch.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("components: a number of a nested value has its way as its name", "[support]")
{
    ContactResult result;
    result.bodies.resize(3);
    result.impulses.assign(2, Vector3d(1, 2, 3));
    const Components parts = components(result);
    CHECK(parts.shape == "3 elements 2 elements ");
    REQUIRE(parts.numbers.size() == 3 * (1 + 9 + 4 * 3) + 2 * 3);
    CHECK(component_name(result, 0) == "bodies[0].inverse_mass");
    CHECK(component_name(result, 22 + 1 + 1) == "bodies[1].inverse_inertia(1, 0)");
    CHECK(component_name(result, 22 + 10 + 2) == "bodies[1].position(2)");
    CHECK(component_name(result, 3 * 22 + 4) == "impulses[1](1)");
    CHECK(component_name(2.5, 0).empty());
    CHECK(component_name(result, parts.numbers.size()).empty()); // there is none
}

TEST_CASE("components: the scale of a number is the norm of its vector or matrix", "[support]")
{
    const std::vector<PointForce> forces = {{{3, 4, 0}, {0, 0, 0}}, {{0, 0, -2}, {1, 0, 0}}};
    const Components parts = components(forces);
    const double scales[] = {5, 5, 5, 0, 0, 0, 2, 2, 2, 1, 1, 1};
    REQUIRE(parts.numbers.size() == std::size(scales));
    for (std::size_t i = 0; i < parts.numbers.size(); ++i)
        CHECK(parts.scale(i) == scales[i]);

    const Components numbers = components(std::vector<double>{-3, 0, 7});
    CHECK(numbers.scale(0) == 3);
    CHECK(numbers.scale(2) == 7);
}

TEST_CASE("components: a text shows vectors, matrices by rows, and what is empty", "[support]")
{
    CHECK(component_text(Vector3d(1, 2, 3)) == "(1, 2, 3)");
    Matrix3d A;
    A << 1, 2, 3, 4, 5, 6, 7, 8, 9;
    CHECK(component_text(A) == "(1 2 3; 4 5 6; 7 8 9)");
    CHECK(component_text(PointForce{{1, 0, 0}, {0, 2, 0}}) == "force (1, 0, 0)  point (0, 2, 0)");
    CHECK(component_text(std::optional<int>()) == "empty");
    CHECK(component_text(std::optional<int>(4)) == "4");
    CHECK(components(std::optional<int>()).shape == "empty ");
}

TEST_CASE("components: a long list has a short text and all its numbers", "[support]")
{
    std::vector<double> list(1 << 20, 0.5);
    list.back() = 2;
    const Components parts = components(list);
    CHECK(parts.numbers.size() == list.size());
    CHECK(component_name(list, list.size() - 1) == "[1048575]");
    const std::string text = component_text(list);
    CHECK(text.size() < 700);
    CHECK(text.ends_with("…"));
}
