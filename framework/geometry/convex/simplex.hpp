// SPDX-License-Identifier: MIT
// The simplex of the GJK algorithm (Gilbert, Johnson and Keerthi 1988).
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// A point of the Minkowski difference of two shapes: w = a - b, with a on shape 1 and b on shape 2
/// [m]. If shape 1 is shifted, the shift is added to w only.
struct Vertex {
    Vector3d w = Vector3d::Zero(), a = Vector3d::Zero(), b = Vector3d::Zero();
};

/// A simplex of up to four vertices. As the result of a function below, it is the smallest part of
/// a given simplex that contains the point nearest to the origin. This point is Σ weight · w. If
/// the result has four vertices, the origin is inside the simplex, and no weights are set.
struct Simplex {
    std::array<Vertex, 4> vertices;
    std::array<double, 4> weights = {};
    int count = 0;

    /// Σ weight · p over the vertices. The member pointer `point` selects p, which is w, a or b.
    Vector3d blend(Vector3d Vertex::*point) const
    {
        Vector3d sum = Vector3d::Zero();
        for (int i = 0; i < count; ++i)
            sum += weights[i] * (vertices[i].*point);
        return sum;
    }
    Vector3d nearest() const { return blend(&Vertex::w); }
};

/// A simplex of one vertex.
Simplex simplex_of(const Vertex& vertex);

/// The part of a simplex of two to four vertices that is nearest to the origin (Ericson 2005,
/// "Real-time collision detection", 5.1). If it has all four vertices, the origin is inside.
Simplex nearest_of(const Simplex& simplex);

/// The face of a tetrahedron that is nearest to the origin, or only an edge or vertex of this face.
/// The origin may be on either side of the face. Call this function if the origin is known to be
/// outside, although rounding makes a flat tetrahedron seem to contain the origin.
Simplex nearest_face_of(const Simplex& tetrahedron);

} // namespace rigor
