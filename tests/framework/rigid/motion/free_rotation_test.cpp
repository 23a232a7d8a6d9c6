// SPDX-License-Identifier: MIT
// Compares the closed solution of free rotation with a Taylor series of order 22 in extended
// precision, over strata (classes) of moments, angular velocities and times. The allowed error is
// the effect of rounding the arguments, found by changing them a little: near the unstable axis a
// small change grows with each flip.
#include "rigid/motion/free_rotation.hpp"

#include "framework/rigid/worlds.hpp"
#include "support/free_rotor.hpp"

#include <algorithm>
#include <array>

namespace free_rotation {

using namespace rigor;
using namespace rigor::testing;

namespace {

using Extended = long double;
constexpr int order = 22;

// Angular momentum in the frame of the body, and orientation, scalar part first.
struct Rotor {
    std::array<Extended, 3> M;
    std::array<Extended, 4> q;
};

using Series = std::array<Extended, order + 1>;

Extended sum(const Series& series, Extended t)
{
    Extended x = 0;
    for (int n = order; n >= 0; --n)
        x = x * t + series[n];
    return x;
}

// Ṁ = M × ω, q̇ = ½ q (0, ω), with ω = J M in the frame of the body.
void advance(Rotor& rotor, const std::array<Extended, 3>& J, Extended t)
{
    std::array<Series, 3> M{};
    std::array<Series, 4> q{};
    for (int i = 0; i < 3; ++i)
        M[i][0] = rotor.M[i];
    for (int i = 0; i < 4; ++i)
        q[i][0] = rotor.q[i];
    for (int n = 0; n < order; ++n)
        for (int k = 0; k <= n; ++k) {
            const Extended x = J[0] * M[0][n - k], y = J[1] * M[1][n - k], z = J[2] * M[2][n - k];
            const Extended half = Extended(0.5) / (n + 1);
            M[0][n + 1] += (M[1][k] * z - M[2][k] * y) / (n + 1);
            M[1][n + 1] += (M[2][k] * x - M[0][k] * z) / (n + 1);
            M[2][n + 1] += (M[0][k] * y - M[1][k] * x) / (n + 1);
            q[0][n + 1] += half * (-q[1][k] * x - q[2][k] * y - q[3][k] * z);
            q[1][n + 1] += half * (q[0][k] * x + q[2][k] * z - q[3][k] * y);
            q[2][n + 1] += half * (q[0][k] * y + q[3][k] * x - q[1][k] * z);
            q[3][n + 1] += half * (q[0][k] * z + q[1][k] * y - q[2][k] * x);
        }
    for (int i = 0; i < 3; ++i)
        rotor.M[i] = sum(M[i], t);
    for (int i = 0; i < 4; ++i)
        rotor.q[i] = sum(q[i], t);
}

struct Case {
    Vector3d J, L; // inverse moments, angular momentum in the principal frame
    double time = 0;

    // The time times a bound on the angular velocities of the body and of M [rad].
    double phase() const
    {
        return std::sqrt(L.dot(J.cwiseProduct(L)) * J.maxCoeff()) * std::abs(time);
    }
};

Eigen::Quaterniond by_series(const Case& c)
{
    Rotor rotor{{c.L[0], c.L[1], c.L[2]}, {1, 0, 0, 0}};
    const int steps = 1 + static_cast<int>(c.phase() / 0.5);
    for (int i = 0; i < steps; ++i)
        advance(rotor, {c.J[0], c.J[1], c.J[2]}, static_cast<Extended>(c.time) / steps);
    const auto d = [&](int i) { return static_cast<double>(rotor.q[i]); };
    return Eigen::Quaterniond(d(0), d(1), d(2), d(3)).normalized();
}

Eigen::Quaterniond in_closed_form(const Case& c)
{
    const Vector3d turned = c.time * mean_free_angular_velocity(c.J, c.L, c.time);
    const double angle = turned.norm();
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, turned / angle));
}

// How far rounding of the arguments can move the result [rad].
double effect_of_rounding(const Case& c, const Eigen::Quaterniond& exact)
{
    constexpr double change = 1e-11; // far above the rounding of the quaternion
    double most = 1;
    for (int k = 0; k < 3; ++k) {
        Case moved = c;
        moved.L[k] += change * c.L.norm();
        most = std::max(most, rotation_angle(by_series(moved), exact) / change);
        moved = c;
        moved.J[k] *= 1 + change;
        most = std::max(most, rotation_angle(by_series(moved), exact) / change);
    }
    return std::numeric_limits<double>::epsilon() * most;
}

// Moments of a body with the second moments s of its mass along its axes.
Vector3d moments(const Vector3d& s)
{
    return {s.y() + s.z(), s.z() + s.x(), s.x() + s.y()};
}

constexpr const char* strata[] = {"generic",       "on the separatrix", "about a principal axis",
                                  "nearly oblate", "nearly prolate",    "rod",
                                  "flat",          "nearly a sphere",   "slow"};

Case drawn(int stratum, Random& random)
{
    const auto power = [&](double low, double high) {
        return std::pow(10, random.uniform(low, high));
    };
    Vector3d s(random.uniform(0.1, 1), random.uniform(0.1, 1), random.uniform(0.1, 1));
    if (stratum == 3) s[1] = s[0] * (1 + power(-15, -2));
    if (stratum == 4) s = Vector3d(0.2, 0.1, 0.1 * (1 + power(-15, -2)));
    if (stratum == 5) s = Vector3d(power(-8, -1), power(-8, -1), 1);
    if (stratum == 6) s[0] *= power(-12, -1);
    if (stratum == 7) s = Vector3d(1, 1 + power(-14, -2), 1 - power(-14, -2));
    Case c;
    c.J = (power(-6, 6) * moments(s)).cwiseInverse();
    std::array<int, 3> a{0, 1, 2};
    std::sort(a.begin(), a.end(), [&](int i, int j) { return c.J[i] > c.J[j]; });

    Vector3d M = random.vector();
    if (stratum == 1)
        M[a[2]] = M[a[0]] * std::sqrt((c.J[a[0]] - c.J[a[1]]) / (c.J[a[1]] - c.J[a[2]])) *
                  (1 + random.uniform(-1, 1) * power(-16, -1));
    if (stratum == 2) {
        const int axis = static_cast<int>(random.uniform(0, 2.999));
        M = power(-16, -1) * M + Vector3d::Unit(axis);
    }
    c.time = power(-5, 3);
    const double phase = stratum == 8 ? power(-9, -3) : power(-3, 2);
    c.L = M;
    c.L *= phase / c.phase();
    if (random.uniform(0, 1) < 0.2) c.time = -c.time;
    return c;
}

void check_strata(unsigned seeds)
{
    for (int stratum = 0; stratum < static_cast<int>(std::size(strata)); ++stratum)
        for (unsigned seed = 0; seed < seeds; ++seed) {
            CAPTURE(strata[stratum], seed);
            Random random(seed);
            const Case c = drawn(stratum, random);
            const Eigen::Quaterniond exact = by_series(c);
            const double error = rotation_angle(in_closed_form(c), exact);
            REQUIRE(error <= 8 * effect_of_rounding(c, exact));
            if (stratum == 0) REQUIRE(error < 1e-13);
        }
}

} // namespace

TEST_CASE("free rotation: the closed form is exact to rounding in every stratum", "[rigid]")
{
    check_strata(12);
}

TEST_CASE("free rotation: the closed form is exact to rounding in the long sweep", "[.long]")
{
    check_strata(2000);
}

TEST_CASE("free rotation: what rests on an axis rotates by its angular velocity", "[rigid]")
{
    const Vector3d J(3, 2, 1);
    for (int axis = 0; axis < 3; ++axis)
        for (const double size : {1e-200, 1., 1e100}) {
            const Vector3d L = size * Vector3d::Unit(axis);
            CHECK_THAT(mean_free_angular_velocity(J, L, 0.5 / size),
                       IsClose(Vector3d(J.cwiseProduct(L)), Rounding(8)));
        }
    CHECK_THAT(mean_free_angular_velocity(J, {0, 0, 0}, 1), IsClose(Vector3d(0, 0, 0), Exactly()));
    const Vector3d L(1, -2, 3);
    CHECK_THAT(mean_free_angular_velocity({2, 2, 2}, L, 1), IsClose(Vector3d(2 * L), Exactly()));
    CHECK_THAT(mean_free_angular_velocity({0, 0, 0}, L, 1), IsClose(Vector3d(0, 0, 0), Exactly()));
}

TEST_CASE("flight: a body that only gravity acts on is exact in one step of any size", "[rigid]")
{
    const Vector3d omega(1, 2, 3), V(4, 5, 6);
    for (const double end : {0.01, 1., 10.})
        for (const int steps : {1, 7, 100}) {
            CAPTURE(end, steps);
            World world = world_of({free_box(omega)});
            world.bodies[0].state.velocity = V;
            run(world, steps, end / steps);
            const RigidState& state = world.bodies[0].state;
            CHECK(rotation_angle(eigen(state.orientation),
                                 FreeRotor(free_moments, omega).orientation(end)) < 1e-13);
            const Vector3d fallen(0, -g / 2 * end * end, 0);
            CHECK_THAT(state.position,
                       IsClose(Vector3d(end * V + fallen), Rounding(4. * steps, 5000)));
            CHECK(world.counters.substeps == 0);
        }
}

TEST_CASE("flight: a body with turned principal axes is as exact as one along them", "[rigid]")
{
    const Quaternion q = turn({1, -2, 3}, 0.8);
    const Matrix3d R = rotation_matrix(q);
    const Vector3d omega(1, 2, 3);
    RigidBody along = free_box(omega), turned = along;
    set_mass(turned, along.mass, R.transpose() * along.inertia * R);
    turned.state.orientation = q;
    World world = world_of({along, turned});
    run(world, 10, 1);
    const Matrix3d difference = rotation_matrix(world.bodies[0].state.orientation) * R -
                                rotation_matrix(world.bodies[1].state.orientation);
    CHECK(difference.norm() < 1e-13);
}

} // namespace free_rotation
