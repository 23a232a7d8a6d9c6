// SPDX-License-Identifier: MIT
// Searches the triangles of a mesh by their bounding boxes. The nearest triangle is found by branch
// and bound (Ericson 2005, "Real-time collision detection", chapter 6). Of two children the nearer
// box is entered first, and a box farther away than the best triangle so far is not entered at all.
#include "geometry/meshes/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>

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

namespace {

// The vertices and edges of the triangles that were added.
class SeenFeatures {
public:
    // Whether the vertex or edge of a triangle (`feature` as in NearestOnTriangle) belongs to an
    // added triangle.
    bool has(const std::array<int, 3>& triangle, int feature) const
    {
        if (feature == 6) return false; // no other triangle has this face
        if (feature < 3) return vertices_.contains(triangle[feature]);
        return edges_.contains(edge(triangle, feature - 3));
    }
    void add(const std::array<int, 3>& triangle)
    {
        for (int i = 0; i < 3; ++i) {
            vertices_.insert(triangle[i]);
            edges_.insert(edge(triangle, i));
        }
    }

private:
    static std::uint64_t edge(const std::array<int, 3>& triangle, int i)
    {
        const auto [low, high] = std::minmax(triangle[i], triangle[(i + 1) % 3]);
        return static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high);
    }

    std::unordered_set<int> vertices_;
    std::unordered_set<std::uint64_t> edges_;
};

} // namespace

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
    SeenFeatures nearer;
    for (const Found& found : near) {
        const auto& triangle = mesh_.triangles[found.triangle];
        if (!nearer.has(triangle, found.feature)) minima.push_back(found);
        nearer.add(triangle);
    }
    return minima;
}

} // namespace rigor
