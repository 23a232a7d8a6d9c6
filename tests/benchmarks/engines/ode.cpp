// SPDX-License-Identifier: MIT
// ODE as a contestant, with its default settings.
#include "engine.hpp"

#include <ode/ode.h>

namespace rigor {

namespace {

constexpr int most_contacts = 8; // contacts of a pair, as in ODE's own examples

struct OdeLibrary {
    OdeLibrary() { dInitODE2(0); }
    ~OdeLibrary() { dCloseODE(); }
    OdeLibrary(const OdeLibrary&) = delete;
    OdeLibrary& operator=(const OdeLibrary&) = delete;
};

Vector3d vector(const dReal* v)
{
    return {v[0], v[1], v[2]};
}

dReal real(double x)
{
    return static_cast<dReal>(x);
}

class OdeEngine final : public TrialEngine {
public:
    OdeEngine(const Trial& trial, bool quick_step)
        : friction_(real(trial.friction)), restitution_(real(trial.restitution)),
          quick_step_(quick_step), couple_(trial.couple), arm_(trial.arm)
    {
        static const OdeLibrary library;
        // Without this, ODE prints the same messages in every step.
        dSetMessageHandler([](int, const char*, va_list) {});
        dRandSetSeed(0); // quick_step shuffles its rows at random
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
        const Vector3d& g = trial.gravity;
        dWorldSetGravity(world_, real(g.x()), real(g.y()), real(g.z()));
        for (const TrialBody& body : trial.bodies)
            add(body);
        const Vector3d n = trial.ground * Vector3d::UnitY();
        if (trial.has_ground) dCreatePlane(space_, real(n.x()), real(n.y()), real(n.z()), 0);
    }

    ~OdeEngine() override
    {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    OdeEngine(const OdeEngine&) = delete;
    OdeEngine& operator=(const OdeEngine&) = delete;

    void step(double time_step) override
    {
        if (!couple_.isZero(0)) {
            const Vector3d torque = (motion(0).orientation * arm_).cross(couple_);
            dBodyAddTorque(bodies_[0], real(torque.x()), real(torque.y()), real(torque.z()));
        }
        dSpaceCollide(space_, this, &OdeEngine::collide);
        if (quick_step_)
            dWorldQuickStep(world_, real(time_step));
        else
            dWorldStep(world_, real(time_step));
        dJointGroupEmpty(contacts_);
    }

    TrialMotion motion(int body) const override
    {
        const dReal* q = dBodyGetQuaternion(bodies_[body]);
        return {vector(dBodyGetPosition(bodies_[body])),
                Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized(),
                vector(dBodyGetLinearVel(bodies_[body]))};
    }

private:
    void add(const TrialBody& from)
    {
        const dBodyID body = dBodyCreate(world_);
        const Vector3d &I = from.inertia, &x = from.position, &v = from.velocity,
                       &w = from.angular_velocity;
        dMass mass;
        dMassSetParameters(&mass, real(from.mass), 0, 0, 0, real(I.x()), real(I.y()), real(I.z()),
                           0, 0, 0);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, real(x.x()), real(x.y()), real(x.z()));
        const Eigen::Quaterniond& q = from.orientation;
        const dQuaternion turn = {real(q.w()), real(q.x()), real(q.y()), real(q.z())};
        dBodySetQuaternion(body, turn);
        dBodySetLinearVel(body, real(v.x()), real(v.y()), real(v.z()));
        dBodySetAngularVel(body, real(w.x()), real(w.y()), real(w.z()));
        dGeomSetBody(geometry_of(from.shape), body);
        bodies_.push_back(body);
    }

    dGeomID geometry_of(const Shape& shape) const
    {
        if (const Box* box = std::get_if<Box>(&shape))
            return dCreateBox(space_, real(box->size.x()), real(box->size.y()),
                              real(box->size.z()));
        return dCreateSphere(space_, real(std::get<Sphere>(shape).radius));
    }

    static void collide(void* self, dGeomID geometry1, dGeomID geometry2)
    {
        const OdeEngine& engine = *static_cast<OdeEngine*>(self);
        dContact contacts[most_contacts] = {};
        const int n = dCollide(geometry1, geometry2, most_contacts, &contacts[0].geom,
                               static_cast<int>(sizeof(dContact)));
        for (int i = 0; i < n; ++i) {
            dSurfaceParameters& surface = contacts[i].surface;
            surface.mode = dContactApprox1; // friction is proportional to the normal force
            surface.mu = engine.friction_;
            if (engine.restitution_ > 0) {
                surface.mode |= dContactBounce;
                surface.bounce = engine.restitution_;
                surface.bounce_vel = 0;
            }
            const dJointID joint =
                dJointCreateContact(engine.world_, engine.contacts_, &contacts[i]);
            dJointAttach(joint, dGeomGetBody(geometry1), dGeomGetBody(geometry2));
        }
    }

    dReal friction_, restitution_;
    bool quick_step_;
    Vector3d couple_, arm_;
    dWorldID world_ = nullptr;
    dSpaceID space_ = nullptr;
    dJointGroupID contacts_ = nullptr;
    std::vector<dBodyID> bodies_;
};

} // namespace

std::unique_ptr<TrialEngine> ode_engine(const Trial& trial, bool quick_step)
{
    return std::make_unique<OdeEngine>(trial, quick_step);
}

} // namespace rigor
