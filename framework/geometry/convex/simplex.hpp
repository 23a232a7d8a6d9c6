// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

namespace rigor {

/// A point of the difference of two shapes, w = a - b.
struct Vertex {
    Vector3d w = Vector3d::Zero(), a = Vector3d::Zero(), b = Vector3d::Zero();
};

/// The smallest set of vertices whose hull holds the point v of a simplex that is nearest to the
/// origin, v = Σ weights w.
struct Simplex {
    std::array<Vertex, 4> vertices;
    std::array<double, 4> weights = {};
    int count = 0;

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

/// What of a simplex of two to four vertices is nearest to the origin (Ericson 2005, "Real-time collision
/// detection", 5.1). All four vertices: the origin is inside.
Simplex nearest_of(const Simplex& simplex);

} // namespace rigor
