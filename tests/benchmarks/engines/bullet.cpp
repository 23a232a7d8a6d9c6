// SPDX-License-Identifier: MIT
// Bullet as a contestant, with its default settings.
#include "engine.hpp"

#include <btBulletDynamicsCommon.h>

namespace rigor {

namespace {

btVector3 bullets(const Vector3d& v)
{
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()),
            static_cast<btScalar>(v.z())};
}

btQuaternion bullets(const Eigen::Quaterniond& q)
{
    return {static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
            static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())};
}

Vector3d eigens(const btVector3& v)
{
    return {v.x(), v.y(), v.z()};
}

class BulletEngine final : public TrialEngine {
public:
    explicit BulletEngine(const Trial& trial) : couple_(trial.couple), arm_(trial.arm)
    {
        world_.setGravity(bullets(trial.gravity));
        for (const TrialBody& body : trial.bodies)
            add(body, trial);
        if (trial.has_ground) add_ground(trial);
    }

    ~BulletEngine() override
    {
        for (const auto& body : bodies_)
            world_.removeRigidBody(body.get());
    }
    BulletEngine(const BulletEngine&) = delete;
    BulletEngine& operator=(const BulletEngine&) = delete;

    void step(double time_step) override
    {
        if (!couple_.isZero(0)) // Bullet clears the torque after each step
            bodies_[0]->applyTorque(bullets((turn(0) * arm_).cross(couple_)));
        world_.stepSimulation(static_cast<btScalar>(time_step), 0);
    }

    TrialMotion motion(int body) const override
    {
        return {eigens(bodies_[body]->getCenterOfMassPosition()), turn(body),
                eigens(bodies_[body]->getLinearVelocity())};
    }

private:
    Eigen::Quaterniond turn(int body) const
    {
        const btQuaternion q = bodies_[body]->getOrientation();
        return Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).normalized();
    }

    btCollisionShape* shape_of(const Shape& shape)
    {
        if (const Box* box = std::get_if<Box>(&shape))
            shapes_.push_back(std::make_unique<btBoxShape>(bullets(box->size / 2)));
        else
            shapes_.push_back(std::make_unique<btSphereShape>(
                static_cast<btScalar>(std::get<Sphere>(shape).radius)));
        return shapes_.back().get();
    }

    btRigidBody& add(const TrialBody& from, const Trial& trial)
    {
        auto body = std::make_unique<btRigidBody>(static_cast<btScalar>(from.mass), nullptr,
                                                  shape_of(from.shape), bullets(from.inertia));
        body->setCenterOfMassTransform(
            btTransform(bullets(from.orientation), bullets(from.position)));
        body->setLinearVelocity(bullets(from.velocity));
        body->setAngularVelocity(bullets(from.angular_velocity));
        body->setDamping(0, 0);
        body->setActivationState(DISABLE_DEACTIVATION);
        // Bullet multiplies the coefficients of the two bodies.
        body->setFriction(static_cast<btScalar>(std::sqrt(trial.friction)));
        body->setRestitution(static_cast<btScalar>(std::sqrt(trial.restitution)));
        world_.addRigidBody(body.get());
        bodies_.push_back(std::move(body));
        return *bodies_.back();
    }

    // The ground is a box, because a cube on Bullet's plane shape gets only one new contact a step.
    void add_ground(const Trial& trial)
    {
        TrialBody ground = solid_cuboid(Vector3d(200, 2, 200), 0);
        ground.orientation = trial.ground;
        ground.position = trial.ground * Vector3d(0, -1, 0);
        add(ground, trial);
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    Vector3d couple_, arm_;
};

} // namespace

std::unique_ptr<TrialEngine> bullet_engine(const Trial& trial)
{
    return std::make_unique<BulletEngine>(trial);
}

} // namespace rigor
