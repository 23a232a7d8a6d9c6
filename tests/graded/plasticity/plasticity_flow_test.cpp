// SPDX-License-Identifier: MIT
// A6.8: one step of plastic flow.
#include "formulas/plasticity.hpp"
#include "plasticity_cases.hpp"
#include "support/seeds.hpp"

#include <numbers>

namespace plasticity_flow_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::sqrt3;

// The result of one step of flow of a solid with the plastic strain ε_p.
struct Flow {
    Matrix3d increment;  // ε_p_new - ε_p
    Matrix3d new_stress; // σ_new = σ - 2 G (ε_p_new - ε_p)
};

Flow flow(const Matrix3d& sigma, double yield_stress, double G,
          const Matrix3d& plastic_strain = Matrix3d::Zero())
{
    const Matrix3d increment =
        plastic_flow(plastic_strain, sigma, yield_stress, G) - plastic_strain;
    return {increment, sigma - 2 * G * increment};
}

// A random solid under a stress of up to ten times its yield stress.
struct Overloaded {
    Matrix3d plastic_strain, stress;
    double yield_stress, G;
    explicit Overloaded(Random& random)
    {
        plastic_strain = 0.1 * deviator_of(random_symmetric(random));
        stress = random_symmetric(random);
        yield_stress = mises_of(stress) * random.uniform(0.1, 0.9);
        G = random.uniform(0.5, 5);
    }
    // Scales of the rounding of a stress and of a strain.
    double stress_scale() const { return stress.norm() + 2 * G * plastic_strain.norm(); }
    double strain_scale() const { return stress.norm() / (2 * G) + plastic_strain.norm(); }
};

} // namespace

TEST_CASE("plasticity: below the yield surface nothing flows", "[A6.8][plasticity]")
{
    for (Random random : seeds(100)) {
        const Overloaded solid(random);
        const double strong = mises_of(solid.stress) * (1 + 1e-12);

        REQUIRE_THAT(plastic_flow(solid.plastic_strain, solid.stress, strong, solid.G),
                     IsExactly(solid.plastic_strain));
    }
}

TEST_CASE("plasticity: a rod pulled with three times its yield stress", "[A6.8][plasticity]")
{
    // R turns the rod, which lies along x. f = 2 σ_Y, γ = 2 σ_Y/(3 G), along (1, -1/2, -1/2)
    const auto check = [](const Matrix3d& R, double yield_stress, double G) {
        const double gamma = 2 * yield_stress / (3 * G);
        const Matrix3d stress = turned(R, yield_stress * diagonal(3, 0, 0));
        const Matrix3d increment = turned(R, gamma * diagonal(1, -0.5, -0.5));
        const Matrix3d left = turned(R, yield_stress / 3 * diagonal(5, 2, 2));
        const Flow pulled = flow(stress, yield_stress, G);
        REQUIRE_THAT(pulled.increment, IsClose(increment, Rounding(16, 3 * gamma)));
        INFO("the pressure of σ_Y stays, and f = 0");
        REQUIRE_THAT(pulled.new_stress, IsClose(left, Rounding(16, 3 * yield_stress)));
        INFO("pushed, it flows the other way");
        const Flow pushed = flow(-stress, yield_stress, G);
        REQUIRE_THAT(pushed.increment, IsClose(Matrix3d(-increment), Rounding(16, 3 * gamma)));
    };
    check(Matrix3d::Identity(), 1, 2);
    for (Random random : seeds(5)) {
        const double yield_stress = random.uniform(0.5, 2), G = random.uniform(0.5, 5);
        check(random.rotation(), yield_stress, G);
    }
}

TEST_CASE("plasticity: shear flows as shear", "[A6.8][plasticity]")
{
    // f = √3·2 - √3 = √3 and γ = √3/(3·0.5). The increment in xy and in yx is γ √3/2 = 1, so that τ
    // = 1 is left.
    const Flow sheared = flow(shear(2), sqrt3, 0.5);
    REQUIRE_THAT(sheared.increment, IsClose(shear(1), Rounding(16, 2)));
    REQUIRE_THAT(sheared.new_stress, IsClose(shear(1), Rounding(16, 2)));
}

TEST_CASE("plasticity: after the flow the stress is on the yield surface", "[A6.8][plasticity]")
{
    for (Random random : seeds(100)) {
        const Overloaded solid(random);

        const Flow step = flow(solid.stress, solid.yield_stress, solid.G, solid.plastic_strain);

        REQUIRE_THAT(mises_of(step.new_stress),
                     IsClose(solid.yield_stress, Rounding(32, solid.stress_scale())));
        INFO("the volume does not flow, so the pressure stays");
        REQUIRE_THAT(step.increment.trace(), IsClose(0.0, Rounding(32, solid.strain_scale())));
        REQUIRE_THAT(step.new_stress.trace(),
                     IsClose(solid.stress.trace(), Rounding(64, solid.stress_scale())));
        INFO("a second step has nothing left to do");
        const Flow again = flow(step.new_stress, solid.yield_stress, solid.G,
                                solid.plastic_strain + step.increment);
        REQUIRE_THAT(again.increment,
                     IsClose(Matrix3d(Matrix3d::Zero()), Rounding(64, solid.strain_scale())));
    }
}

TEST_CASE("plasticity: the flow is along the deviator and as long as f asks for",
          "[A6.8][plasticity]")
{
    for (Random random : seeds(100)) {
        const Overloaded solid(random);
        const Matrix3d s = deviator_of(solid.stress);
        const double gamma = (mises_of(solid.stress) - solid.yield_stress) / (3 * solid.G);

        const Flow step = flow(solid.stress, solid.yield_stress, solid.G, solid.plastic_strain);

        INFO("γ = f/(3 G), and √(3/2) dev σ/‖dev σ‖ has the norm √(3/2)");
        REQUIRE_THAT(step.increment, IsClose(Matrix3d(gamma * std::sqrt(1.5) * s / s.norm()),
                                             Rounding(32, solid.strain_scale())));
    }
}

TEST_CASE("plasticity: no stress inside the yield surface would do more work on the flow",
          "[A6.8][plasticity]")
{
    for (Random random : seeds(100)) {
        const Overloaded solid(random);
        const Flow step = flow(solid.stress, solid.yield_stress, solid.G, solid.plastic_strain);

        for (int i = 0; i < 10; ++i) {
            Matrix3d other = random_symmetric(random);
            other *= random.uniform(0, solid.yield_stress / mises_of(other));
            const double work = step.new_stress.cwiseProduct(step.increment).sum(),
                         less = other.cwiseProduct(step.increment).sum();
            check_at_most(less, work, "the work of another stress",
                          64 * (solid.stress_scale() + other.norm()) * solid.strain_scale());
        }
    }
}

TEST_CASE("plasticity: an isotropic solid flows alike in every frame", "[A6.8][plasticity]")
{
    for (Random random : seeds(100)) {
        const Overloaded solid(random);
        const Matrix3d R = random.rotation();
        const Matrix3d here =
            plastic_flow(solid.plastic_strain, solid.stress, solid.yield_stress, solid.G);
        const Matrix3d there = plastic_flow(turned(R, solid.plastic_strain),
                                            turned(R, solid.stress), solid.yield_stress, solid.G);

        REQUIRE_THAT(there, IsClose(turned(R, here), Rounding(64, solid.strain_scale())));
        REQUIRE_THAT(Matrix3d(here.transpose()), IsClose(here, Rounding(32, solid.strain_scale())));
    }
}

TEST_CASE("plasticity: pressure alone never yields", "[A6.8][plasticity]")
{
    Random random(1);
    const Matrix3d plastic_strain = deviator_of(random_symmetric(random));
    for (const double p : {-1e12, -1.0, 0.1, 1e6, 1e12}) {
        CAPTURE(p);
        REQUIRE_THAT(plastic_flow(plastic_strain, p * Matrix3d::Identity(), 1e-2, 1e9),
                     IsExactly(plastic_strain));
    }
}

TEST_CASE("plasticity: a solid without strength keeps nothing but its pressure",
          "[A6.8][plasticity]")
{
    for (Random random : seeds(20)) {
        const Matrix3d stress = random_symmetric(random);
        const Matrix3d pressure = stress.trace() / 3 * Matrix3d::Identity();

        REQUIRE_THAT(flow(stress, 0, 2).new_stress, IsClose(pressure, Rounding(32, stress.norm())));
    }
    const Matrix3d kept = diagonal(2, -1, -1);
    REQUIRE_THAT(plastic_flow(kept, Matrix3d::Zero(), 0, 2), IsExactly(kept));
}

TEST_CASE("plasticity: a solid without stiffness stays as it is", "[A6.8][plasticity]")
{
    const Matrix3d kept = diagonal(2, -1, -1);
    REQUIRE_THAT(plastic_flow(kept, diagonal(3, 0, 0), 1, 0), IsExactly(kept));
    REQUIRE_THAT(plastic_flow(kept, Matrix3d::Zero(), 0, 0), IsExactly(kept));
    REQUIRE_THAT(plastic_flow(kept, Matrix3d::Zero(), 1, 1), IsExactly(kept));
}

TEST_CASE("plasticity: soft jelly and hard steel flow alike", "[A6.8][plasticity]")
{
    for (const double unit : {1e-100, 1e-9, 1e9, 1e100}) {
        CAPTURE(unit);
        const Matrix3d increment =
            plastic_flow(Matrix3d::Zero(), diagonal(3 * unit, 0, 0), unit, 2 * unit);
        REQUIRE_THAT(increment, IsClose(diagonal(1, -0.5, -0.5) / 3, Rounding(16, 1)));
    }
}

TEST_CASE("plasticity: a stress just above the yield surface flows just a little",
          "[A6.8][plasticity]")
{
    // f = d is exact in binary, so γ = d/(3 G) up to the rounding of f
    for (const double d : {0x1p-10, 0x1p-20, 0x1p-30}) {
        CAPTURE(d);
        REQUIRE_THAT(flow(diagonal(1 + d, 0, 0), 1, 2).increment,
                     IsClose(d / 6 * diagonal(1, -0.5, -0.5), Rounding(16, 1)));
    }
}

TEST_CASE("plasticity: the von Mises stress decides and no single entry", "[A6.8][plasticity]")
{
    // deviators whose largest entry is nearly as large as the von Mises stress, or far smaller
    for (const Vector3d& d : {Vector3d(0, 0, 0), Vector3d(1, -1, 0), Vector3d(1, 1, -2),
                              Vector3d(-2, 1, 1), Vector3d(0, 0.25, -0.25)})
        for (int shears = 0; shears < 27; ++shears)
            for (const double pressure : {0.0, 2.0}) {
                Matrix3d sigma = (d + pressure * Vector3d::Ones()).asDiagonal();
                sigma(0, 1) = sigma(1, 0) = shears % 3 - 1;
                sigma(1, 2) = sigma(2, 1) = shears / 3 % 3 - 1;
                sigma(2, 0) = sigma(0, 2) = shears / 9 - 1;
                const double mises = mises_of(sigma);
                if (mises == 0) continue;
                for (const double excess : {1e-9, 1e-6, 1e-3, 0.02, 0.1, 0.3}) {
                    CAPTURE(sigma, excess);
                    const Matrix3d before = Matrix3d::Zero();
                    REQUIRE_THAT(plastic_flow(before, sigma, mises * (1 + excess), 1),
                                 IsExactly(before));
                    const Flow flowed = flow(sigma, mises / (1 + excess), 1);
                    REQUIRE_THAT(mises_of(flowed.new_stress),
                                 IsClose(mises / (1 + excess), Rounding(128, sigma.norm())));
                }
            }
}

} // namespace plasticity_flow_test
