// SPDX-License-Identifier: MIT
#include "deformable/motion/tension.hpp"
#include "support/close.hpp"
#include "support/deformables.hpp"

using namespace rigor;
using namespace rigor::testing;

namespace tension {

namespace {

// A block of 2 m³, turned by R after it was strained evenly along its x.
Deformable strained_block(double strain, const Matrix3d& R)
{
    SolidMaterial material = soft_material();
    material.poisson_ratio = 0;
    Deformable block = solid_of(block_tetrahedra({2, 1, 1}, {4, 2, 2}), material);
    for (Vector3d& x : block.positions)
        x = R * Vector3d((1 + strain) * x.x(), x.y(), x.z());
    return block;
}

// Σ (Σ cᵢ·uᵢ)² for a turn u = ω × x of the whole block.
double stiffness_of_turn(const Deformable& solid, const Vector3d& omega, double time_step)
{
    ElementWorkspace work(solid);
    work.elements.strains(solid.positions, work.strains);
    BlockMatrix matrix;
    matrix.analyse(work.elements, static_cast<int>(solid.positions.size()));
    Tension tension;
    tension.find(solid, work, matrix, {}, time_step);
    double sum = 0;
    for (const TurnStiffness& term : tension.terms()) {
        double turn = 0;
        for (int i = 0; i < 4; ++i)
            turn +=
                term.c[i].dot(omega.cross(solid.positions[work.elements.nodes(term.element)[i]]));
        sum += turn * turn;
    }
    return sum;
}

constexpr double very_long = 1e9; // a step that leaves out next to no stress [s]

} // namespace

TEST_CASE("tension: a turn across the pull meets V σ ω², and a turn about it nothing",
          "[deformable]")
{
    Random random(5);
    const double strain = 1e-5;
    for (int repeat = 0; repeat < 5; ++repeat) {
        const Matrix3d R = random.rotation();
        const Deformable block = strained_block(strain, R);
        const double V_sigma = 2 * block.material.youngs_modulus * strain;
        CHECK_THAT(stiffness_of_turn(block, 3 * R.col(1), very_long),
                   IsClose(9 * V_sigma, Order(1e-4 * V_sigma)));
        CHECK_THAT(stiffness_of_turn(block, R.col(0), very_long),
                   IsClose(0.0, Order(1e-4 * V_sigma)));
    }
}

TEST_CASE("tension: compression has no terms, and a short step leaves tension out", "[deformable]")
{
    Random random(6);
    const Matrix3d R = random.rotation();
    const double h = 0.01; // sound needs 0.05 s through a cell
    CHECK(stiffness_of_turn(strained_block(-0.05, R), R.col(1), 1000 * h) == 0);
    CHECK(stiffness_of_turn(strained_block(0.05, R), R.col(1), h) == 0);
    CHECK(stiffness_of_turn(strained_block(0.05, R), R.col(1), 100 * h) > 0);
}

} // namespace tension
