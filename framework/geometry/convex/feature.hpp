// SPDX-License-Identifier: MIT
#pragma once

#include "formulas/types.hpp"

#include <array>

namespace rigor {

/// A feature of a convex surface: a polygon, a segment or a point. A circle is given as eight
/// points.
struct Feature {
    /// The largest number of points; `add` ignores more. With more points, faces with many corners
    /// would be represented better, but contacts would take more time.
    static constexpr int most = 16;
    /// Cosine and sine of about 26°. A whole face counts as facing a direction if its normal is
    /// within this angle of the direction, an edge if it is perpendicular to the direction within
    /// this angle. With a larger angle, a tilted body would get the contacts of a body that lies
    /// flat. With a smaller one, a body that begins to rock would lose contacts. The value was
    /// chosen by trial.
    static constexpr double facing_cosine = 0.9, facing_sine = 0.436;
    std::array<Vector3d, most> points;
    int count = 0;

    void add(const Vector3d& p)
    {
        if (count < most) points[count++] = p;
    }
};

} // namespace rigor
