// SPDX-License-Identifier: MIT
// A bar that is pulled steadily stays straight, since tension brings it back from each side
// (Rayleigh 1877, "The theory of sound", § 189). A load F moves the center of mass by F L/(2 E A),
// the bar's own weight by ρ g L²/(3 E), and its end by half its way, if ν = 0 (Hooke; Landau and
// Lifshitz, "Theory of elasticity", § 5).
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace steady_pull {

namespace {

constexpr double E = 1e7, rho = 1000, L = 0.1;
const double c = std::sqrt(E / rho); // the speed of sound along a bar [m/s]

enum class Pull { load, weight, end };

// A bar along the first column of R, pulled so that `strain` is the strain of the end that is held.
// Its nodes are a little out of place, as far as `jitter` [m]. If an end is pulled, R must be δ.
DeformableWorld pulled_bar(Pull pull, double strain, const Matrix3d& R, double jitter)
{
    const double a = 0.02;
    SolidMaterial material;
    material.youngs_modulus = E;
    material.density = rho;
    material.poisson_ratio = 0;
    Deformable bar = make_deformable("bar", block_tetrahedra({L, a, a}, {10, 2, 2}), material, R,
                                     Vector3d::Zero());
    const std::vector<int> end = end_nodes(bar, 1);
    Handle handle;
    handle.nodes = end_nodes(bar, -1);
    bar.handles.push_back(handle);
    const Vector3d along = R.col(0);
    if (pull == Pull::load) bar.loads = {{end, strain * E * a * a * along, 0, never}};
    if (pull == Pull::end) {
        handle.nodes = end;
        handle.axes = {true, false, false};
        handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                       {1e-6, strain * L * along, Vector3d::Zero()}};
        bar.handles.push_back(handle);
    }
    Random random(3);
    for (Vector3d& x : bar.positions)
        x += jitter * random.vector();
    DeformableWorld world = world_of(std::move(bar));
    world.rigid.settings.gravity = Vector3d::Zero();
    if (pull == Pull::weight) world.rigid.settings.gravity = strain * E / (rho * L) * along;
    return world;
}

} // namespace

TEST_CASE("classics: a bar under a steady pull stays as long as it should be", "[classics]")
{
    Random random(4);
    for (const Pull pull : {Pull::load, Pull::weight, Pull::end})
        for (const double strain : {0.01, 0.02, 0.05, 0.1, 0.2})
            for (const double reach : {1., 2., 5., 10., 20., 100.}) { // h c/L
                CAPTURE(static_cast<int>(pull), strain, reach);
                const bool is_turned = pull != Pull::end;
                const Matrix3d R = is_turned ? random.rotation() : Matrix3d::Identity();
                DeformableWorld world = pulled_bar(pull, strain, R, 1e-6 * L);
                const double shift = strain * L / (pull == Pull::weight ? 3 : 2);
                run(world, reach * L / c, 60);
                double at_most = 0, at_least = never; // in the last steps it may tremble
                for (int i = 0; i < 20; ++i) {
                    step(world, reach * L / c);
                    const double x = totals(world.solids[0]).center_of_mass.dot(R.col(0)) / shift;
                    at_most = std::max(at_most, x);
                    at_least = std::min(at_least, x);
                }
                REQUIRE_THAT(at_most, IsClose(1.0, Order(0.003)));
                REQUIRE_THAT(at_least, IsClose(1.0, Order(0.003)));
            }
}

// Backward Euler makes swings smaller, but not as fast as it would with all of the tension in its
// matrix. The bar hangs from one edge and swings as a physical pendulum.
TEST_CASE("classics: a bar that hangs from an edge goes on swinging in long steps", "[classics]")
{
    SolidMaterial material;
    material.youngs_modulus = E;
    material.density = rho;
    Deformable bar = solid_of(block_tetrahedra({L, 0.02, 0.02}, {10, 2, 2}), material);
    Handle hinge;
    for (const int i : end_nodes(bar, -1))
        if (std::abs(bar.rest.vertices[i].y()) < 1e-9) hinge.nodes.push_back(i);
    bar.handles.push_back(hinge);
    DeformableWorld world = world_of(std::move(bar));
    const double angle = 0.3;
    world.rigid.settings.gravity = {g * std::cos(angle), -g * std::sin(angle), 0};
    const double h = 0.02; // sound runs along the bar twenty times
    run(world, h, 200);
    double swing = 0;
    for (int i = 0; i < 50; ++i) {
        step(world, h);
        const Vector3d X = totals(world.solids[0]).center_of_mass;
        swing = std::max(swing, std::abs(std::atan2(-X.y(), X.x() + L / 2) - angle));
    }
    REQUIRE_THAT(swing, IsClose(angle, Order(0.1 * angle)));
}

} // namespace steady_pull
