// SPDX-License-Identifier: MIT
// A2: inputs that a special case easily swallows: parts at one place, bodies without mass or with a
// negative one, as holes have, flat and straight vertices, moments and axes in every order.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <array>

namespace inertia_special_inputs_test {

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("inertia: the axes of a diagonal tensor are a rotation in any order", "[A2.4][inertia]")
{
    for (const Vector3d& moments : {Vector3d(1, 2, 3), Vector3d(1, 1, 2), Vector3d(1, 2, 2)}) {
        std::array<int, 3> order = {0, 1, 2};
        do {
            for (int coupled = -1; coupled < 3; ++coupled) { // which product of inertia is not 0
                Matrix3d I =
                    Vector3d(moments[order[0]], moments[order[1]], moments[order[2]]).asDiagonal();
                if (coupled >= 0) {
                    const int i = (coupled + 1) % 3, j = (coupled + 2) % 3;
                    I(i, j) = I(j, i) = 0.25;
                }
                CAPTURE(I);
                const PrincipalAxes axes = principal_axes(I);
                REQUIRE_THAT(axes.rotation, IsRotation());
                REQUIRE_THAT(
                    Matrix3d(axes.rotation * axes.moments.asDiagonal() * axes.rotation.transpose()),
                    IsClose(I, Rounding(64, I.norm())));
            }
        } while (std::next_permutation(order.begin(), order.end()));
    }
}

TEST_CASE("inertia: equal moments and two moments of zero", "[A2.5][inertia]")
{
    REQUIRE_THAT(invert_moments({2, 2, 2}), IsClose(Vector3d(0.5, 0.5, 0.5), Rounding(4)));
    for (int i = 0; i < 3; ++i) {
        const Vector3d axis = Vector3d::Unit(i);
        REQUIRE_THAT(invert_moments(4 * axis), IsClose(Vector3d(axis / 4), Rounding(4)));
    }
}

TEST_CASE("inertia: particles at one place add up", "[A2.1][inertia]")
{
    const std::vector<Particle> particles = {
        {1, {0, 0, 0}}, {1, {1, 0, 0}}, {2, {1, 0, 0}}, {2, {1, 0, 0}}};
    const MassProperties all = particle_mass_properties(particles);
    REQUIRE_THAT(all.mass, IsClose(6.0, Rounding(8)));
    REQUIRE_THAT(all.center_of_mass, IsClose(Vector3d(5.0 / 6, 0, 0), Rounding(8)));
    REQUIRE_THAT(all.inertia,
                 IsClose(Matrix3d(Vector3d(0, 5.0 / 6, 5.0 / 6).asDiagonal()), Rounding(16, 1)));
}

TEST_CASE("inertia: cells at one place add up", "[A2.11][inertia]")
{
    const MassProperties all =
        grid_mass_properties({{{0, 0, 0}, 1}, {{0, 0, 0}, 1}, {{0, 0, 0}, 2}}, 1);
    REQUIRE_THAT(all.mass, IsClose(4.0, Rounding(8)));
}

TEST_CASE("inertia: samples at one place count one by one", "[A2.12][inertia]")
{
    const MassProperties all =
        sampled_mass_properties({{{1, 0, 0}, 1}, {{1, 0, 0}, 2}, {{1, 0, 0}, 2}}, 3);
    REQUIRE_THAT(all.mass, IsClose(5.0, Rounding(8)));
}

namespace {

TriangleMesh tetrahedron(const Vector3d& at)
{
    TriangleMesh mesh;
    mesh.vertices = {at, at + Vector3d::UnitX(), at + Vector3d::UnitY(), at + Vector3d::UnitZ()};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return mesh;
}

TriangleMesh inside_out(TriangleMesh mesh)
{
    for (std::array<int, 3>& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    return mesh;
}

} // namespace

TEST_CASE("inertia: a tetrahedron inside out, near and far", "[A2.13][inertia]")
{
    for (const double far : {0.0, 1.0, 100.0}) {
        CAPTURE(far);
        const TriangleMesh mesh = tetrahedron({far, -far, 2 * far});
        const MassProperties right = mesh_mass_properties(mesh, 6),
                             out = mesh_mass_properties(inside_out(mesh), 6);
        const double scale = 1 + far * far * far; // the size of tetrahedra with the origin
        REQUIRE_THAT(right.mass, IsClose(1.0, Rounding(64, scale)));
        REQUIRE_THAT(out.mass, IsClose(-1.0, Rounding(64, scale)));
        REQUIRE_THAT(out.center_of_mass,
                     IsClose(right.center_of_mass, Rounding(256, scale * (1 + far))));
        REQUIRE_THAT(out.inertia, IsClose(Matrix3d(-right.inertia), Rounding(64, scale * scale)));
    }
}

TEST_CASE("inertia: vertices that no triangle uses do not matter", "[A2.13][inertia]")
{
    TriangleMesh mesh = tetrahedron({1, 2, 3});
    mesh.vertices.insert(mesh.vertices.begin(), Vector3d(10, -20, 30));
    for (std::array<int, 3>& triangle : mesh.triangles)
        for (int& vertex : triangle)
            ++vertex;
    const MassProperties solid = mesh_mass_properties(mesh, 6);
    REQUIRE_THAT(solid.mass, IsClose(1.0, Rounding(64, 100)));
    REQUIRE_THAT(solid.center_of_mass, IsClose(Vector3d(1.25, 2.25, 3.25), Rounding(64, 1000)));
}

TEST_CASE("inertia: a body combined with its like, with nothing, and with a hole",
          "[A2.14][inertia]")
{
    for (Random random : seeds(20)) {
        const MassProperties a = {random.mass(), random.vector(), random.inertia()};
        const MassProperties twice = combine(a, a);
        REQUIRE_THAT(twice.mass, IsClose(2 * a.mass, Rounding(4)));
        REQUIRE_THAT(twice.center_of_mass, IsClose(a.center_of_mass, Rounding(16, 1)));
        REQUIRE_THAT(twice.inertia,
                     IsClose(Matrix3d(2 * a.inertia), Rounding(32, 1 + a.inertia.norm() + a.mass)));

        // without mass nothing else of a body counts
        const MassProperties nothing = {0, random.vector(), random.inertia()};
        for (const MassProperties& same : {combine(a, nothing), combine(nothing, a)}) {
            REQUIRE_THAT(same.mass, IsClose(a.mass, Rounding(4)));
            REQUIRE_THAT(same.center_of_mass, IsClose(a.center_of_mass, Rounding(8, 1)));
            REQUIRE_THAT(same.inertia, IsClose(a.inertia, Rounding(16, a.inertia.norm())));
        }

        // a hole is a body of negative mass, as A2.13 makes it of a mesh inside out
        const MassProperties part = {a.mass / 4, random.vector(), random.inertia()},
                             hole = {-part.mass, part.center_of_mass, -part.inertia};
        for (const MassProperties& rest :
             {combine(combine(a, part), hole), combine(hole, combine(a, part))}) {
            REQUIRE_THAT(rest.mass, IsClose(a.mass, Rounding(8)));
            REQUIRE_THAT(rest.center_of_mass, IsClose(a.center_of_mass, Rounding(32, 2)));
            const double scale = a.inertia.norm() + part.inertia.norm() + 8 * a.mass;
            REQUIRE_THAT(rest.inertia, IsClose(a.inertia, Rounding(64, scale)));
        }
    }
}

namespace {

// Lists of up to four parts, any of which may be empty. The result for the whole list has to be
// that for the other parts, and exactly zero if all are empty.
template <class Part, class ValueOf>
void check_empty_parts(const std::vector<Part>& parts, Part empty, ValueOf value_of)
{
    for (std::size_t count = 1; count <= parts.size(); ++count)
        for (std::uint64_t which = 0; which < 1u << count; ++which) {
            std::vector<Part> all, full;
            for (std::size_t i = 0; i < count; ++i) {
                const bool is_full = which >> i & 1;
                all.push_back(is_full ? parts[i] : empty);
                if (is_full) full.push_back(parts[i]);
            }
            CAPTURE(count, which);
            if (full.empty())
                REQUIRE_THAT(value_of(all), IsExactly(MassProperties{}));
            else
                require_mass_properties(value_of(all), value_of(full), 8, 32);
        }
}

} // namespace

TEST_CASE("inertia: particles without mass change nothing, wherever they are listed",
          "[A2.1][inertia]")
{
    check_empty_parts<Particle>({{1, {-1, 0, 0}}, {1, {1, 0, 0}}, {2, {0, 2, 1}}, {1, {3, 0, 1}}},
                                {0, {5, 5, 5}}, particle_mass_properties);
}

TEST_CASE("inertia: cells without density change nothing, wherever they are listed",
          "[A2.11][inertia]")
{
    check_empty_parts<DensitySample>(
        {{{-1, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0, 2, 1}, 2}, {{3, 0, 1}, 1}}, {{5, 5, 5}, 0},
        [](const std::vector<DensitySample>& cells) { return grid_mass_properties(cells, 0.5); });
}

TEST_CASE("inertia: bodies without mass change nothing, wherever they are listed",
          "[A2.14][inertia]")
{
    const Matrix3d I = Vector3d(1, 2, 2).asDiagonal();
    check_empty_parts<MassProperties>(
        {{1, {-1, 0, 0}, I}, {1, {1, 0, 0}, 2 * I}, {2, {0, 2, 1}, I}, {1, {3, 0, 1}, I}},
        {0, {5, 5, 5}, Matrix3d::Zero()}, [](const std::vector<MassProperties>& bodies) {
            MassProperties all;
            for (const MassProperties& body : bodies)
                all = combine(all, body);
            return all;
        });
}

namespace {

// Equal moments of inertia with a product are not those of a ball: a quarter turn about z changes
// the sign of Ixy.
void check_turned_product(Matrix3d in_world(const Matrix3d& R, const Matrix3d& I))
{
    Matrix3d I, turned, R;
    I << 2, -1, 0, -1, 2, 0, 0, 0, 2;
    turned << 2, 1, 0, 1, 2, 0, 0, 0, 2;
    R << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    REQUIRE_THAT(in_world(R, I), IsClose(turned, Rounding(16, 4)));
}

} // namespace

TEST_CASE("inertia: a product turns although the moments are equal", "[A2.2][inertia]")
{
    check_turned_product(world_inertia);
}

TEST_CASE("inertia: a product of the inverse turns although its moments are equal",
          "[A2.3][inertia]")
{
    check_turned_product(world_inverse_inertia);
}

TEST_CASE("inertia: vertices on a line, on a plane, and very many", "[A2.17][inertia]")
{
    for (int along = 0; along < 3; ++along)
        for (int flat = 0; flat < 3; ++flat) { // a line if both are the same
            Vector3d size(0, 0, 0);
            if (along == flat)
                size[along] = 2;
            else
                size = Vector3d(2, 3, 4) - Vector3d(2, 3, 4)[flat] * Vector3d::Unit(flat);
            CAPTURE(size);
            const MassProperties box =
                bounding_box_mass_properties({Vector3d(1, 2, 3), Vector3d(1, 2, 3) + size}, 12);
            const Vector3d squared = size.cwiseAbs2();
            const Vector3d moments(squared.y() + squared.z(), squared.z() + squared.x(),
                                   squared.x() + squared.y());
            REQUIRE_THAT(box.mass, IsClose(12.0, Rounding(4)));
            REQUIRE_THAT(box.inertia, IsClose(Matrix3d(moments.asDiagonal()), Rounding(16)));
        }
    std::vector<Vector3d> vertices(5000, Vector3d(0.5, 0.5, 0.5));
    vertices.front().setZero();
    vertices.back() = {1, 2, 3};
    REQUIRE_THAT(bounding_box_mass_properties(vertices, 12).inertia,
                 IsClose(Matrix3d(Vector3d(13, 10, 5).asDiagonal()), Rounding(16)));
}

TEST_CASE("inertia: a solid without density has its center at the origin", "[A2.13][inertia]")
{
    TriangleMesh mesh;
    mesh.vertices = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}};
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    REQUIRE_THAT(mesh_mass_properties(mesh, 6).mass, IsClose(1.0, Rounding(64)));
    const MassProperties none = mesh_mass_properties(mesh, 0);
    REQUIRE_THAT(none.mass, IsExactly(0.0));
    REQUIRE_THAT(none.center_of_mass, IsExactly(Vector3d(0, 0, 0)));
    REQUIRE_THAT(none.inertia, IsExactly(Matrix3d(Matrix3d::Zero())));
}

} // namespace inertia_special_inputs_test
