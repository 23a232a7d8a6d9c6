// SPDX-License-Identifier: MIT
// Cuts the visible part of a ground into the part inside the sun's shadow map and the rest. The
// edges of the map are projected to the ground along the light. They cut the ground into a grid of
// 3 × 3 cells in the map's coordinates. The middle cell is the part with shadows. If the map
// reaches beyond the visible part, or if the light grazes the ground, the ground is not cut.
#include "render/gl/ground_mesh.hpp"

#include <array>
#include <cmath>

namespace rigor {

GroundPieces ground_pieces(const Ground& ground, const Vector3f& origin, float half,
                           const View& view, bool shadows)
{
    // u and v are the first two coordinates of to_light; they are 0 or 1 on the edges of the shadow
    // map.
    const Eigen::Map<const Eigen::Matrix4f> to_light(view.to_light);
    const Eigen::Matrix<float, 2, 3> L = to_light.topLeftCorner<2, 3>();
    Eigen::Matrix2f M; // maps a spot on the ground to (u, v)
    M.col(0) = L * ground.axes.col(0);
    M.col(1) = L * ground.axes.col(2);
    const Spot middle = L * origin + to_light.topRightCorner<2, 1>();
    // How far the circle of radius `half` reaches in u and v.
    Spot reach(half * M.row(0).norm(), half * M.row(1).norm());

    GroundPieces pieces;
    const bool grazed = !(std::abs(M.determinant()) > 0.05F * M.squaredNorm());
    const bool inside = (middle - reach).maxCoeff() < 0 && (middle + reach).minCoeff() > 1;
    if (!shadows || grazed || !inside) {
        auto& piece = shadows ? pieces.shaded : pieces.plain;
        piece = {{-half, -half}, {-half, half}, {half, half},
                 {-half, -half}, {half, half},  {half, -half}}; // z comes before x, since z × x = y
        return pieces;
    }
    const std::array<float, 4> u = {middle.x() - reach.x(), 0, 1, middle.x() + reach.x()};
    const std::array<float, 4> v = {middle.y() - reach.y(), 0, 1, middle.y() + reach.y()};
    const Eigen::Matrix2f back = M.inverse();
    const int first = M.determinant() > 0 ? 1 : 0; // keeps triangles counter-clockwise
    for (int cell = 0; cell < 9; ++cell) {
        const int i = cell % 3, j = cell / 3;
        const auto corner = [&](int a, int b) -> Spot {
            return back * (Spot(u[i + a], v[j + b]) - middle);
        };
        const Spot a = corner(0, 0), b = corner(1 - first, first), c = corner(1, 1),
                   d = corner(first, 1 - first);
        auto& piece = cell == 4 ? pieces.shaded : pieces.plain;
        piece.insert(piece.end(), {a, b, c, a, c, d});
    }
    return pieces;
}

} // namespace rigor
