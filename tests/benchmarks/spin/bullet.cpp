// SPDX-License-Identifier: MIT
// The free box in Bullet.
#include "run.hpp"

#include "support/bench/bench.hpp"

#include <btBulletDynamicsCommon.h>

namespace rigor {

SpinRun spin_bullet(int steps)
{
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase broad_phase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &broad_phase, &solver, &configuration);
    world.setGravity(btVector3(0, 0, 0));

    const auto vector = [](const Eigen::Vector3d& v) {
        return btVector3(static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()),
                         static_cast<btScalar>(v.z()));
    };
    btBoxShape shape(vector(spin_size / 2));
    btDefaultMotionState motion;
    btRigidBody body(static_cast<btScalar>(spin_mass), &motion, &shape, vector(spin_inertia));
    body.setDamping(0, 0);
    body.setActivationState(DISABLE_DEACTIVATION);
    body.setAngularVelocity(vector(spin_velocity));
    world.addRigidBody(&body);

    SpinRun run;
    const auto h = static_cast<btScalar>(spin_end / steps);
    run.seconds = seconds([&] {
        for (int i = 0; i < steps; ++i)
            world.stepSimulation(h, 0);
    });
    const btQuaternion q = body.getOrientation();
    run.orientation = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized();
    world.removeRigidBody(&body);
    return run;
}

} // namespace rigor
