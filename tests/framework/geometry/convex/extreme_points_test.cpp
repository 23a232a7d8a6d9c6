// SPDX-License-Identifier: MIT
// The corners of convex hulls in a plane, of polygons with more points inside and on their edges.
#include "geometry/convex/extreme_points.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace extreme_points_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// Corners of a regular polygon, then points between them, in an order that `random` draws.
struct Points {
    std::vector<Vector3d> points;
    std::vector<int> corners;

    Points(int n, int others, Random& random)
    {
        const Matrix3d R = random.rotation();
        const Vector3d X = 10 * random.vector();
        normal = R.col(2);
        std::vector<Vector3d> flat;
        for (int i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * i / n;
            flat.emplace_back(std::cos(angle), std::sin(angle), 0);
        }
        for (int i = 0; i < others; ++i) {
            const int a = random_index(random, flat.size() < 3 ? 2 : static_cast<std::size_t>(n));
            const double share = random.uniform(0.05, 0.95); // on an edge, or inside
            const double inwards = i % 2 == 0 ? 1 : random.uniform(0, 0.9);
            flat.push_back(inwards * ((1 - share) * flat[a] + share * flat[(a + 1) % n]));
        }
        std::vector<int> places(flat.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            places[i] = static_cast<int>(i);
        for (std::size_t i = places.size(); i > 1; --i)
            std::swap(places[i - 1], places[random_index(random, i)]);
        points.resize(flat.size());
        for (std::size_t i = 0; i < flat.size(); ++i) {
            points[places[i]] = R * flat[i] + X;
            if (i < static_cast<std::size_t>(n)) corners.push_back(places[i]);
        }
        std::sort(corners.begin(), corners.end());
    }
    Vector3d normal;
};

} // namespace

TEST_CASE("geometry: the corners of a polygon with points on its edges and inside", "[geometry]")
{
    for (Random random : seeds(100))
        for (const int n : {2, 3, 4, 5, 8, 30})
            for (const int others : {0, 1, 5, 20}) {
                CAPTURE(n, others);
                const Points made(n, others, random);
                REQUIRE(extreme_points(made.points, made.normal) == made.corners);
            }
}

TEST_CASE("geometry: points at one place have one corner", "[geometry]")
{
    const std::vector<Vector3d> same(3, Vector3d(1, 2, 3));
    REQUIRE(extreme_points(same, {0, 1, 0}) == std::vector<int>{0});
    // two at each end of a line: one corner at each end
    const std::vector<Vector3d> ends = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    REQUIRE(extreme_points(ends, {0, 1, 0}).size() == 2);
}

} // namespace extreme_points_test
