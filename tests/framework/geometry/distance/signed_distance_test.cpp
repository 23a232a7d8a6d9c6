// SPDX-License-Identifier: MIT
#include "geometry/distance/signed_distance.hpp"
#include "support/close.hpp"
#include "support/random.hpp"

#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;

const std::vector<Shape> shapes = {
    Sphere{0.7},           Capsule{0.4, 1.2},        Torus{1, 0.3},
    Torus{1, 0.95},        Box{{1, 2, 0.5}},         Cylinder{0.6, 1.5},
    Cylinder{1.5, 0.2},    Cone{0.7, 1.8},           Cone{1.5, 0.4},
    Ellipsoid{{1, 2, 3}},  Ellipsoid{{1, 0.1, 0.5}}, Ellipsoid{{1, 1, 1}},
    Ellipsoid{{2, 2, 0.3}}};

Vector3d about_y(double distance, double height, double angle)
{
    return {distance * std::cos(angle), height, distance * std::sin(angle)};
}

// Random points on each surface.
struct OnSurface {
    Random& random;
    double angle() const { return random.uniform(0, 2 * pi); }

    Vector3d operator()(const Sphere& s) const { return s.radius * random.unit_vector(); }
    Vector3d operator()(const Capsule& c) const
    {
        const Vector3d d = random.unit_vector();
        if (random.uniform(0, 1) < 0.5)
            return about_y(c.radius, random.uniform(-0.5, 0.5) * c.height, angle());
        return c.radius * d + Vector3d(0, (d.y() < 0 ? -0.5 : 0.5) * c.height, 0);
    }
    Vector3d operator()(const Torus& t) const
    {
        const double a = angle();
        return about_y(t.radius + t.tube * std::cos(a), t.tube * std::sin(a), angle());
    }
    Vector3d operator()(const Box& b) const
    {
        Vector3d p = random.vector();
        const int axis = static_cast<int>(random.uniform(0, 3));
        p[axis] = p[axis] < 0 ? -1 : 1;
        return p.cwiseProduct(b.size / 2);
    }
    Vector3d operator()(const Cylinder& c) const
    {
        const double side = random.uniform(0, 1) < 0.5 ? -0.5 : 0.5;
        if (random.uniform(0, 1) < 0.5)
            return about_y(c.radius, random.uniform(-0.5, 0.5) * c.height, angle());
        return about_y(random.uniform(0, 1) * c.radius, side * c.height, angle());
    }
    Vector3d operator()(const Cone& c) const
    {
        const double s = random.uniform(0, 1), up = random.uniform(0, 1) < 0.5 ? 0 : 1 - s;
        return about_y(s * c.radius, (up - 0.25) * c.height, angle());
    }
    Vector3d operator()(const Ellipsoid& e) const
    {
        return e.radii.cwiseProduct(random.unit_vector());
    }
    template <class Other> Vector3d operator()(const Other&) const { return {}; }
};

double distance(const Shape& shape, const Vector3d& p)
{
    return signed_distance(shape, p).distance;
}

} // namespace

TEST_CASE("signed distance: it is that to a point of the surface and none is nearer", "[geometry]")
{
    for (std::size_t k = 0; k < shapes.size(); ++k)
        for (unsigned seed = 0; seed < 200; ++seed) {
            CAPTURE(k, seed);
            Random random(seed);
            const Shape& shape = shapes[k];
            const Vector3d p = random.uniform(0.1, 3) * random.vector();
            const SurfaceDistance at = signed_distance(shape, p);
            REQUIRE_THAT(at.normal.norm(), IsClose(1.0, Rounding(16)));
            const Vector3d foot = p - at.distance * at.normal;
            REQUIRE_THAT(distance(shape, foot), IsClose(0.0, Rounding(64, 4)));
            for (int i = 0; i < 50; ++i) {
                const Vector3d x = std::visit(OnSurface{random}, shape);
                REQUIRE_THAT(distance(shape, x), IsClose(0.0, Rounding(64, 4)));
                REQUIRE((x - p).norm() >= std::abs(at.distance) - 1e-14);
            }
        }
}

TEST_CASE("signed distance: outside it grows along the normal as far as one goes", "[geometry]")
{
    for (std::size_t k = 0; k < shapes.size(); ++k)
        for (unsigned seed = 0; seed < 100; ++seed) {
            CAPTURE(k, seed);
            Random random(seed);
            const Vector3d p = 2 * random.vector();
            const SurfaceDistance at = signed_distance(shapes[k], p);
            if (at.distance < 1e-3) continue;
            if (std::holds_alternative<Torus>(shapes[k])) continue; // its other side may be near
            const double far = random.uniform(0, 100);
            REQUIRE_THAT(distance(shapes[k], p + far * at.normal),
                         IsClose(at.distance + far, Rounding(64, 200)));
        }
}

TEST_CASE("signed distance: centers are as deep as they can be", "[geometry]")
{
    const Vector3d o = Vector3d::Zero();
    CHECK_THAT(distance(Sphere{0.7}, o), IsClose(-0.7, Rounding(4)));
    CHECK_THAT(distance(Capsule{0.4, 2}, o), IsClose(-0.4, Rounding(4)));
    CHECK_THAT(distance(Torus{1, 0.3}, o), IsClose(0.7, Rounding(4)));
    CHECK_THAT(distance(Torus{1, 0.3}, {0, 0, 1}), IsClose(-0.3, Rounding(4)));
    CHECK_THAT(distance(Cylinder{0.6, 1}, o), IsClose(-0.5, Rounding(4)));
    CHECK_THAT(distance(Cylinder{0.4, 1}, o), IsClose(-0.4, Rounding(4)));
    CHECK_THAT(distance(Ellipsoid{{1, 2, 3}}, o), IsClose(-1.0, Rounding(8)));
    CHECK_THAT(distance(Ellipsoid{{3, 2, 0.5}}, o), IsClose(-0.5, Rounding(8)));
    // In a cone with a half angle of 45 degrees, the center of mass is at a quarter of the height,
    // and the base is nearer than the side.
    CHECK_THAT(distance(Cone{1, 1}, o), IsClose(-0.25, Rounding(8)));
    for (const Shape& shape : shapes) {
        CHECK(signed_distance(shape, o).normal.allFinite());
        CHECK(signed_distance(shape, {0, 1e-300, 0}).normal.allFinite());
        CHECK(signed_distance(shape, {1e12, -1e12, 1e12}).normal.allFinite());
    }
}
