// SPDX-License-Identifier: MIT
// A cross of two bars, a concave mesh, falls with a level edge on a smooth floor. The impulse acts
// in the middle of the edge, at the distance a beside the center of mass, whatever the floor is and
// wherever its contacts lie on the edge:
//     j = (1 + ε) v/(1/M + a²/I),   ω = a j/I about the direction of the edge
#include "classics/problems.hpp"
#include "geometry/meshes/generators.hpp"

#include <algorithm>

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a cross that falls on a level edge turns about this edge alone", "[classics]")
{
    const double v = 2;
    const std::pair<Shape, Vector3d> floors[] = {
        {Plane{}, {0, 0, 0}}, {Box{{100, 1, 100}}, {0, -0.5, 0}}, {Cylinder{50, 1}, {0, -0.5, 0}}};
    Sweep sweep;
    for (const double length : {0.8, 8.})
        for (const double degrees : {5., 10., 20., 30., 37., 40.})
            for (const double heading : {0., 0.4})
                for (const double h : {0.005, 0.002})
                    for (const auto& [floor, place] : floors) {
                        if (!sweep.takes_next()) continue;
                        CAPTURE(length, degrees, heading, h, floor.index());
                        const TriangleMesh mesh = cross_mesh(length, length / 8);
                        const Matrix3d R = rotation_matrix(turn({0, 1, 0}, heading)) *
                                           rotation_matrix(turn({0, 0, 1}, degrees * pi / 180));
                        const Eigen::Quaterniond q(R);
                        Vector3d lowest = R * mesh.vertices[0];
                        for (const Vector3d& x : mesh.vertices)
                            if ((R * x).y() < lowest.y()) lowest = R * x;
                        RigidBody cross =
                            body_of(mesh_of(mesh), {0, 0.0123 * length - lowest.y(), 0}, {0.7, 0},
                                    {q.w(), q.vec()});
                        cross.state.velocity = {0, -v, 0};
                        World world = solved({fixed(floor, {0.7, 0}, place), cross}, {0, 0, 0});
                        run_until(world, 0.0125 * length / v + 2 * h, h);
                        const Vector3d edge = R.col(2);
                        const double a = lowest.cross(Vector3d::UnitY()).dot(edge);
                        const double I = cross.inertia(2, 2);
                        const double j = 1.7 * v / (1 / cross.mass + a * a / I);
                        const Vector3d omega = angular_velocity(world.bodies[1]);
                        CHECK_THAT(omega, IsClose(Vector3d(a * j / I * edge),
                                                  Order(1e-9 * j / cross.mass / length)));
                        CHECK_THAT(world.bodies[1].state.velocity.y(),
                                   IsClose(j / cross.mass - v, Order(1e-9)));
                    }
}
