// SPDX-License-Identifier: MIT
// The free box in ODE.
#include "run.hpp"

#include "support/bench/bench.hpp"

#include <ode/ode.h>

namespace rigor {

SpinRun spin_ode(int steps)
{
    dInitODE2(0);
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    const Eigen::Vector3d &I = spin_inertia, &w = spin_velocity;
    dMass mass;
    dMassSetParameters(&mass, static_cast<dReal>(spin_mass), 0, 0, 0, static_cast<dReal>(I.x()),
                       static_cast<dReal>(I.y()), static_cast<dReal>(I.z()), 0, 0, 0);
    dBodySetMass(body, &mass);
    dBodySetAngularVel(body, static_cast<dReal>(w.x()), static_cast<dReal>(w.y()),
                       static_cast<dReal>(w.z()));

    SpinRun run;
    run.seconds = seconds([&] {
        for (int i = 0; i < steps; ++i)
            dWorldStep(world, static_cast<dReal>(spin_end / steps));
    });
    const dReal* q = dBodyGetQuaternion(body);
    run.orientation = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized();
    dWorldDestroy(world);
    dCloseODE();
    return run;
}

} // namespace rigor
