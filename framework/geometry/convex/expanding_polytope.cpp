// SPDX-License-Identifier: MIT
// Grows a convex polytope by one point at a time (van den Bergen 2001, "Proximity queries and
// penetration depth computation on 3D game objects"). Faces that see the new point are removed, the
// edges around the hole are found, and each is joined with the point by a new face. Last, the
// nearest face is found.
#include "geometry/convex/expanding_polytope.hpp"

#include <algorithm>
#include <utility>

namespace rigor {

namespace {

// A triangle has no normal if twice its area, divided by the square of its longest edge, is below
// this: then it is a line, except for rounding.
constexpr double flat = 1e-14;

} // namespace

ExpandingPolytope::ExpandingPolytope(const std::array<Vector3d, 4>& corners)
    : points_(corners.begin(), corners.end())
{
    const Vector3d n = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const bool is_below = n.dot(corners[3] - corners[0]) < 0; // then (0, 1, 2) faces outwards
    const std::array<int, 4> order = is_below ? std::array{0, 1, 2, 3} : std::array{0, 2, 1, 3};
    const auto [i, j, k, l] = order;
    if (!add_face(i, j, k) || !add_face(i, l, j) || !add_face(j, l, k) || !add_face(k, l, i))
        faces_.clear();
    else
        find_nearest();
}

bool ExpandingPolytope::add_face(int a, int b, int c)
{
    const Vector3d area = (points_[b] - points_[a]).cross(points_[c] - points_[a]);
    const double length = area.norm();
    const double longest =
        std::max({(points_[b] - points_[a]).squaredNorm(), (points_[c] - points_[b]).squaredNorm(),
                  (points_[a] - points_[c]).squaredNorm()});
    if (!(length > flat * longest)) return false;
    const Vector3d n = area / length;
    faces_.push_back({{a, b, c}, n, n.dot(points_[a])});
    return true;
}

void ExpandingPolytope::find_nearest()
{
    nearest_ = 0;
    for (std::size_t i = 1; i < faces_.size(); ++i)
        if (faces_[i].distance < faces_[nearest_].distance) nearest_ = i;
}

bool ExpandingPolytope::add(const Vector3d& p)
{
    // Remove the faces that see the point. An edge that belongs to only one of them is on the
    // rim of the hole.
    std::vector<std::pair<int, int>> rim;
    std::vector<Face> kept;
    for (const Face& face : faces_) {
        if (face.normal.dot(p) - face.distance <= 0) {
            kept.push_back(face);
            continue;
        }
        for (int i = 0; i < 3; ++i) {
            const std::pair edge(face.corners[i], face.corners[(i + 1) % 3]);
            const auto twin = std::find(rim.begin(), rim.end(), std::pair(edge.second, edge.first));
            if (twin != rim.end())
                rim.erase(twin);
            else
                rim.push_back(edge);
        }
    }
    if (rim.empty()) return false;
    const std::vector<Face> before = std::exchange(faces_, std::move(kept));
    points_.push_back(p);
    for (const auto& [a, b] : rim)
        if (!add_face(a, b, static_cast<int>(points_.size()) - 1)) {
            faces_ = before;
            points_.pop_back();
            return false;
        }
    find_nearest();
    return true;
}

} // namespace rigor
