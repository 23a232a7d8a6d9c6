// SPDX-License-Identifier: MIT
#include "stress/scenes.hpp"

#include "geometry/shapes/pose.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/bodies/mass.hpp"
#include "support/random.hpp"

#include <cmath>

namespace rigor::stress {

World world_of(std::vector<RigidBody> bodies, const Vector3d& gravity)
{
    World world;
    world.bodies = std::move(bodies);
    world.settings.gravity = gravity;
    world.settings.contact_method = ContactMethod::simultaneous;
    world.settings.formulas_are_reference = true; // the reference is linked in
    world.settings.optimisations.sleep = false;
    return world;
}

RigidBody body_of(const Shape& shape, const Vector3d& X, const Material& material,
                  const Quaternion& q, double density)
{
    RigidBody body;
    body.name = "body";
    Part part;
    part.shape = shape;
    part.density = density;
    body.parts = {part};
    body.material = material;
    body.state.position = X;
    body.state.orientation = q;
    set_mass_from_parts(body);
    return body;
}

RigidBody fixed(const Shape& shape, const Vector3d& X, const Material& material,
                const Quaternion& q)
{
    RigidBody body;
    body.name = "fixed";
    body.is_static = true;
    body.parts.resize(1);
    body.parts[0].shape = shape;
    body.material = material;
    body.state.position = X;
    body.state.orientation = q;
    set_mass_from_parts(body);
    return body;
}

Box cube(double edge)
{
    return {Vector3d::Constant(edge)};
}

// The surface of a box as a grid of vertices (i, k, top). The top and the bottom are divided into n
// × n squares, the sides into n × 1.
Mesh slab(int n, double width)
{
    TriangleMesh mesh;
    const auto index = [n](int i, int k, int top) { return 2 * (i * (n + 1) + k) + top; };
    for (int i = 0; i <= n; ++i)
        for (int k = 0; k <= n; ++k)
            for (int top = 0; top < 2; ++top)
                mesh.vertices.emplace_back(width * (double(i) / n - 0.5), top - 1.0,
                                           width * (double(k) / n - 0.5));
    const auto square = [&mesh](int a, int b, int c, int d) {
        mesh.triangles.push_back({a, b, c});
        mesh.triangles.push_back({a, c, d});
    };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            square(index(i, k, 1), index(i, k + 1, 1), index(i + 1, k + 1, 1), index(i + 1, k, 1));
            square(index(i, k, 0), index(i + 1, k, 0), index(i + 1, k + 1, 0), index(i, k + 1, 0));
        }
    for (int i = 0; i < n; ++i) {
        square(index(0, i, 0), index(0, i + 1, 0), index(0, i + 1, 1), index(0, i, 1));
        square(index(n, i, 0), index(n, i, 1), index(n, i + 1, 1), index(n, i + 1, 0));
        square(index(i, 0, 0), index(i, 0, 1), index(i + 1, 0, 1), index(i + 1, 0, 0));
        square(index(i, n, 0), index(i + 1, n, 0), index(i + 1, n, 1), index(i, n, 1));
    }
    return {std::make_shared<SolidMesh>(std::move(mesh), "slab")};
}

RigidBody ground(const Material& material)
{
    return fixed(Plane{}, {0, 0, 0}, material);
}

Quaternion turn(const Vector3d& axis, double angle)
{
    return {std::cos(angle / 2), std::sin(angle / 2) * axis.normalized()};
}

void spin(RigidBody& body, const Vector3d& angular_velocity)
{
    const Matrix3d R = rotation_matrix(body.state.orientation);
    body.state.angular_momentum = R * body.inertia * R.transpose() * angular_velocity;
}

World stack(int n, double edge, const Vector3d& foot)
{
    std::vector<RigidBody> bodies = {fixed(Plane{}, foot)};
    for (int i = 0; i < n; ++i)
        bodies.push_back(body_of(cube(edge), foot + Vector3d(0, (i + 0.5) * edge, 0)));
    return world_of(std::move(bodies));
}

World falling_pile(int n, const Material& material, unsigned seed)
{
    testing::Random random(seed);
    std::vector<RigidBody> bodies = {ground(material)};
    for (int y = 0; y < n; ++y)
        for (int z = 0; z < n; ++z)
            for (int x = 0; x < n; ++x)
                bodies.push_back(
                    body_of(cube(1), 1.8 * Vector3d(x, y + 0.6, z), material, random.quaternion()));
    return world_of(std::move(bodies));
}

} // namespace rigor::stress
