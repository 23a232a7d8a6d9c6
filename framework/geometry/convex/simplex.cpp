// SPDX-License-Identifier: MIT
// Finds the point of a simplex nearest to the origin, by the Voronoi regions of its vertices, edges
// and faces (Ericson 2005, "Real-time collision detection", 5.1). A segment is solved directly. In
// a triangle the edges are searched, and in a tetrahedron the faces, unless the nearest point is
// inside.
#include "geometry/convex/simplex.hpp"

namespace rigor {

Simplex simplex_of(const Vertex& a)
{
    Simplex s;
    s.vertices[0] = a;
    s.weights[0] = 1;
    s.count = 1;
    return s;
}

namespace {

Simplex nearest_on_segment(const Vertex& a, const Vertex& b)
{
    const Vector3d d = b.w - a.w;
    const double along = -a.w.dot(d), length2 = d.squaredNorm();
    if (along <= 0 || !(length2 > 0)) return simplex_of(a);
    if (along >= length2) return simplex_of(b);
    Simplex s = simplex_of(a);
    s.vertices[1] = b;
    s.weights[1] = along / length2;
    s.weights[0] = 1 - s.weights[1];
    s.count = 2;
    return s;
}

Simplex nearer(const Simplex& a, const Simplex& b)
{
    return b.nearest().squaredNorm() < a.nearest().squaredNorm() ? b : a;
}

Simplex nearest_on_triangle(const Vertex& a, const Vertex& b, const Vertex& c)
{
    const Vector3d n = (b.w - a.w).cross(c.w - a.w);
    const double area2 = n.squaredNorm();
    const double u = n.dot(b.w.cross(c.w)), v = n.dot(c.w.cross(a.w)), w = n.dot(a.w.cross(b.w));
    if (u > 0 && v > 0 && w > 0 && area2 > 0) {
        Simplex s;
        s.vertices = {a, b, c};
        const double sum = u + v + w;
        s.weights = {u / sum, v / sum, w / sum};
        s.count = 3;
        return s;
    }
    return nearer(nearest_on_segment(a, b),
                  nearer(nearest_on_segment(b, c), nearest_on_segment(c, a)));
}

// Whether the origin and d are on different sides of the plane through a, b, c. The result is also
// true if the origin lies in this plane, and for a flat tetrahedron, which has no inside.
bool is_beyond(const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d)
{
    const Vector3d n = (b.w - a.w).cross(c.w - a.w);
    const double origin = -n.dot(a.w), other = n.dot(d.w - a.w);
    return origin * other <= 0;
}

// Finds the face, edge or vertex nearest to the origin, among the faces of a tetrahedron that
// `counts` accepts. The result has no vertices if no face is accepted. The arguments of `counts`
// are the three vertices of a face and the fourth vertex of the tetrahedron.
template <class Counts> Simplex nearest_face(const std::array<Vertex, 4>& v, const Counts& counts)
{
    Simplex best;
    for (const auto& [i, j, k, l] : {std::array{0, 1, 2, 3}, std::array{0, 1, 3, 2},
                                     std::array{0, 2, 3, 1}, std::array{1, 2, 3, 0}}) {
        if (!counts(v[i], v[j], v[k], v[l])) continue;
        const Simplex face = nearest_on_triangle(v[i], v[j], v[k]);
        best = best.count == 0 ? face : nearer(best, face);
    }
    return best;
}

// If the result has all four vertices, the origin is inside the tetrahedron.
Simplex nearest_on_tetrahedron(const std::array<Vertex, 4>& v)
{
    Simplex best = nearest_face(v, is_beyond);
    if (best.count == 0) {
        best.vertices = v;
        best.count = 4;
    }
    return best;
}

} // namespace

Simplex nearest_of(const Simplex& s)
{
    const auto& v = s.vertices;
    if (s.count == 2) return nearest_on_segment(v[0], v[1]);
    if (s.count == 3) return nearest_on_triangle(v[0], v[1], v[2]);
    return nearest_on_tetrahedron(v);
}

Simplex nearest_face_of(const Simplex& s)
{
    const auto any = [](const Vertex&, const Vertex&, const Vertex&, const Vertex&) {
        return true;
    };
    return nearest_face(s.vertices, any);
}

} // namespace rigor
