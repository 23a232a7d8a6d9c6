// SPDX-License-Identifier: MIT
#include "rigid/bodies/orientation.hpp"

#include "framework/rigid/integrators.hpp"
#include "framework/rigid/worlds.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace {

// The rotation q followed by the rotation p.
Quaternion after(const Quaternion& p, const Quaternion& q)
{
    const Eigen::Quaterniond product = eigen(p) * eigen(q);
    return {product.w(), product.vec()};
}

} // namespace

TEST_CASE("orientation: the distance is half the angle and none between q and -q", "[rigid]")
{
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Quaternion q = random.quaternion();
        CHECK(orientation_distance(q, {-q.s, -q.v}) == 0);
        const Quaternion turned = after(turn(random.unit_vector(), 1e-3), q);
        CHECK_THAT(orientation_distance(q, turned), IsClose(5e-4, Order(1e-10)));
    }
}

TEST_CASE("orientation: the angular velocity is that of the inertia in world space", "[rigid]")
{
    for (const Integrator integrator : all_integrators) {
        Random random(3);
        RigidBody body = free_box({1, 2, 3});
        body.state.orientation = random.quaternion();
        const Vector3d omega = random.vector();
        spin(body, omega);
        CHECK_THAT(rigor::angular_velocity(integrator, body, body.state),
                   IsClose(omega, Rounding(256)));
    }
}
