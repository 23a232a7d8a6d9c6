// SPDX-License-Identifier: MIT
// A6.8: a piece of steel that is strained step by step. The result does not depend on the number of
// steps as long as the stress keeps its direction.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <numbers>

namespace plasticity_cycle_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr double G = steel::G, sigma_Y = steel::yield_stress;
const double tau_Y = sigma_Y / std::numbers::sqrt3;

// One point of a solid.
struct MaterialPoint {
    Matrix3d strain = Matrix3d::Zero(), plastic_strain = Matrix3d::Zero(),
             stress = Matrix3d::Zero();
    double dissipation = 0; // ∫ σ : dε_p [J/m³]
    int steps = 0;

    void step(const Matrix3d& new_strain)
    {
        strain = new_strain;
        const Matrix3d trial = isotropic_stress(strain - plastic_strain, steel::lambda, G);
        const Matrix3d flown = plastic_flow(plastic_strain, trial, sigma_Y, G);
        const Matrix3d increment = flown - plastic_strain;
        plastic_strain = flown;
        stress = isotropic_stress(strain - plastic_strain, steel::lambda, G);
        dissipation += stress.cwiseProduct(increment).sum();
        ++steps;
    }

    // Strains the point to `target` in n equal steps.
    void strain_to(const Matrix3d& target, int n)
    {
        const Matrix3d start = strain;
        for (int i = 1; i <= n; ++i)
            step(start + (target - start) * i / n);
    }

    // n eps after n steps, relative to the stress that the largest strain would cause without flow.
    Tolerance rounding(double largest_strain) const
    {
        return Rounding(64 + steps, (3 * steel::lambda + 2 * G) * largest_strain);
    }
};

constexpr int counts[] = {1, 2, 7, 100, 1000};

} // namespace

TEST_CASE("plasticity: a steel that cannot thin yields at a strain of 0.1625 %",
          "[A6.8][plasticity]")
{
    // class B: the outcome flips between (1 - d) and (1 + d), d = 1e-12
    MaterialPoint below, above;
    below.step(diagonal(1.625e-3 * (1 - 1e-12), 0, 0));
    above.step(diagonal(1.625e-3 * (1 + 1e-12), 0, 0));
    REQUIRE_THAT(below.plastic_strain, IsExactly(Matrix3d(Matrix3d::Zero())));
    check_that(above.plastic_strain.norm() > 0,
               "plastic strain, where the strain is a little above 0.1625 %");
}

TEST_CASE("plasticity: stretched without thinning and brought back it keeps stresses",
          "[A6.8][plasticity]")
{
    for (const int n : counts) {
        CAPTURE(n);
        MaterialPoint steel_point;
        steel_point.strain_to(diagonal(0.005, 0, 0), n);
        REQUIRE_THAT(steel_point.stress,
                     IsClose(diagonal(1000e6, 750e6, 750e6), steel_point.rounding(0.005)));
        steel_point.strain_to(Matrix3d::Zero(), n);
        REQUIRE_THAT(steel_point.stress, IsClose(diagonal(-500e6 / 3, 250e6 / 3, 250e6 / 3),
                                                 steel_point.rounding(0.005)));
        INFO("it has turned 854166.6667 J/m³ into heat");
        REQUIRE_THAT(steel_point.dissipation,
                     IsClose(2562500 / 3.0, Rounding(64 + steel_point.steps, 1000e6 * 0.005)));
    }
}

TEST_CASE("plasticity: a rod that may thin stays at its yield stress", "[A6.8][plasticity]")
{
    // elastic up to a strain of 0.00125, then flow along (1, -1/2, -1/2) at constant volume
    const Matrix3d elastic = sigma_Y / steel::E * diagonal(1, -steel::nu, -steel::nu);
    for (const int n : counts) {
        CAPTURE(n);
        MaterialPoint rod;
        rod.strain_to(elastic * (1 - 1e-12), n);
        REQUIRE_THAT(rod.plastic_strain, IsExactly(Matrix3d(Matrix3d::Zero())));
        rod.strain_to(elastic + 0.00375 * diagonal(1, -0.5, -0.5), n);
        REQUIRE_THAT(rod.strain(0, 0), IsClose(0.005, Rounding(16)));
        REQUIRE_THAT(rod.stress, IsClose(diagonal(sigma_Y, 0, 0), rod.rounding(0.005)));
        INFO("released it is longer by 0.375 %");
        rod.strain_to(0.00375 * diagonal(1, -0.5, -0.5), n);
        REQUIRE_THAT(rod.stress, IsClose(Matrix3d(Matrix3d::Zero()), rod.rounding(0.005)));
        REQUIRE_THAT(rod.plastic_strain,
                     IsClose(0.00375 * diagonal(1, -0.5, -0.5), Rounding(64 + rod.steps, 0.005)));
        REQUIRE_THAT(rod.dissipation,
                     IsClose(sigma_Y * 0.00375, Rounding(64 + rod.steps, 1000e6 * 0.005)));
    }
}

TEST_CASE("plasticity: sheared to and fro it goes round a parallelogram", "[A6.8][plasticity]")
{
    const double e_Y = tau_Y / (2 * G), e = 5 * e_Y;
    for (const int n : counts) {
        CAPTURE(n);
        MaterialPoint point;
        point.strain_to(shear(e), n);
        REQUIRE_THAT(point.stress, IsClose(shear(tau_Y), point.rounding(e)));
        for (int cycle = 0; cycle < 2; ++cycle) {
            const double before = point.dissipation;
            point.strain_to(shear(-e), n);
            REQUIRE_THAT(point.stress, IsClose(shear(-tau_Y), point.rounding(e)));
            point.strain_to(shear(e), n);
            REQUIRE_THAT(point.stress, IsClose(shear(tau_Y), point.rounding(e)));
            INFO("a cycle costs 8 τ_Y (e - τ_Y/(2 G))");
            REQUIRE_THAT(
                point.dissipation - before,
                IsClose(8 * tau_Y * (e - e_Y), Rounding(64 + point.steps, 50 * tau_Y * e)));
        }
    }
}

TEST_CASE("plasticity: a cycle in a turned frame is the turned cycle", "[A6.8][plasticity]")
{
    for (Random random : seeds(10)) {
        const Matrix3d R = random.rotation();
        MaterialPoint here, there;
        for (int i = 0; i < 10; ++i) {
            const Matrix3d strain = 0.005 * random_symmetric(random);
            here.strain_to(strain, 3);
            there.strain_to(turned(R, strain), 3);
            REQUIRE_THAT(there.stress, IsClose(turned(R, here.stress), here.rounding(0.01)));
        }
        check_at_least(here.dissipation, 0, "the dissipation", 0);
    }
}

} // namespace plasticity_cycle_test
