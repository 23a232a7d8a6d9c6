// SPDX-License-Identifier: MIT
// A2.11 and A2.12: integrals over a body by a regular grid and by the Monte Carlo method.
#include "formulas/inertia.hpp"
#include "support/close.hpp"
#include "support/mass_properties.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

// The cell centers of a cube of edge a [m] about `center`, with n cells along each edge.
std::vector<DensitySample> cube_of_cells(double a, int n, const Vector3d& center, double density)
{
    std::vector<DensitySample> samples;
    const auto at = [&](int i) { return a * ((i + 0.5) / n - 0.5); };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k)
                samples.push_back({center + Vector3d(at(i), at(j), at(k)), density});
    return samples;
}

// Uniform random points of the cube [-1, 1]³, with density 1 in the unit ball and 0 outside.
std::vector<DensitySample> ball_in_a_box(Random& random, int n)
{
    std::vector<DensitySample> samples;
    for (int i = 0; i < n; ++i) {
        const Vector3d p = random.vector();
        samples.push_back({p, p.norm() <= 1 ? 1.0 : 0.0});
    }
    return samples;
}

// Uniform random points of the unit ball, or of a unit cube.
std::vector<DensitySample> full_samples(Random& random, int n, bool ball)
{
    std::vector<DensitySample> samples;
    while (static_cast<int>(samples.size()) < n) {
        const Vector3d p = random.vector();
        if (!ball) samples.push_back({p / 2, 1});
        if (ball && p.norm() <= 1) samples.push_back({p, 1});
    }
    return samples;
}

// The standard deviation σ of y² + z² for one sample. The mean of y² + z² is Ixx/M.
constexpr double sigma_ball =
    0.261861468283191; // radius 1 [m²]: √(3/7 · 8/15 - (2/5)²) = √(12/175)
constexpr double sigma_cube = 0.105409255338946; // edge 1: √(1/90)

} // namespace

TEST_CASE("inertia: a grid of a cube is short by one over n squared", "[A2.11][inertia]")
{
    const double a = 2, density = 3, M = density * a * a * a;
    const Vector3d X(1, -2, 0.5);
    std::vector<double> errors;
    for (const int n : {4, 8, 16}) {
        CAPTURE(n);
        const double h = a / n;

        const MassProperties found = grid_mass_properties(cube_of_cells(a, n, X, density), h);

        const Matrix3d exact = M * a * a / 6 * Matrix3d::Identity();
        require_mass_properties(found, {M, X, exact * (1 - 1.0 / (n * n))}, X.norm() + a,
                                8 * n); // the rounding of n³ terms adds up
        INFO("with each cell's own inertia it is exact");
        REQUIRE_THAT(Matrix3d(found.inertia + M * h * h / 6 * Matrix3d::Identity()),
                     IsClose(exact, Rounding(8 * n, M * (X.norm() + a) * (X.norm() + a))));
        errors.push_back((found.inertia - exact).norm());
    }
    check_order(errors, 2);
}

TEST_CASE("inertia: a grid of a cube that grows denser converges to second order",
          "[A2.11][inertia]")
{
    // unit cube, ρ = 1 + x for x in 0 … 1: M = 3/2, X = (5/9, ½, ½), Iyy = 7/12 - 25/54 + 1/8
    const Vector3d X(5.0 / 9, 0.5, 0.5);
    std::vector<double> center_errors, inertia_errors;
    for (const int n : {4, 8, 16}) {
        std::vector<DensitySample> samples = cube_of_cells(1, n, Vector3d(0.5, 0.5, 0.5), 0);
        for (DensitySample& sample : samples)
            sample.density = 1 + sample.position.x();

        const MassProperties found = grid_mass_properties(samples, 1.0 / n);

        REQUIRE_THAT(found.mass, IsClose(1.5, Rounding(8 * n, 1.5)));
        center_errors.push_back((found.center_of_mass - X).norm());
        inertia_errors.push_back(std::abs(found.inertia(1, 1) - 53.0 / 216));
    }
    check_order(center_errors, 2);
    check_order(inertia_errors, 2);
    check_at_most(inertia_errors.back(), 1e-3, "error of Iyy with 16 cells an edge");
}

TEST_CASE("inertia: two cells of different density", "[A2.11][inertia]")
{
    // cells of edge h = 2 have the masses 8 and 24
    const MassProperties expected{32, Vector3d(3, 0, 0), Vector3d(0, 96, 96).asDiagonal()};

    const MassProperties found =
        grid_mass_properties({{Vector3d(0, 0, 0), 1}, {Vector3d(4, 0, 0), 3}}, 2);

    require_mass_properties(found, expected, 4, 8);
}

TEST_CASE("inertia: a grid may have gaps, and its cells may be in any order", "[A2.11][inertia]")
{
    // rows of cells along each axis, of which some are not listed
    for (Random random : seeds(60)) {
        const int axis = random_index(random, 3), n = 3 + random_index(random, 12);
        const double h = 0.5;
        std::vector<DensitySample> cells;
        double mass = 0, first = 0, second = 0; // Σ m, Σ m s, Σ m s², where s is along the axis
        for (int i = 0; i < n; ++i) {
            if (random_index(random, 3) == 0) continue;
            const double s = h * i;
            cells.push_back({s * Vector3d::Unit(axis), 8});
            mass += 1;
            first += s;
            second += s * s;
        }
        if (cells.empty()) continue;
        if (n % 2 == 0) std::reverse(cells.begin(), cells.end());
        const double across = second - first * first / mass;
        Vector3d moments(across, across, across);
        moments[axis] = 0;
        const MassProperties expected{mass, first / mass * Vector3d::Unit(axis),
                                      moments.asDiagonal()};
        CAPTURE(axis, n, cells.size());
        require_mass_properties(grid_mass_properties(cells, h), expected, h * n, 64);
    }
}

TEST_CASE("inertia: a grid of nothing is nothing", "[A2.11][inertia]")
{
    REQUIRE_THAT(grid_mass_properties({}, 0.1), IsExactly(MassProperties{}));
    REQUIRE_THAT(grid_mass_properties(cube_of_cells(1, 2, Vector3d(1, 2, 3), 0), 0.5),
                 IsExactly(MassProperties{}));
    INFO("cells without size");
    REQUIRE_THAT(grid_mass_properties(cube_of_cells(1, 2, Vector3d(1, 2, 3), 5), 0),
                 IsExactly(MassProperties{}));
}

TEST_CASE("inertia: each sample stands for its share of the volume", "[A2.12][inertia]")
{
    // V/N = 8/4, so that each of the two samples of density 3 weighs 6 kg
    const std::vector<DensitySample> samples = {{Vector3d(2, 5, 0), 3},
                                                {Vector3d(0, 5, 0), 3},
                                                {Vector3d(9, 9, 9), 0},
                                                {Vector3d(-9, 9, 9), 0}};
    const MassProperties expected{12, Vector3d(1, 5, 0), Vector3d(0, 12, 12).asDiagonal()};

    require_mass_properties(sampled_mass_properties(samples, 8), expected, 5, 8);
}

TEST_CASE("inertia: no sample or no hit is nothing", "[A2.12][inertia]")
{
    REQUIRE_THAT(sampled_mass_properties({}, 8), IsExactly(MassProperties{}));
    REQUIRE_THAT(sampled_mass_properties({{Vector3d(1, 2, 3), 0}, {Vector3d(3, 2, 1), 0}}, 8),
                 IsExactly(MassProperties{}));
    INFO("a region without volume");
    REQUIRE_THAT(sampled_mass_properties({{Vector3d(1, 2, 3), 5}, {Vector3d(3, 2, 1), 5}}, 0),
                 IsExactly(MassProperties{}));
}

TEST_CASE("inertia: random samples estimate the mass of a ball", "[A2.12][inertia]")
{
    const int n = 4000;
    const double hit = std::numbers::pi / 6; // the ball's share of its box of 8 m³
    for (Random random : seeds(10)) {
        const MassProperties found = sampled_mass_properties(ball_in_a_box(random, n), 8);

        REQUIRE_THAT(found.mass, IsClose(8 * hit, Statistical(8 * std::sqrt(hit * (1 - hit)), n)));
    }
}

TEST_CASE("inertia: random samples estimate the inertia of a ball and of a cube",
          "[A2.12][inertia]")
{
    const int n = 4000;
    for (Random random : seeds(10)) {
        const MassProperties ball = sampled_mass_properties(full_samples(random, n, true), 1);
        const MassProperties cube = sampled_mass_properties(full_samples(random, n, false), 1);

        REQUIRE_THAT(ball.inertia,
                     IsClose(Matrix3d(2.0 / 5 * Matrix3d::Identity()), Statistical(sigma_ball, n)));
        REQUIRE_THAT(cube.inertia,
                     IsClose(Matrix3d(1.0 / 6 * Matrix3d::Identity()), Statistical(sigma_cube, n)));
    }
}

TEST_CASE("inertia: the error of random samples falls as one over the root of their number",
          "[A2.12][inertia]")
{
    const unsigned runs = 100;
    for (const int n : {100, 1600}) {
        CAPTURE(n);
        double sum = 0;
        for (unsigned run = 0; run < runs; ++run) {
            Random random(first_seed() + run);
            const MassProperties cube = sampled_mass_properties(full_samples(random, n, false), 1);
            sum += std::pow(cube.inertia(0, 0) - 1.0 / 6, 2);
        }
        // the root mean square of 100 runs has itself a relative σ of √½ / √100
        const double ratio = std::sqrt(sum / runs) / (sigma_cube / std::sqrt(n));
        REQUIRE_THAT(ratio, IsClose(1.0, Statistical(std::sqrt(0.5), runs)));
    }
}
