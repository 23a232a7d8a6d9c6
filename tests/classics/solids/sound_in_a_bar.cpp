// SPDX-License-Identifier: MIT
// A bar that is fixed at one end and stretched sings with the speed of sound c = √(E/ρ): its lowest
// tone takes 4 L/c (Chladni 1787; Rayleigh, "The theory of sound", § 150). The error of the mesh
// falls with the square of its cells.
#include "classics/problems.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

TEST_CASE("classics: a bar sings with the speed of sound over four lengths", "[classics]")
{
    const double L = 1, E = 1e5, rho = 1000, c = std::sqrt(E / rho), period = 4 * L / c;
    std::vector<double> errors;
    for (const int cells : {4, 8, 16}) {
        SolidMaterial material;
        material.youngs_modulus = E;
        material.poisson_ratio = 0;
        Deformable bar = solid_of(block_tetrahedra({L, 0.1, 0.1}, {cells, 1, 1}), material);
        bar.integrator = NodeIntegrator::explicit_step;
        bar.handles.resize(1);
        bar.handles[0].nodes = end_nodes(bar, -1);
        const double A = 1e-5;
        for (Vector3d& x : bar.positions)
            x.x() += A * std::sin(pi / (2 * L) * (x.x() + L / 2));
        const int end = end_nodes(bar, 1)[0];
        DeformableWorld world = world_of(std::move(bar));
        const double h = period / 4000;
        double before = A, crosses = 0; // the first time that the end passes its place
        for (int n = 1; n <= 2000 && crosses == 0; ++n) {
            step(world, h);
            const double x = world.solids[0].positions[end].x() - L / 2;
            if (x < 0) crosses = h * (n - x / (x - before));
            before = x;
        }
        errors.push_back(std::abs(4 * crosses / period - 1));
    }
    CAPTURE(errors);
    check_at_most(errors[2], errors[0] / 8, "error on a mesh four times as fine");
    check_at_most(errors[2], 0.01, "error of the period");
}
