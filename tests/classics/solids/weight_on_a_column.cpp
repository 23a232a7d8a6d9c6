// SPDX-License-Identifier: MIT
// The crusher gauge: a weight that falls on a column of soft metal is stopped by the force that the
// column bears, A σ_Y, so that it slows down by A σ_Y/m - g. It crushes the column by
// v²/(2 (A σ_Y/m - g)), after which the column springs back (Vieille 1882; Taylor 1948, "The use of
// flat-ended projectiles for determining dynamic yield stress").
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace weight_on_a_column {

namespace {

struct Gauge {
    double side = 0.2, length = 1, sigma_Y = 1e4, weight = 20, v = 1;
    double slows_by() const { return side * side * sigma_Y / weight - g; } // [m/s²]
};

// A column on a floor without friction, and a box on it that moves down.
DeformableWorld world_of_gauge(const Gauge& gauge, NodeIntegrator integrator)
{
    SolidMaterial material;
    material.density = 10;
    material.youngs_modulus = 1e7;
    material.poisson_ratio = 0.3;
    material.yield_stress = gauge.sigma_Y;
    material.surface = {0, 0};
    Deformable column = make_deformable(
        "column", block_tetrahedra({gauge.side, gauge.length, gauge.side}, {2, 4, 2}), material,
        Matrix3d::Identity(), Vector3d(0, gauge.length / 2, 0));
    column.integrator = integrator;
    DeformableWorld world = world_of(std::move(column));
    world.rigid.settings.gravity = {0, -g, 0};
    RigidBody box = body_of(Box{{0.5, 0.5, 0.5}}, {0, gauge.length + 0.25, 0}, {0, 0});
    set_mass(box, gauge.weight, 0.04 * gauge.weight * Matrix3d::Identity());
    box.state.velocity = {0, -gauge.v, 0};
    world.rigid.bodies = {fixed(Plane{}, {0, 0}), box};
    return world;
}

} // namespace

TEST_CASE("classics: a weight that crushes a column is stopped by what the column bears",
          "[classics]")
{
    for (const NodeIntegrator integrator :
         {NodeIntegrator::implicit_step, NodeIntegrator::explicit_step})
        for (const double h : {0.01, 0.001}) {
            CAPTURE(static_cast<int>(integrator), h);
            const Gauge gauge;
            DeformableWorld world = world_of_gauge(gauge, integrator);
            run(world, h, static_cast<int>(std::lround(0.02 / h)));
            const double v = world.rigid.bodies[1].state.velocity.y();
            run(world, h, static_cast<int>(std::lround(0.05 / h)));
            const double a = (world.rigid.bodies[1].state.velocity.y() - v) / 0.05;
            CHECK_THAT(a, IsClose(gauge.slows_by(), Order(0.02 * gauge.slows_by())));
            run(world, h, static_cast<int>(std::lround(0.5 / h)));
            const double crushed = gauge.length + 0.25 - world.rigid.bodies[1].state.position.y();
            const double exact = gauge.v * gauge.v / (2 * gauge.slows_by());
            check_at_most(std::abs(crushed / exact - 1), h > 0.005 ? 0.12 : 0.03,
                          "error of what the column is crushed by, relative");
        }
}

} // namespace weight_on_a_column
