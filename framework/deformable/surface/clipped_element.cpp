// SPDX-License-Identifier: MIT
// Clips an element of a cracked solid to the material of one of its copies, for virtual nodes
// (Molino, Bao and Fedkiw 2004, "A virtual node algorithm for changing mesh topology during
// simulation"): a cracked element has one copy for each piece of its material. Each face is a
// convex polygon that is clipped by one crack plane after the other (Sutherland and Hodgman 1974).
// The points where a plane meets the faces are then sorted by angle and form the polygon that
// closes the cut.
#include "deformable/surface/clipped_element.hpp"

#include "geometry/tetrahedra/tetrahedra.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

using Weights = Eigen::Vector4d;

// Tolerances for barycentric weights. The weights are between 0 and 1, so the tolerances are
// relative to the size of the element. Points that differ by less than `same_point` are the same,
// an edge shorter than `least_edge` has no direction, and a piece whose area is less than
// `least_area` times that of its face is a rounding error.
constexpr double same_point = 1e-12, least_edge = 1e-9, least_area = 1e-12;

// The part of a polygon where `height` · weights ≥ 0; `height` contains the heights of the four
// corners over a plane. Points of the polygon's edges on this plane are appended to `rim`.
std::vector<Weights> clipped(const std::vector<Weights>& polygon, const Weights& height,
                             std::vector<Weights>& rim)
{
    std::vector<Weights> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Weights &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double h = height.dot(a), k = height.dot(b);
        if (h >= 0) kept.push_back(a);
        if (h == 0) rim.push_back(a);
        if ((h > 0 && k < 0) || (h < 0 && k > 0)) {
            const double t = h / (h - k);
            kept.push_back((1 - t) * a + t * b);
            rim.push_back(kept.back());
        }
    }
    if (kept.size() < 3) kept.clear();
    return kept;
}

Vector3d place(const std::array<Vector3d, 4>& corners, const Weights& w)
{
    return w[0] * corners[0] + w[1] * corners[1] + w[2] * corners[2] + w[3] * corners[3];
}

// The polygon that closes a cut: the points of `rim`, sorted by their angle about their middle,
// counter-clockwise seen from the side to which `outwards` points.
std::vector<Weights> cap(std::vector<Weights> rim, const std::array<Vector3d, 4>& corners,
                         const Vector3d& outwards)
{
    Weights middle = Weights::Zero();
    for (const Weights& w : rim)
        middle += w / static_cast<double>(rim.size());
    const Vector3d center = place(corners, middle);
    const Vector3d x = outwards.unitOrthogonal(), y = outwards.cross(x);
    const auto angle = [&](const Weights& w) {
        const Vector3d r = place(corners, w) - center;
        return std::atan2(y.dot(r), x.dot(r));
    };
    std::sort(rim.begin(), rim.end(),
              [&](const Weights& a, const Weights& b) { return angle(a) < angle(b); });
    const auto is_same = [](const Weights& a, const Weights& b) {
        return (a - b).norm() < same_point;
    };
    rim.erase(std::unique(rim.begin(), rim.end(), is_same), rim.end());
    while (rim.size() > 1 && is_same(rim.front(), rim.back()))
        rim.pop_back();
    return rim;
}

void cut(std::vector<ClippedFace>& faces, const std::array<Vector3d, 4>& corners,
         const Weights& height, const Vector3d& outwards)
{
    std::vector<Weights> rim;
    for (ClippedFace& face : faces)
        face.weights = clipped(face.weights, height, rim);
    std::erase_if(faces, [](const ClippedFace& face) { return face.weights.empty(); });
    ClippedFace closing{cap(std::move(rim), corners, outwards), -1};
    if (closing.weights.size() >= 3) faces.push_back(std::move(closing));
}

// The coefficients r of a linear function. For a point with the barycentric coordinates x, r · x is
// the signed area of the triangle a b x, divided by the area of the face.
Weights triangle_height(const Weights& a, const Weights& b, int face)
{
    const auto& [i, j, k] = tetrahedron_faces[face];
    Weights height = Weights::Zero();
    height[i] = a[j] * b[k] - a[k] * b[j];
    height[j] = a[k] * b[i] - a[i] * b[k];
    height[k] = a[i] * b[j] - a[j] * b[i];
    return height;
}

double area(const std::vector<Weights>& polygon, int face)
{
    double sum = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += triangle_height(polygon[0], polygon[i - 1], face).dot(polygon[i]);
    return std::abs(sum);
}

} // namespace

std::vector<std::vector<Weights>> uncovered(std::vector<Weights> polygon,
                                            const std::vector<Weights>& cover, int face)
{
    std::vector<std::vector<Weights>> open;
    Weights middle = Weights::Zero();
    for (const Weights& w : cover)
        middle += w / static_cast<double>(cover.size());
    std::vector<Weights> unused;
    for (std::size_t i = 0; i < cover.size(); ++i) {
        Weights inwards = triangle_height(cover[i], cover[(i + 1) % cover.size()], face);
        if (!(inwards.norm() > least_edge)) continue; // this edge is too short to have a direction
        if (inwards.dot(middle) < 0) inwards = -inwards;
        open.push_back(clipped(polygon, -inwards, unused));
        polygon = clipped(polygon, inwards, unused);
    }
    std::erase_if(open, [&](const auto& piece) { return !(area(piece, face) > least_area); });
    return open;
}

std::vector<ClippedFace> clipped_element(const Deformable& solid, int element)
{
    const int parent = solid.embedded.parents[element];
    const auto& real = solid.embedded.real[element];
    std::array<Vector3d, 4> corners;
    for (int i = 0; i < 4; ++i)
        corners[i] = solid.uncracked.vertices[solid.uncracked.tetrahedra[parent][i]];
    std::vector<ClippedFace> faces;
    for (int f = 0; f < 4; ++f) {
        ClippedFace face{{}, f};
        for (const int i : tetrahedron_faces[f])
            face.weights.push_back(Weights::Unit(i));
        faces.push_back(face);
    }
    // For each corner, whether no crack so far separates it from the first corner with material.
    std::array<bool, 4> is_together = {true, true, true, true};
    const auto first = std::find(real.begin(), real.end(), 1) - real.begin();
    for (const ElementCrack& crack : solid.cracks) {
        if (crack.tetrahedron != parent) continue;
        Weights height; // heights of the corners over the crack plane [m]
        for (int i = 0; i < 4; ++i)
            height[i] = crack.normal.dot(corners[i] - crack.point);
        const bool is_above = height[first] >= 0;
        bool separates = false;
        for (int i = 0; i < 4; ++i)
            if (is_together[i] && (height[i] >= 0) != is_above) {
                is_together[i] = false;
                separates = true;
            }
        if (!separates) continue;
        const double side = is_above ? 1 : -1;
        cut(faces, corners, side * height, -side * crack.normal);
    }
    return faces;
}

} // namespace rigor
