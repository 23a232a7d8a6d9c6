// SPDX-License-Identifier: MIT
// A2.17: the inertia of a simpler figure, the box that bounds a body.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

namespace {

std::vector<Vector3d> corners_of(const Vector3d& center, const Vector3d& size)
{
    std::vector<Vector3d> corners;
    for (int c = 0; c < 8; ++c) {
        const Vector3d side((c & 1) ? 0.5 : -0.5, (c & 2) ? 0.5 : -0.5, (c & 4) ? 0.5 : -0.5);
        corners.push_back(center + size.cwiseProduct(side));
    }
    return corners;
}

} // namespace

TEST_CASE("inertia: bounding box of two corners by hand", "[A2.17][inertia]")
{
    const MassProperties expected = {12, Vector3d(0.5, 1, 1.5), Vector3d(13, 10, 5).asDiagonal()};
    require_mass_properties(
        bounding_box_mass_properties({Vector3d(0, 0, 0), Vector3d(1, 2, 3)}, 12), expected, 4, 16);
    INFO("far from the origin, with the corners crosswise");
    const MassProperties far = {12, Vector3d(10.5, -9, 1.5), Vector3d(13, 10, 5).asDiagonal()};
    require_mass_properties(
        bounding_box_mass_properties({Vector3d(11, -10, 3), Vector3d(10, -8, 0)}, 12), far, 15, 16);
}

TEST_CASE("inertia: a box is its own bounding box", "[A2.17][inertia]")
{
    for (Random random : seeds(100)) {
        const Vector3d size = random.vector().cwiseAbs(), center = random.vector();
        const double M = random.mass();
        const Vector3d s = size.cwiseAbs2();
        const Matrix3d I =
            (M / 12 * Vector3d(s.y() + s.z(), s.z() + s.x(), s.x() + s.y())).asDiagonal();
        require_mass_properties(bounding_box_mass_properties(corners_of(center, size), M),
                                {M, center, I}, 3, 32);
    }
}

TEST_CASE("inertia: a bounding box that is nearly flat is not flat", "[A2.17][inertia]")
{
    for (int power = 1; power <= 44; ++power)
        for (int axis = 0; axis < 3; ++axis) {
            CAPTURE(power, axis);
            const double h = std::ldexp(1, -power);
            Vector3d size = Vector3d::Ones();
            size[axis] = h;
            Matrix3d I = (1 + h * h) * Matrix3d::Identity();
            I(axis, axis) = 2;
            require_mass_properties(bounding_box_mass_properties(corners_of(size / 2, size), 12),
                                    {12, size / 2, I}, 1, 8);
        }
}

TEST_CASE("inertia: a bounding box may have its center near the origin", "[A2.17][inertia]")
{
    for (int power = 1; power <= 44; ++power)
        for (int axis = 0; axis < 3; ++axis) {
            CAPTURE(power, axis);
            Vector3d high = Vector3d::Ones(), center = Vector3d::Zero();
            high[axis] += std::ldexp(2, -power);
            center[axis] = std::ldexp(1, -power);
            const std::vector<Vector3d> vertices = {high, Vector3d::Constant(-1)};
            REQUIRE_THAT(bounding_box_mass_properties(vertices, 12).center_of_mass,
                         IsClose(center, Rounding(4, 1)));
        }
}

TEST_CASE("inertia: a bounding box of any size on one side of the origin", "[A2.17][inertia]")
{
    for (int power = -60; power <= 60; power += 10)
        for (const double side : {-1., 1.}) {
            const double length = side * std::pow(10., power);
            CAPTURE(length);
            const Vector3d near = length * Vector3d(1, 2, 3), far = length * Vector3d(2, 4, 6);
            const MassProperties box = bounding_box_mass_properties({near, far}, 12);
            REQUIRE_THAT(box.center_of_mass, IsClose(Vector3d(1.5 * near), Rounding(8)));
            const Vector3d moments = length * length * Vector3d(13, 10, 5);
            REQUIRE_THAT(box.inertia, IsClose(Matrix3d(moments.asDiagonal()), Rounding(32)));
        }
}

TEST_CASE("inertia: only the bounds of the vertices matter", "[A2.17][inertia]")
{
    for (Random random : seeds(100)) {
        std::vector<Vector3d> vertices = corners_of(random.vector(), Vector3d(1, 2, 3));
        const MassProperties expected = bounding_box_mass_properties(vertices, 2);
        const Vector3d low = vertices.front(), high = vertices.back();
        for (int i = 0; i < 20; ++i) {
            const Vector3d share = (random.vector() + Vector3d::Ones()) / 2;
            vertices.insert(vertices.begin() + i % 3, low + share.cwiseProduct(high - low));
        }
        std::reverse(vertices.begin(), vertices.end());
        require_mass_properties(bounding_box_mass_properties(vertices, 2), expected, 4, 16);
    }
}

// The outermost vertex of each side is listed before or after one that is only a little nearer.
TEST_CASE("inertia: the outermost vertex bounds the box by however little", "[A2.17][inertia]")
{
    for (int power = 1; power <= 50; ++power)
        for (int side = 0; side < 6; ++side)
            for (const bool is_first : {true, false}) {
                CAPTURE(power, side, is_first);
                const double outward = side < 3 ? 1 : -1;
                std::vector<Vector3d> vertices = corners_of({0, 0, 0}, {2, 2, 2});
                Vector3d outermost = Vector3d::Zero();
                outermost[side % 3] = outward * (1 + std::ldexp(1, -power));
                vertices.insert(is_first ? vertices.begin() : vertices.end(), outermost);
                Vector3d center = Vector3d::Zero();
                center[side % 3] = outward * std::ldexp(1, -power - 1);
                REQUIRE_THAT(bounding_box_mass_properties(vertices, 12).center_of_mass,
                             IsClose(center, Rounding(4, 1)));
            }
}

TEST_CASE("inertia: a bounding box may be flat or a point", "[A2.17][inertia]")
{
    const MassProperties plate = {12, Vector3d(0.5, 0, 1.5), Vector3d(9, 10, 1).asDiagonal()};
    require_mass_properties(
        bounding_box_mass_properties({Vector3d(0, 0, 0), Vector3d(1, 0, 3)}, 12), plate, 4, 16);
    const MassProperties point = {3, Vector3d(1, 2, 3), Matrix3d::Zero()};
    for (const std::size_t vertices : {1, 2, 3, 50}) {
        CAPTURE(vertices);
        require_mass_properties(
            bounding_box_mass_properties(std::vector<Vector3d>(vertices, {1, 2, 3}), 3), point, 4,
            1);
    }
}

TEST_CASE("inertia: a bounding box of any size has the mass it is given", "[A2.17][inertia]")
{
    for (int power = -450; power <= 450; power += 10) { // edges, whose volume may be no double
        CAPTURE(power);
        const Vector3d size = std::ldexp(1, power) * Vector3d(1, 2, 4);
        const MassProperties found = bounding_box_mass_properties({Vector3d(0, 0, 0), size}, 12);
        REQUIRE_THAT(found.mass, IsClose(12.0, Rounding(4)));
        REQUIRE_THAT(found.inertia(0, 0), IsClose(std::ldexp(20, 2 * power), Rounding(16)));
        REQUIRE_THAT(found.inertia(2, 2), IsClose(std::ldexp(5, 2 * power), Rounding(16)));
    }
}

TEST_CASE("inertia: no vertex or no mass has no bounding box", "[A2.17][inertia]")
{
    REQUIRE_THAT(bounding_box_mass_properties({}, 3), IsExactly(MassProperties{}));
    REQUIRE_THAT(bounding_box_mass_properties({Vector3d(0, 0, 0), Vector3d(1, 2, 3)}, 0),
                 IsExactly(MassProperties{}));
}

TEST_CASE("inertia: a vertex that comes again changes no bounding box", "[A2.17][inertia]")
{
    for (Random random : seeds(10)) {
        std::vector<Vector3d> vertices;
        for (int i = 0; i < 7; ++i)
            vertices.push_back(random.vector());
        const MassProperties expected = bounding_box_mass_properties(vertices, 2);
        for (std::size_t which = 0; which < 7; ++which)
            for (std::ptrdiff_t place = 0; place <= 7; ++place) {
                CAPTURE(which, place);
                std::vector<Vector3d> more = vertices;
                more.insert(more.begin() + place, vertices[which]);
                REQUIRE_THAT(bounding_box_mass_properties(more, 2),
                             IsClose(expected, Rounding(8, 2)));
            }
    }
}
