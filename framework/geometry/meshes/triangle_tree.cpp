// SPDX-License-Identifier: MIT
// Searches the triangles of a mesh by their bounding boxes. The nearest triangle is found by branch
// and bound (Ericson 2005, "Real-time collision detection", chapter 6). Of two children the nearer
// box is entered first, and a box farther away than the best triangle so far is not entered at all.
#include "geometry/meshes/triangle_tree.hpp"

#include <algorithm>

namespace rigor {

TriangleTree::TriangleTree(const TriangleMesh& mesh) : mesh_(mesh)
{
    std::vector<Bounds> boxes;
    boxes.reserve(mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
        boxes.push_back(triangle_of(mesh, t).bounds());
    tree_ = BoundingTree(boxes);
}

TriangleTree::Found TriangleTree::nearest(const Vector3d& p, int near) const
{
    Found best;
    static_cast<NearestOnTriangle&>(best) = nearest_on(triangle_of(mesh_, near), p);
    best.triangle = near;
    best.squared_distance = (best.point - p).squaredNorm();
    descend(0, p, best);
    return best;
}

void TriangleTree::descend(int index, const Vector3d& p, Found& best) const
{
    const BoundingTree::Node& node = tree_.nodes()[index];
    if (node.is_leaf()) {
        for (int i = node.first; i < node.last; ++i) {
            const int triangle = tree_.order()[i];
            const NearestOnTriangle found = nearest_on(triangle_of(mesh_, triangle), p);
            const double squared = (found.point - p).squaredNorm();
            if (squared < best.squared_distance) best = {found, triangle, squared};
        }
        return;
    }
    int near = index + 1, far = node.right;
    double to_near = squared_distance(tree_.nodes()[near].bounds, p);
    double to_far = squared_distance(tree_.nodes()[far].bounds, p);
    if (to_far < to_near) {
        std::swap(near, far);
        std::swap(to_near, to_far);
    }
    if (to_near < best.squared_distance) descend(near, p, best);
    if (to_far < best.squared_distance) descend(far, p, best);
}

// Whether the vertex or edge on which a found point lies also belongs to the given triangle.
bool TriangleTree::is_on(const Found& found, int triangle) const
{
    const auto& own = mesh_.triangles[found.triangle];
    const auto& other = mesh_.triangles[triangle];
    const auto has = [&](int vertex) {
        return std::find(other.begin(), other.end(), vertex) != other.end();
    };
    if (found.feature == 6) return false;
    if (found.feature < 3) return has(own[found.feature]);
    const int edge = found.feature - 3;
    return has(own[edge]) && has(own[(edge + 1) % 3]);
}

std::vector<TriangleTree::Found> TriangleTree::local_minima(const Vector3d& p, double within) const
{
    std::vector<Found> near, minima;
    const double squared_limit = within * within;
    tree_.walk([&](const Bounds& box) { return squared_distance(box, p) < squared_limit; },
               [&](int triangle) {
                   const NearestOnTriangle found = nearest_on(triangle_of(mesh_, triangle), p);
                   const double squared = (found.point - p).squaredNorm();
                   if (squared < squared_limit) near.push_back({found, triangle, squared});
               });
    std::sort(near.begin(), near.end(), [](const Found& a, const Found& b) {
        return std::pair(a.squared_distance, a.triangle) <
               std::pair(b.squared_distance, b.triangle);
    });
    for (std::size_t i = 0; i < near.size(); ++i) {
        const bool is_beside_a_nearer =
            std::any_of(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const Found& nearer) { return is_on(near[i], nearer.triangle); });
        if (!is_beside_a_nearer) minima.push_back(near[i]);
    }
    return minima;
}

} // namespace rigor
