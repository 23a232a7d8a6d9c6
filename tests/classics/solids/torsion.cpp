// SPDX-License-Identifier: MIT
// A bar of length L and shear modulus G, whose section is a square with the side a, is twisted by
// the angle θ. It bears the moment 0.1406 G a⁴ θ/L. This is less than G θ/L times the polar moment
// a⁴/6, since its sections warp (Saint-Venant 1855; Timoshenko, "Theory of elasticity", § 109). The
// computed energy is larger than the exact one, ½ 0.1406 G a⁴ θ²/L, and converges to it: a coarse
// mesh, and ends that are held flat, are stiffer.
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a twisted bar warps and so is softer", "[classics]")
{
    const double L = 2, a = 0.5, E = 1e6, nu = 0.3, G = E / (2 * (1 + nu)), angle = 0.01;
    std::vector<double> shares;
    for (const int cells : {2, 4}) {
        SolidMaterial material;
        material.youngs_modulus = E;
        material.poisson_ratio = nu;
        Deformable bar = solid_of(block_tetrahedra({L, a, a}, {4 * cells, cells, cells}), material);
        for (const int side : {-1, 1}) {
            Handle handle;
            handle.nodes = end_nodes(bar, side);
            handle.pivot = {side * L / 2, 0, 0};
            handle.path = {{0, Vector3d::Zero(), Vector3d::Zero()},
                           {1, Vector3d::Zero(), Vector3d(side * angle / 2, 0, 0)}};
            bar.handles.push_back(handle);
        }
        DeformableWorld world = world_of(std::move(bar));
        run(world, 100, 10);
        const double energy = 0.1406 * G * std::pow(a, 4) * angle * angle / L / 2;
        shares.push_back(totals(world.solids[0]).elastic_energy / energy);
    }
    CAPTURE(shares);
    check_at_least(shares[1], 1, "share of the energy");
    check_at_most(shares[1], shares[0], "share on the finer mesh");
    check_at_most(shares[1], 1.4, "share of the energy");
}
