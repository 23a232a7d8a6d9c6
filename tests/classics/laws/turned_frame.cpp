// SPDX-License-Identifier: MIT
// Space is isotropic: a scene that is rotated as a whole, with its gravity, gives the rotated
// motion.
#include "classics/problems.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace turned_frame {

namespace {

World table_scene(const Quaternion& q)
{
    const Matrix3d R = rotation_matrix(q);
    const Material material{0.5, 0.4};
    std::vector<RigidBody> bodies = {fixed(Plane{}, material, {0, 0, 0}, q)};
    const std::vector<Shape> shapes = {Box{{0.4, 0.3, 0.5}}, Sphere{0.2}, Capsule{0.1, 0.4}};
    for (int i = 0; i < 3; ++i) {
        const Eigen::Quaterniond turned = eigen(q) * eigen(turn({1, 2, 3.}, 0.3 * i));
        RigidBody body = body_of(shapes[i], R * Vector3d(0.7 * i, 0.5, 0.1 * i), material,
                                 {turned.w(), turned.vec()});
        body.state.velocity = R * Vector3d(1 - i, -1, 0.3);
        spin(body, R * Vector3d(0.5, 1, -2));
        bodies.push_back(body);
    }
    return solved(bodies, R * Vector3d(0, -g, 0));
}

} // namespace

TEST_CASE("classics: a turned scene does the same turned", "[classics]")
{
    Random random(3);
    for (int n = 0; n < 6; ++n) {
        const Quaternion q = random.quaternion();
        const Matrix3d R = rotation_matrix(q);
        World upright = table_scene({}), turned = table_scene(q);
        run(upright, 50, 0.01);
        run(turned, 50, 0.01);
        CAPTURE(n);
        for (int i = 1; i < 4; ++i) {
            const RigidState &a = upright.bodies[i].state, &b = turned.bodies[i].state;
            CHECK_THAT(b.position, IsClose(Vector3d(R * a.position), Order(1e-6)));
            CHECK_THAT(b.velocity, IsClose(Vector3d(R * a.velocity), Order(1e-5)));
        }
    }
}

} // namespace turned_frame
