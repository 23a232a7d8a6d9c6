// SPDX-License-Identifier: MIT
// A ball that meets a small ball before it meets a wall or another ball, all within one step. Times
// and velocities of central impacts on a line are known in closed form.
#include "framework/rigid/worlds.hpp"
#include "rigid/step/step.hpp"
#include "support/seeds.hpp"

#include <limits>

namespace rigor::testing::passed_contact_test {

namespace {

// Balls on a line, from left to right, and perhaps a wall behind them.
struct Line {
    std::vector<double> x, v, radius, mass;
    double wall = std::numeric_limits<double>::infinity(), epsilon = 1;

    double gap(std::size_t i) const // to the next ball or to the wall
    {
        return i + 1 < x.size() ? x[i + 1] - x[i] - radius[i] - radius[i + 1]
                                : wall - x[i] - radius[i];
    }
    double speed(std::size_t i) const { return i + 1 < x.size() ? v[i + 1] - v[i] : -v[i]; }

    // Flies and bounces until `end`. @return the number of bounces
    int run(double end)
    {
        for (int bounces = 0;; ++bounces) {
            double first = end;
            std::size_t which = x.size();
            for (std::size_t i = 0; i < x.size(); ++i)
                if (speed(i) < 0 && std::max(gap(i), 0.0) / -speed(i) < first) {
                    first = std::max(gap(i), 0.0) / -speed(i);
                    which = i;
                }
            for (std::size_t i = 0; i < x.size(); ++i)
                x[i] += first * v[i];
            end -= first;
            if (which == x.size()) return bounces;
            bounce(which);
        }
    }

private:
    void bounce(std::size_t i) // v1' - v2' = -ε (v1 - v2), and momentum is conserved
    {
        const double u = speed(i);
        if (i + 1 == x.size()) {
            v[i] = -epsilon * v[i];
            return;
        }
        const double m = mass[i] * mass[i + 1] / (mass[i] + mass[i + 1]);
        const double j = -(1 + epsilon) * m * u;
        v[i] -= j / mass[i];
        v[i + 1] += j / mass[i + 1];
    }
};

// The world of a line along the direction d, with its bodies in one of two orders.
World world_of_line(const Line& line, const Vector3d& d, bool is_reversed, std::vector<int>& order)
{
    std::vector<RigidBody> bodies;
    for (std::size_t k = 0; k < line.x.size(); ++k) {
        const std::size_t i = is_reversed ? line.x.size() - 1 - k : k;
        RigidBody ball = body_of(Sphere{line.radius[i]}, line.x[i] * d, {line.epsilon, 0});
        const double inertia = 0.4 * line.mass[i] * line.radius[i] * line.radius[i];
        set_mass(ball, line.mass[i], inertia * Matrix3d::Identity());
        ball.state.velocity = line.v[i] * d;
        bodies.push_back(ball);
        order.push_back(static_cast<int>(i));
    }
    if (std::isfinite(line.wall)) {
        RigidBody wall = fixed(Plane{}, {line.epsilon, 0});
        wall.state.position = line.wall * d;
        const Eigen::Quaterniond q = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitY(), -d);
        wall.state.orientation = {q.w(), q.vec()};
        bodies.insert(is_reversed ? bodies.begin() : bodies.end(), wall);
        order.insert(is_reversed ? order.begin() : order.end(), -1);
    }
    return world_of(bodies, {0, 0, 0});
}

void check_line(Line line, double time_step, const Vector3d& d, bool is_reversed)
{
    constexpr int steps = 12;
    std::vector<int> order;
    World world = world_of_line(line, d, is_reversed, order);
    Line later = line;
    const int bounces = line.run(steps * time_step);
    // a bounce within rounding of the end may or may not have happened
    if (bounces > 60 || later.run(steps * time_step + 1e-7) != bounces) return;
    run(world, steps, time_step);
    for (std::size_t k = 0; k < order.size(); ++k)
        if (order[k] >= 0) {
            CAPTURE(k, bounces);
            CHECK_THAT(world.bodies[k].state.velocity.dot(d),
                       IsClose(line.v[static_cast<std::size_t>(order[k])], Order(1e-6)));
        }
}

} // namespace

TEST_CASE("passed contact: a ball hits a pea before the wall behind it", "[rigid]")
{
    const double time_step = GENERATE(0.02, 0.01, 0.005, 0.0025);
    const double pea = GENERATE(0.001, 0.005, 0.02), behind = GENERATE(0.005, 0.01, 0.03);
    const double mass = GENERATE(0.008, 0.04, 2.0), epsilon = GENERATE(1.0, 0.8);
    for (Random random : seeds(6)) {
        const double phase = random.uniform(0, 1), speed = random.uniform(1, 8);
        CAPTURE(time_step, pea, behind, mass, epsilon, phase, speed);
        Line line;
        line.radius = {0.1, pea};
        line.mass = {0.04, mass};
        line.epsilon = epsilon;
        line.x = {0, 0.1 + pea + (2 + phase) * time_step * speed};
        line.v = {speed, 0};
        line.wall = line.x[1] + pea + behind;
        check_line(line, time_step, random.unit_vector(), random.bits() % 2 == 0);
    }
}

TEST_CASE("passed contact: a ball hits a small ball before the one behind it", "[rigid]")
{
    const double time_step = GENERATE(0.02, 0.01, 0.005, 0.0025);
    const double pea = GENERATE(0.001, 0.005, 0.02), behind = GENERATE(0.001, 0.01, 0.03);
    const double epsilon = GENERATE(1.0, 0.5);
    for (Random random : seeds(10)) {
        const double phase = random.uniform(0, 1), speed = random.uniform(1, 8);
        CAPTURE(time_step, pea, behind, epsilon, phase, speed);
        Line line;
        line.radius = {0.1, pea, 0.05};
        line.mass = {0.04, random.uniform(0.001, 0.05), random.uniform(0.001, 0.05)};
        line.epsilon = epsilon;
        line.x = {0, 0.1 + pea + (2 + phase) * time_step * speed, 0};
        line.x[2] = line.x[1] + pea + behind + 0.05;
        line.v = {speed, 0, 0};
        check_line(line, time_step, random.unit_vector(), random.bits() % 2 == 0);
    }
}

} // namespace rigor::testing::passed_contact_test
