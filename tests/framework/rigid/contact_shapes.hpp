// SPDX-License-Identifier: MIT
// Shapes of every kind, and properties of them that are computed without the narrow phase.
#pragma once

#include "geometry/distance/signed_distance.hpp"
#include "geometry/distance/support.hpp"
#include "geometry/meshes/generators.hpp"
#include "geometry/meshes/mesh_surface.hpp"
#include "geometry/shapes/solid_mesh.hpp"
#include "rigid/detection/shape_contacts.hpp"
#include "worlds.hpp"

namespace rigor::testing {

inline std::vector<Contact> touches_of(const Shape& a, const Pose& pose_a, const Shape& b,
                                       const Pose& pose_b, double reach = 1e9)
{
    std::vector<Contact> touches;
    find_shape_contacts(a, pose_a, b, pose_b, reach, touches);
    return touches;
}

inline double deepest(const std::vector<Contact>& touches)
{
    double least = 1e300;
    for (const Contact& t : touches)
        least = std::min(least, t.gap);
    return least;
}

inline Shape mesh(const TriangleMesh& triangles)
{
    return Mesh{std::make_shared<SolidMesh>(triangles)};
}

struct NamedShape {
    std::string name;
    Shape shape;
    double accuracy = 0; // allowed error of its contacts [m], at most 1 % of its size
};

inline const std::vector<NamedShape>& all_shapes()
{
    static const std::vector<NamedShape> all = {
        {"sphere", Sphere{0.4}, 0.004},
        {"capsule", Capsule{0.25, 0.6}, 0.004},
        {"torus", Torus{0.4, 0.13}, 0.004},
        {"box", Box{{0.6, 0.5, 0.8}}, 0.004},
        {"cylinder", Cylinder{0.35, 0.8}, 0.004},
        {"cone", Cone{0.4, 0.9}, 0.004},
        {"ellipsoid", Ellipsoid{{0.5, 0.25, 0.35}}, 0.004},
        {"ring", mesh(ring_mesh(0.3, 0.5, 0.25, 48)), 0.008},
        {"cross", mesh(cross_mesh(1, 0.3)), 0.008},
        {"bowl", mesh(bowl_mesh(0.5, 0.1, 48)), 0.008},
        {"gear", mesh(gear_mesh(12, 0.5, 0.15, 0.2)), 0.008},
        {"angle", mesh(angle_mesh({0.8, 0.8, 0.4}, 0.25)), 0.008},
        {"stone", mesh(voussoir_mesh(0.2, 0.6, 60, 0.5)), 0.004},
    };
    return all;
}

/// The largest extent of a shape from its origin along a unit direction [m].
inline double reach_along(const Shape& shape, const Vector3d& d)
{
    if (const Sphere* s = std::get_if<Sphere>(&shape)) return s->radius;
    if (const Capsule* c = std::get_if<Capsule>(&shape))
        return c->radius + c->height / 2 * std::abs(d.y());
    if (const Torus* t = std::get_if<Torus>(&shape))
        return t->tube + t->radius * std::hypot(d.x(), d.z());
    if (const Mesh* m = std::get_if<Mesh>(&shape)) {
        double far = -1e300;
        for (const Vector3d& v : m->solid->mesh().vertices)
            far = std::max(far, d.dot(v));
        return far;
    }
    return d.dot(support(shape, d));
}

inline Pose random_pose(Random& random, double spread)
{
    return {random.rotation(), spread * random.vector()};
}

/// The pose of a shape at X, rotated about an axis.
inline Pose turned(const Vector3d& axis, double degrees, const Vector3d& X)
{
    return {rotation_matrix(turn(axis, degrees * std::numbers::pi / 180)), X};
}

/// The eight corners of a box in world space.
std::vector<Vector3d> corners(const Box& box, const Pose& pose);

/// A box with a dent in its top, which leaves its other surfaces unchanged. A dented box is handled
/// by its level set.
TriangleMesh dented_box(const Vector3d& size);

/// A fine triangle mesh of a shape of any kind.
TriangleMesh fine_mesh(const Shape& shape);

/// The distance along `away` from the first shape at which the second shape, coming from outside,
/// just touches it, measured with fine meshes of both [m].
double meeting_distance(const Shape& first, const Pose& pose, const Shape& second,
                        const Matrix3d& R, const Vector3d& away);

} // namespace rigor::testing
