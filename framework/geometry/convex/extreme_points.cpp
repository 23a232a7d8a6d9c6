// SPDX-License-Identifier: MIT
// The convex hull of points in a plane, by the monotone chain (Andrew 1979). The points are sorted
// along the direction in which they extend farthest. Then the lower and the upper chain are built
// from the first to the last point; a point is removed from a chain if the chain does not turn
// there.
#include "geometry/convex/extreme_points.hpp"

#include <algorithm>
#include <numeric>

namespace rigor {

namespace {

// A chain turns at a point if twice the area of the triangle of this point and its neighbors,
// divided by the square of the points' extent, is above this. A smaller area is rounding.
constexpr double least_turn = 1e-9;

// The index of the point that is farthest from x, measured perpendicular to n.
std::size_t farthest_from(const Vector3d& x, std::span<const Vector3d> points, const Vector3d& n)
{
    const auto distance = [&](const Vector3d& p) { return (p - x).cross(n).squaredNorm(); };
    const auto farthest =
        std::max_element(points.begin(), points.end(), [&](const Vector3d& a, const Vector3d& b) {
            return distance(a) < distance(b);
        });
    return static_cast<std::size_t>(farthest - points.begin());
}

} // namespace

std::vector<int> extreme_points(std::span<const Vector3d> points, const Vector3d& n)
{
    const Vector3d& first = points[farthest_from(points[0], points, n)];
    const Vector3d across = points[farthest_from(first, points, n)] - first;
    const Vector3d along = across - across.dot(n) * n;
    const double extent = along.norm();
    if (!(extent > 0)) return {0};
    const Vector3d u = along / extent, w = n.cross(u);

    std::vector<Eigen::Vector2d> places;
    for (const Vector3d& p : points)
        places.emplace_back(u.dot(p - first), w.dot(p - first));
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return std::pair(places[a].x(), places[a].y()) < std::pair(places[b].x(), places[b].y());
    });

    const auto turns = [&](int a, int b, int c) {
        const Eigen::Vector2d d = places[b] - places[a], e = places[c] - places[a];
        return d.x() * e.y() - d.y() * e.x() > least_turn * extent * extent;
    };
    std::vector<int> corners;
    for (int side = 0; side < 2; ++side) { // the lower chain, then the upper one
        std::vector<int> chain;
        for (const int i : order) {
            while (chain.size() > 1 && !turns(chain[chain.size() - 2], chain.back(), i))
                chain.pop_back();
            chain.push_back(i);
        }
        corners.insert(corners.end(), chain.begin(), chain.end());
        std::reverse(order.begin(), order.end());
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

} // namespace rigor
