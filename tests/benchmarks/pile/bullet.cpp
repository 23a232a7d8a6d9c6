// SPDX-License-Identifier: MIT
// The pile in Bullet, with its default settings.
#include "run.hpp"

#include "support/bench/bench.hpp"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace rigor {

namespace {

btScalar scalar(double x)
{
    return static_cast<btScalar>(x);
}

btVector3 vector(const Vector3d& v)
{
    return {scalar(v.x()), scalar(v.y()), scalar(v.z())};
}

// Bullet's world with its default settings, and the objects that it refers to.
struct BulletWorld {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broad_phase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broad_phase, &solver, &configuration};
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::vector<std::unique_ptr<btRigidBody>> bodies;

    ~BulletWorld()
    {
        for (const auto& body : bodies)
            world.removeRigidBody(body.get());
    }

    btRigidBody& add(double mass, btCollisionShape* shape, const btTransform& place)
    {
        btVector3 inertia(0, 0, 0);
        if (mass > 0) shape->calculateLocalInertia(scalar(mass), inertia);
        btRigidBody::btRigidBodyConstructionInfo info(scalar(mass), nullptr, shape, inertia);
        info.m_startWorldTransform = place;
        info.m_friction = scalar(std::sqrt(pile_friction)); // Bullet multiplies the coefficients
        info.m_restitution = 0;
        bodies.push_back(std::make_unique<btRigidBody>(info));
        world.addRigidBody(bodies.back().get());
        return *bodies.back();
    }
};

Pose pose_of(const btTransform& place)
{
    Pose pose;
    const btQuaternion q = place.getRotation();
    pose.R = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized().toRotationMatrix();
    const btVector3& X = place.getOrigin();
    pose.X = Vector3d(X.x(), X.y(), X.z());
    return pose;
}

} // namespace

PileRun pile_bullet(const PileStart& start, const PileOptions& options)
{
    BulletWorld bullet;
    bullet.world.setGravity(btVector3(0, scalar(pile_gravity), 0));
    for (const Wall& wall : start.walls) {
        bullet.shapes.push_back(std::make_unique<btBoxShape>(vector(wall.size / 2)));
        const btTransform place(btQuaternion::getIdentity(), vector(wall.center));
        bullet.add(0, bullet.shapes.back().get(), place);
    }
    btBoxShape cube(vector(Vector3d::Constant(0.5)));
    std::vector<btRigidBody*> cubes;
    for (std::size_t i = 0; i < start.cubes.size(); ++i) {
        const Quaternion& q = start.orientations[i];
        const btQuaternion turn(scalar(q.v.x()), scalar(q.v.y()), scalar(q.v.z()), scalar(q.s));
        cubes.push_back(
            &bullet.add(pile_density, &cube, btTransform(turn, vector(start.cubes[i].X))));
        if (!options.sleep) cubes.back()->setActivationState(DISABLE_DEACTIVATION);
    }

    PileRun run;
    for (int i = 0; i < options.steps; ++i)
        run.step_seconds.push_back(
            seconds([&] { bullet.world.stepSimulation(scalar(pile_step), 0); }));
    for (const btRigidBody* body : cubes)
        run.cubes.push_back(pose_of(body->getWorldTransform()));
    const auto asleep = std::count_if(cubes.begin(), cubes.end(),
                                      [](const btRigidBody* body) { return !body->isActive(); });
    run.asleep = static_cast<double>(asleep) / static_cast<double>(cubes.size());
    return run;
}

} // namespace rigor
