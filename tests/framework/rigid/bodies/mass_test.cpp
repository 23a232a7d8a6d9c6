// SPDX-License-Identifier: MIT
#include "framework/rigid/worlds.hpp"
#include "geometry/meshes/generators.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/non_finite.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

Part part_of(const Shape& shape, const Vector3d& X, double density, const Quaternion& q = {})
{
    Part part;
    part.shape = shape;
    part.position = X;
    part.orientation = q;
    part.density = density;
    return part;
}

} // namespace

TEST_CASE("mass: a box has its textbook moments", "[rigid]")
{
    const RigidBody box = body_of(Box{{1, 2, 3}}, {0, 0, 0});
    CHECK_THAT(box.mass, IsClose(6000.0, Rounding(8)));
    CHECK_THAT(box.inertia,
               IsClose(Matrix3d(Vector3d(6500, 5000, 2500).asDiagonal()), Rounding(8)));
    CHECK_FALSE(box.is_isotropic);
    CHECK_THAT(Matrix3d(box.inverse.inverse_inertia * box.inertia),
               IsClose(Matrix3d(Matrix3d::Identity()), Rounding(16)));
}

TEST_CASE("mass: spheres and cubes are isotropic however they are turned", "[rigid]")
{
    for (unsigned seed = 0; seed < 100; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const double a = random.uniform(0.01, 10);
        RigidBody body;
        body.parts = {
            part_of(Box{Vector3d::Constant(a)}, random.vector(), 700, random.quaternion())};
        set_mass_from_parts(body);
        REQUIRE(body.is_isotropic);
        REQUIRE(body_of(Sphere{a}, {0, 0, 0}).is_isotropic);
        REQUIRE_FALSE(body_of(Box{{a, a, a * (1 + 1e-9)}}, {0, 0, 0}).is_isotropic);
    }
}

TEST_CASE("mass: object space has its origin at the center of mass", "[rigid]")
{
    RigidBody dumbbell; // two balls, one three times as heavy as the other
    dumbbell.parts = {part_of(Sphere{0.1}, {1, 2, 0}, 1000), part_of(Sphere{0.1}, {5, 2, 0}, 3000)};
    const Vector3d center = set_mass_from_parts(dumbbell);

    const double m = 4000.0 / 3 * std::numbers::pi * 1e-3;
    CHECK_THAT(center, IsClose(Vector3d(4, 2, 0), Rounding(8)));
    CHECK_THAT(dumbbell.parts[0].position, IsClose(Vector3d(-3, 0, 0), Rounding(8, 5)));
    CHECK_THAT(dumbbell.parts[1].position, IsClose(Vector3d(1, 0, 0), Rounding(8, 5)));
    CHECK_THAT(dumbbell.mass, IsClose(4 * m, Rounding(8)));
    const double own = 0.4 * 4 * m * 0.01, apart = m * 9 + 3 * m;
    CHECK_THAT(
        dumbbell.inertia,
        IsClose(Matrix3d(Vector3d(own, own + apart, own + apart).asDiagonal()), Rounding(32)));
}

TEST_CASE("mass: eight boxes make the box they fill however they are turned", "[rigid]")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Quaternion q = random.quaternion();
        const Matrix3d R = rotation_matrix(q);
        const Vector3d size(1, 2, 3);
        RigidBody body;
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
            body.parts.push_back(part_of(Box{size / 2}, R * sign.cwiseProduct(size) / 4, 1000, q));
        }
        const Vector3d center = set_mass_from_parts(body);
        const Matrix3d whole = Vector3d(6500, 5000, 2500).asDiagonal();
        REQUIRE_THAT(center, IsClose(Vector3d(0, 0, 0), Rounding(16, 3)));
        REQUIRE_THAT(body.inertia, IsClose(Matrix3d(R * whole * R.transpose()), Rounding(64)));
    }
}

TEST_CASE("mass: round shapes have their textbook moments", "[rigid]")
{
    const double pi = std::numbers::pi, rho = 1000;
    const auto has = [](const Shape& shape, double mass, const Vector3d& moments) {
        const RigidBody body = body_of(shape, {0, 0, 0});
        CHECK_THAT(body.mass, IsClose(mass, Rounding(16)));
        CHECK_THAT(body.inertia, IsClose(Matrix3d(moments.asDiagonal()), Rounding(64)));
        CHECK_THAT(body.parts[0].position, IsClose(Vector3d(0, 0, 0), Rounding(16, 1)));
        CHECK_THAT(volume(shape), IsClose(mass / 1000, Rounding(16)));
    };
    const double cylinder = rho * pi * 0.25 * 2;
    has(Cylinder{0.5, 2}, cylinder, cylinder * Vector3d(0.75 + 4, 1.5, 0.75 + 4) / 12);
    const double cone = rho * pi / 3 * 0.25 * 2;
    has(Cone{0.5, 2}, cone, cone * 3 / 80 * Vector3d(1 + 4, 2, 1 + 4));
    const double ellipsoid = rho * 4 / 3 * pi * 6;
    has(Ellipsoid{{1, 2, 3}}, ellipsoid, ellipsoid / 5 * Vector3d(13, 10, 5));
    const double torus = rho * 9.86960440108936; // R = 2, a = 0.5: I/M = 4.1875 and 2.15625
    has(Torus{2, 0.5}, torus, torus * Vector3d(2.15625, 4.1875, 2.15625));
    // A cylinder, and the two halves of a ball at its ends. The center of each half is 3/8 r from
    // its flat side.
    const double ball = rho * 4 / 3 * pi * 0.125, r = 0.5, h = 2;
    const double across =
        cylinder * (0.75 + 4) / 12 + ball * (0.4 * r * r + h * h / 4 + 0.375 * r * h);
    has(Capsule{r, h}, cylinder + ball, {across, cylinder * 1.5 / 12 + ball * 0.4 * r * r, across});
}

TEST_CASE("mass: a fine mesh weighs as much as the shape that it stands for", "[rigid]")
{
    std::vector<double> volumes, moments, moments_across;
    for (const int n : {12, 24, 48, 96}) {
        const RigidBody body =
            body_of(Mesh{std::make_shared<SolidMesh>(torus_mesh(2, 0.5, 2 * n, n))}, {0, 0, 0});
        volumes.push_back(std::abs(body.mass / 1000 - 9.86960440108936));
        moments.push_back(std::abs(body.inertia(1, 1) / body.mass - 4.1875));
        moments_across.push_back(std::abs(body.inertia(0, 0) / body.mass - 2.15625));
    }
    check_order(volumes, 2);
    check_order(moments, 2);
    check_order(moments_across, 2);
}

TEST_CASE("mass: a mesh is moved to its center of mass as every part is", "[rigid]")
{
    for (unsigned seed = 0; seed < 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Vector3d size = Vector3d(1, 2, 3), shift = random.vector();
        TriangleMesh box = box_mesh(size);
        for (Vector3d& v : box.vertices)
            v += shift;
        const Quaternion q = random.quaternion();
        const Matrix3d R = rotation_matrix(q);
        RigidBody body;
        body.parts = {part_of(Mesh{std::make_shared<SolidMesh>(box)}, {5, 6, 7}, 1000, q)};
        const Vector3d center = set_mass_from_parts(body);
        REQUIRE_THAT(center, IsClose(Vector3d(R * shift + Vector3d(5, 6, 7)), Rounding(16)));
        REQUIRE_THAT(body.parts[0].position, IsClose(Vector3d(-R * shift), Rounding(32, 10)));
        const Matrix3d whole = Vector3d(6500, 5000, 2500).asDiagonal();
        REQUIRE_THAT(body.inertia, IsClose(Matrix3d(R * whole * R.transpose()), Rounding(256)));
    }
}

TEST_CASE("mass: a rod cannot turn about its own axis and a point about none", "[rigid]")
{
    RigidBody rod, point;
    set_mass(rod, 2, Vector3d(3, 0, 3).asDiagonal().toDenseMatrix());
    set_mass(point, 2, Matrix3d::Zero());
    CHECK_THAT(rod.inverse.inverse_inertia,
               IsClose(Matrix3d(Vector3d(1. / 3, 0, 1. / 3).asDiagonal()), Rounding(8)));
    CHECK_THAT(point.inverse.inverse_inertia, IsExactly(Matrix3d(Matrix3d::Zero())));
    CHECK_THAT(point.inverse.inverse_mass, IsExactly(0.5));
}

TEST_CASE("mass: a static body has none", "[rigid]")
{
    const RigidBody ground = fixed(Box{{1, 1, 1}}, {});
    CHECK(ground.mass == 0);
    CHECK(ground.inverse.inverse_mass == 0);
    CHECK(ground.inverse.inverse_inertia.isZero(0));
}

TEST_CASE("mass: what is not a number is reported by body and quantity", "[rigid]")
{
    RigidBody body;
    body.name = "pebble";
    body.parts = {part_of(Sphere{std::numeric_limits<double>::quiet_NaN()}, {0, 0, 0}, 1)};
    try {
        set_mass_from_parts(body);
        FAIL("a NaN went through");
    } catch (const NonFiniteState& e) {
        CHECK(e.body == "pebble");
        CHECK(e.quantity == "mass");
    }
    body.parts = {part_of(Sphere{0}, {0, 0, 0}, 1)}; // a ball without mass
    CHECK_THROWS_AS(set_mass_from_parts(body), NonFiniteState);
}
