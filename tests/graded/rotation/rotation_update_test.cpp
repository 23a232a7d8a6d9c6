// SPDX-License-Identifier: MIT
// A3.11 to A3.14: updates of the orientation, the longest time step, and gravity.
#include "formulas/rotation.hpp"
#include "rotation_cases.hpp"
#include "support/close.hpp"
#include "support/seeds.hpp"

#include <limits>
#include <numbers>

using namespace rigor;
using namespace rigor::testing;

namespace {

using std::numbers::pi;
const Quaternion identity = {1, {0, 0, 0}};

} // namespace

TEST_CASE("rotation: the exact update makes a quarter turn about z", "[A3.11][rotation]")
{
    const Quaternion expected = {std::sqrt(0.5), {0, 0, std::sqrt(0.5)}};
    REQUIRE_THAT(advance_exact(identity, {0, 0, pi}, 0.5), IsClose(expected, Rounding(8, 1)));
}

TEST_CASE("rotation: the exact update turns by ωΔt in world space", "[A3.11][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = random.quaternion();
        const Vector3d w = 10 * random.vector();
        const double h = random.uniform(0, 2);
        const Quaternion expected = plain(turn(h * w) * eigen(q));
        REQUIRE_THAT(advance_exact(q, w, h), IsClose(expected, Rounding(16, 1 + h * w.norm())));
    }
}

TEST_CASE("rotation: under constant ω one exact step is as good as many", "[A3.11][rotation]")
{
    const Vector3d w(0.3, -0.2, 0.6); // |ω| = 0.7: 70 rad in 100 s
    const int n = 1000;
    Quaternion q = identity;
    for (int i = 0; i < n; ++i)
        q = advance_exact(q, w, 0.1);
    const Quaternion expected = plain(turn(100 * w));
    REQUIRE_THAT(advance_exact(identity, w, 100), IsClose(expected, Rounding(16, 71)));
    REQUIRE_THAT(q, IsClose(expected, Rounding(16, n)));
}

TEST_CASE("rotation: the exact update keeps the length", "[A3.11][rotation]")
{
    const int n = 2000;
    Random random(7);
    Quaternion q = identity;
    for (int i = 0; i < n; ++i)
        q = advance_exact(q, 20 * random.vector(), 0.05);
    REQUIRE_THAT(length(q), IsClose(1.0, Rounding(n)));
}

TEST_CASE("rotation: an exact step back undoes a step", "[A3.11][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = random.quaternion();
        const Vector3d w = 10 * random.vector();
        const double h = random.uniform(0, 2);
        const Quaternion back = advance_exact(advance_exact(q, w, h), w, -h);
        REQUIRE_THAT(back, IsClose(q, Rounding(32, 1 + h * w.norm())));
    }
}

TEST_CASE("rotation: at rest the exact update changes nothing", "[A3.11][rotation]")
{
    const Quaternion q = {0.1, {-0.7, 0.5, 0.5}};
    REQUIRE_THAT(advance_exact(q, {0, 0, 0}, 0.1), IsClose(q, Rounding(8, 1)));
    REQUIRE_THAT(advance_exact(q, {3, -2, 1}, 0), IsClose(q, Rounding(8, 1)));
}

TEST_CASE("rotation: the exact update is smooth as ω goes to 0", "[A3.11][rotation]")
{
    const Vector3d axis = Vector3d(2, -3, 6) / 7;
    const double h = 0.5;
    for (int power = 0; power <= 150; ++power) {
        const double speed = std::pow(10.0, -power);
        CAPTURE(speed);
        const Quaternion q = advance_exact(identity, speed * axis, h);
        const Quaternion expected = {std::cos(speed * h / 2), std::sin(speed * h / 2) * axis};
        REQUIRE_THAT(q, IsClose(expected, Rounding(16)));
    }
    // speeds whose square underflows, down to the smallest positive number
    for (double speed : {1e-160, 1e-170, 1e-250, 1e-307, 1e-310, 1e-322, 5e-324}) {
        CAPTURE(speed);
        REQUIRE_THAT(advance_exact(identity, speed * axis, h), IsClose(identity, Rounding(1, 1)));
    }
}

TEST_CASE("rotation: ω held over each step feeds the box energy up to its maximum",
          "[A3.11][rotation]")
{
    // The lecture's first-order update of a torque-free box, with L exact. The energy slowly rises
    // from 49 J to L²/(2 I_min) = 794/10 J, where the box turns about its axis of least inertia.
    const BodyInertia body = box();
    RigidState state = spinning_box({1, 2, 3});
    const Vector3d& L = state.angular_momentum;
    double energy = kinetic_energy_of_rotation(body, state);
    for (int i = 0; i < 1000; ++i) {
        const Vector3d w = world_inverse(body, state.orientation) * L;
        state.orientation = advance_exact(state.orientation, w, 0.1);
        const double next = kinetic_energy_of_rotation(body, state);
        check_at_most(energy, next, "the energy before a step", 32 * energy);
        energy = next;
    }
    REQUIRE_THAT(energy / 49, IsClose(1.62040816326531, Order(1e-10)));
}

TEST_CASE("rotation: the linear update turns by 2 atan(|ω|Δt/2)", "[A3.12][rotation]")
{
    const auto angle = [](const Quaternion& q) { return 2 * std::atan2(q.v.norm(), q.s); };
    const Vector3d w = Vector3d(2, -3, 6) / 7; // |ω| = 1
    REQUIRE_THAT(angle(advance_linear(identity, w, 0.1)),
                 IsClose(0.0999167914438855, Rounding(16)));
    REQUIRE_THAT(angle(advance_linear(identity, w, 1)), IsClose(0.927295218001612, Rounding(16)));
    // the angle is at most half a turn, however long the step is
    REQUIRE_THAT(angle(advance_linear(identity, w, 2e6)),
                 IsClose(2 * std::atan(1e6), Rounding(16)));
}

TEST_CASE("rotation: the linear update turns about ω in world space", "[A3.12][rotation]")
{
    for (Random random : seeds(100)) {
        const Quaternion q = random.quaternion();
        const Vector3d axis = random.unit_vector();
        const double speed = random.uniform(0, 10), h = random.uniform(0, 1);
        const Vector3d by = 2 * std::atan(speed * h / 2) * axis;
        const Quaternion expected = plain(turn(by) * eigen(q));
        REQUIRE_THAT(advance_linear(q, speed * axis, h), IsClose(expected, Rounding(64, 1)));
    }
}

TEST_CASE("rotation: the linear update gives a unit quaternion", "[A3.12][rotation]")
{
    Random random(11);
    Quaternion q = identity;
    for (int i = 0; i < 1000; ++i) {
        q = advance_linear(q, 20 * random.vector(), 0.05);
        REQUIRE_THAT(length(q), IsClose(1.0, Rounding(32)));
    }
}

TEST_CASE("rotation: about a fixed axis the linear update is of second order", "[A3.12][rotation]")
{
    const Vector3d w(1.2, 0, 1.6);
    std::vector<double> errors;
    for (int n : {20, 40, 80}) {
        Quaternion q = identity;
        for (int i = 0; i < n; ++i)
            q = advance_linear(q, w, 1.0 / n);
        errors.push_back(turn_between(eigen(q), turn(w)).norm());
    }
    check_order(errors, 2);
    REQUIRE_THAT(errors.back(), IsClose(0.0, Order(2e-4)));
}

TEST_CASE("rotation: at rest the linear update changes nothing", "[A3.12][rotation]")
{
    const Quaternion q = {0.1, {-0.7, 0.5, 0.5}};
    REQUIRE_THAT(advance_linear(q, {0, 0, 0}, 0.1), IsClose(q, Rounding(8, 1)));
}

TEST_CASE("rotation: the longest step makes a quarter turn", "[A3.13][rotation]")
{
    for (Random random : seeds(100)) {
        const Vector3d w = random.mass() * random.unit_vector();
        REQUIRE_THAT(max_time_step(w) * w.norm(), IsClose(pi / 2, Rounding(32)));
    }
}

TEST_CASE("rotation: 10 rad take seven steps", "[A3.13][rotation]")
{
    const Vector3d w(0, 60, 80);
    const double h = 0.1;
    REQUIRE_THAT(std::ceil(h / max_time_step(w)), IsExactly(7.0));
}

TEST_CASE("rotation: components that cancel are no rest", "[A3.13][rotation]")
{
    for (const double x : {-2, -1, 0, 1, 2})
        for (const double y : {-2, -1, 0, 1, 2})
            for (const double z : {-2, -1, 0, 1, 2}) {
                const Vector3d w(x, y, z);
                CAPTURE(w);
                if (w.isZero(0)) continue;
                REQUIRE_THAT(max_time_step(w) * w.norm(), IsClose(pi / 2, Rounding(8)));
            }
}

TEST_CASE("rotation: a body at rest has no longest step", "[A3.13][rotation]")
{
    const double infinity = std::numeric_limits<double>::infinity();
    REQUIRE_THAT(max_time_step({0, 0, 0}), IsExactly(infinity));
}

TEST_CASE("rotation: gravity pulls with M g", "[A3.14][rotation]")
{
    const Wrench expected = {{0, -19.62, 0}, {0, 0, 0}};
    REQUIRE_THAT(gravity_wrench(2, {0, -9.81, 0}), IsClose(expected, Rounding(8, 20)));
    REQUIRE_THAT(gravity_wrench(0, {0, -9.81, 0}), IsExactly(Wrench()));
}

TEST_CASE("rotation: gravity may point anywhere and never has a torque", "[A3.14][rotation]")
{
    for (Random random : seeds(20)) {
        const double mass = random.mass();
        const Vector3d g = 10 * random.vector();
        const Wrench wrench = gravity_wrench(mass, g);
        REQUIRE_THAT(wrench.force, IsClose(Vector3d(mass * g), Rounding(8)));
        REQUIRE_THAT(wrench.torque, IsExactly(Vector3d(0, 0, 0)));
    }
}
