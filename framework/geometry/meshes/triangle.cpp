// SPDX-License-Identifier: MIT
// Finds the point of a triangle nearest to a point, and whether a segment goes through a triangle.
// Both follow Ericson 2005, "Real-time collision detection": 5.1.5 finds the nearest point by
// Voronoi regions, and 5.3.4 tests the segment by the signs of volumes. The nearest point is sought
// on all vertices and edges first; if it is on none of them, it is on the face.
#include "geometry/meshes/triangle.hpp"

namespace rigor {

Bounds bounds_of(const TriangleMesh& mesh)
{
    Bounds bounds;
    for (const Vector3d& v : mesh.vertices)
        bounds.include({v, v});
    return bounds;
}

NearestOnTriangle nearest_on(const Triangle& triangle, const Vector3d& p)
{
    const auto& [a, b, c] = triangle;
    const Vector3d ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return {a, 0};

    const Vector3d bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return {b, 1};

    const double v_c = d1 * d4 - d3 * d2;
    if (v_c <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, 3};

    const Vector3d cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return {c, 2};

    const double v_b = d5 * d2 - d1 * d6;
    if (v_b <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, 5};

    const double v_a = d3 * d6 - d5 * d4;
    if (v_a <= 0 && d4 >= d3 && d5 >= d6)
        return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 4};

    const double sum = v_a + v_b + v_c;
    return {a + v_b / sum * ab + v_c / sum * ac, 6};
}

namespace {

// Six times the signed volume of a tetrahedron [m³]: positive if d is on the side of the triangle
// (a, b, c) to which its normal points.
double orientation(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d)
{
    return (b - a).cross(c - a).dot(d - a);
}

} // namespace

bool pierces(const Vector3d& p, const Vector3d& q, const Triangle& triangle, double tolerance)
{
    const auto& [a, b, c] = triangle;
    const double above = orientation(a, b, c, p), below = orientation(a, b, c, q);
    const bool is_across =
        (above > tolerance && below < -tolerance) || (above < -tolerance && below > tolerance);
    if (!is_across) return false;
    const double side = above > 0 ? 1 : -1;
    for (const double volume :
         {orientation(p, q, a, b), orientation(p, q, b, c), orientation(p, q, c, a)})
        if (side * volume > tolerance) return false;
    return true;
}

} // namespace rigor
