// SPDX-License-Identifier: MIT
// The pile in ODE, with its quick step and default settings.
#include "run.hpp"

#include "support/bench/bench.hpp"

#include <ode/ode.h>

namespace rigor {

namespace {

constexpr int most_contacts = 8; // contacts of a pair, as in ODE's own examples

dReal real(double x)
{
    return static_cast<dReal>(x);
}

struct OdeWorld {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dJointGroupID contacts = dJointGroupCreate(0);
};

void touch(void* data, dGeomID geom1, dGeomID geom2)
{
    const OdeWorld& ode = *static_cast<OdeWorld*>(data);
    const dBodyID body1 = dGeomGetBody(geom1), body2 = dGeomGetBody(geom2);
    if (!body1 && !body2) return;
    dContact contacts[most_contacts] = {};
    const int count = dCollide(geom1, geom2, most_contacts, &contacts[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contacts[i].surface.mode = dContactApprox1;
        contacts[i].surface.mu = real(pile_friction);
        const dJointID joint = dJointCreateContact(ode.world, ode.contacts, &contacts[i]);
        dJointAttach(joint, body1, body2);
    }
}

dGeomID add_box(const OdeWorld& ode, const Vector3d& size)
{
    return dCreateBox(ode.space, real(size.x()), real(size.y()), real(size.z()));
}

dBodyID add_cube(const OdeWorld& ode, const Vector3d& X, const Quaternion& q)
{
    const dBodyID body = dBodyCreate(ode.world);
    dMass mass;
    dMassSetBox(&mass, real(pile_density), 1, 1, 1);
    dBodySetMass(body, &mass);
    dGeomSetBody(add_box(ode, Vector3d::Ones()), body);
    const dQuaternion turn = {real(q.s), real(q.v.x()), real(q.v.y()), real(q.v.z())};
    dBodySetPosition(body, real(X.x()), real(X.y()), real(X.z()));
    dBodySetQuaternion(body, turn);
    return body;
}

} // namespace

PileRun pile_ode(const PileStart& start, const PileOptions& options)
{
    dInitODE2(0);
    OdeWorld ode;
    dWorldSetGravity(ode.world, 0, real(pile_gravity), 0);
    for (const Wall& wall : start.walls) {
        const Vector3d& c = wall.center;
        dGeomSetPosition(add_box(ode, wall.size), real(c.x()), real(c.y()), real(c.z()));
    }
    std::vector<dBodyID> cubes;
    for (std::size_t i = 0; i < start.cubes.size(); ++i)
        cubes.push_back(add_cube(ode, start.cubes[i].X, start.orientations[i]));

    PileRun run;
    for (int i = 0; i < options.steps; ++i)
        run.step_seconds.push_back(seconds([&] {
            dSpaceCollide(ode.space, &ode, touch);
            dWorldQuickStep(ode.world, real(pile_step));
            dJointGroupEmpty(ode.contacts);
        }));
    for (const dBodyID body : cubes) {
        const dReal *X = dBodyGetPosition(body), *q = dBodyGetQuaternion(body);
        const Eigen::Quaterniond turn(q[0], q[1], q[2], q[3]);
        run.cubes.push_back({turn.normalized().toRotationMatrix(), Vector3d(X[0], X[1], X[2])});
    }
    dJointGroupDestroy(ode.contacts);
    dSpaceDestroy(ode.space);
    dWorldDestroy(ode.world);
    dCloseODE();
    return run;
}

} // namespace rigor
