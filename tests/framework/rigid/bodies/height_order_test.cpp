// SPDX-License-Identifier: MIT
#include "rigid/bodies/height_order.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"

#include <cmath>
#include <vector>

using namespace rigor;
using namespace rigor::testing;

namespace {

HeightOrder order_of(const std::vector<Vector3d>& points, const Vector3d& gravity)
{
    return {gravity, points, [](const Vector3d& x) -> const Vector3d& { return x; }};
}

} // namespace

TEST_CASE("height order: lower points come first, then those with the smaller x", "[rigid]")
{
    const std::vector<Vector3d> points = {{0, 1, 0}, {-3, 2, 0}, {-2, 2, -1}, {-2, 2, 1}};
    const HeightOrder key_of = order_of(points, {0, -9.81, 0});
    for (std::size_t i = 1; i < points.size(); ++i)
        CHECK(key_of(points[i - 1]) < key_of(points[i]));
    // Upside down, the highest point comes first.
    const HeightOrder upside_down = order_of(points, {0, 9.81, 0});
    CHECK(upside_down(points[1]) < upside_down(points[0]));
}

TEST_CASE("height order: heights that differ by rounding are equal", "[rigid]")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Vector3d x = 10 * random.vector();
        const Vector3d rounded = x + 1e-15 * random.vector();
        const HeightOrder key_of = order_of({x, rounded, {16, 16, 16}}, {0, -9.81, 0});
        REQUIRE(key_of(x) == key_of(rounded));
        REQUIRE(key_of(x) < key_of(x + Vector3d(0, 1e-8, 0)));
    }
}

TEST_CASE("height order: it is the same wherever the points are", "[rigid]")
{
    const std::vector<Vector3d> corners = {
        {0, 0, 0}, {1, 1e-13, 0}, {1, 0, 1}, {0, 0.4, 1e-3}, {-1, 2e-9, 0}};
    for (unsigned seed = 0; seed < 1000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Vector3d X = std::pow(10, random.uniform(-3, 3)) * random.vector();
        std::vector<Vector3d> moved;
        for (const Vector3d& x : corners)
            moved.push_back(x + X);
        const HeightOrder here = order_of(corners, {0, -9.81, 0}),
                          there = order_of(moved, {0, -9.81, 0});
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t j = 0; j < corners.size(); ++j)
                REQUIRE((here(corners[i]) < here(corners[j])) ==
                        (there(moved[i]) < there(moved[j])));
    }
}

TEST_CASE("height order: different points have different keys in any direction of gravity",
          "[rigid]")
{
    std::vector<Vector3d> corners;
    for (double x : {0, 1})
        for (double y : {0, 1})
            for (double z : {0, 1})
                corners.emplace_back(x, y, z);
    for (const Vector3d& gravity : {Vector3d(9.81, 0, 0), Vector3d(0, -9.81, 0),
                                    Vector3d(0, 0, 9.81), Vector3d(-5, 5, 0), Vector3d(1, 2, 3)}) {
        CAPTURE(gravity.transpose());
        const HeightOrder key_of = order_of(corners, gravity);
        for (std::size_t i = 0; i < corners.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                CHECK((key_of(corners[i]) < key_of(corners[j])) !=
                      (key_of(corners[j]) < key_of(corners[i])));
    }
}
