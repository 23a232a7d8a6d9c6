// SPDX-License-Identifier: MIT
// A5.5: the laws of simultaneous contact, after few sweeps and after many.
#include "contact_laws.hpp"
#include "support/seeds.hpp"

namespace rigor::testing::contact_convergence_test {

namespace {

constexpr int few = 7; // sweeps, not enough to converge

ContactResult resolved(const ContactCase& problem, int sweeps)
{
    return resolve_simultaneously(problem.bodies, problem.contacts, sweeps);
}

// A random case with a first guess of the impulses, which may be good or bad.
ContactCase guessed_case(unsigned seed, bool with_statics)
{
    ContactCase problem = random_case(seed, with_statics);
    Random random(seed + 1000);
    for (BodyContact& c : problem.contacts) {
        c.impulse = 0.3 * random.vector();
        c.separation_speed = random.uniform(-0.3, 0.3);
    }
    return problem;
}

int visits(const ContactCase& problem)
{
    return (few + 1) * static_cast<int>(problem.contacts.size());
}

// Three cubes of edge 1, one on top of the other, that fall at 1 m/s. The topmost is pushed aside
// and twisted. Each cube rests on its four corners.
ContactCase pushed_tower(double friction)
{
    ContactCase tower{{Body()}, {}};
    for (int i = 1; i <= 3; ++i) {
        Body cube = block(1, -up, (i - 0.5) * up);
        cube.inverse_inertia = 6 * Matrix3d::Identity();
        tower.bodies.push_back(cube);
        for (double x : {-0.5, 0.5})
            for (double z : {-0.5, 0.5})
                tower.contacts.push_back(touch(i, i - 1, 0, {x, i - 1.0, z}, friction));
    }
    tower.bodies[3].velocity += Vector3d(0.2, 0, 0.1);
    tower.bodies[3].angular_velocity = Vector3d(0, 0.3, 0);
    tower.bodies[3].angular_momentum = Vector3d(0, 0.05, 0);
    return tower;
}

// Checks the laws of all contacts at once, up to rounding.
void check_laws(const ContactCase& problem, const ContactResult& result, double k)
{
    check_cones(problem, result, 16);
    const double size = impulse_size(problem, result);
    for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
        const BodyContact& c = problem.contacts[i];
        const Vector3d &n = c.normal, &j = result.impulses[i], v = velocity_of(result.bodies, c);
        const double v_n = v.dot(n), j_n = j.dot(n);
        const Vector3d v_T = v - v_n * n, j_T = j - j_n * n;
        CAPTURE(i);
        check_at_least(v_n, c.separation_speed, "v.n, by s", k * size);
        check_at_most((v_n - c.separation_speed) * j_n, 0, "(v.n - s) jₙ", k * size * size);
        // friction removes as much power as it can: j_T.v_T = -μ jₙ |v_T|
        check_at_most(j_T.dot(v_T) + c.friction * j_n * v_T.norm(), 0,
                      "what friction could still take, j_T.v_T + μ jₙ |v_T|", k * size * size);
    }
}

} // namespace

TEST_CASE("contact: simultaneously each body moves by the impulses that are reported",
          "[A5.5][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = guessed_case(seed, seed % 2 == 0);
        check_bookkeeping(problem, resolved(problem, few), visits(problem));
    }
}

TEST_CASE("contact: simultaneous contacts keep momentum and angular momentum", "[A5.5][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = guessed_case(seed, false);
        for (int sweeps : {0, 1, few})
            check_momenta(problem, resolved(problem, sweeps), visits(problem));
    }
}

TEST_CASE("contact: after each sweep contacts push and friction is in its cone", "[A5.5][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = guessed_case(seed, seed % 2 == 0);
        for (int sweeps : {1, 2, few})
            check_cones(problem, resolved(problem, sweeps), visits(problem));
    }
}

TEST_CASE("contact: without friction each sweep leaves less energy", "[A5.5][contact]")
{
    for (unsigned seed : seeds(50)) {
        ContactCase problem = random_case(seed, seed % 2 == 0);
        for (BodyContact& c : problem.contacts)
            c.friction = 0;
        const double start = energy(problem.bodies);
        double before = start;
        for (int sweeps = 1; sweeps <= few; ++sweeps) {
            const double now = energy(resolved(problem, sweeps).bodies);
            CAPTURE(sweeps);
            check_at_most(now, before, "kinetic energy", 64 * (1 + visits(problem)) * start);
            before = now;
        }
    }
}

TEST_CASE("contact: without friction the contact of the end of the list obeys its law",
          "[A5.5][contact]")
{
    for (unsigned seed : seeds(50)) {
        ContactCase problem = guessed_case(seed, false);
        const BodyContact& last = problem.contacts.back();
        for (BodyContact& c : problem.contacts)
            c.friction = 0;
        const ContactResult result = resolved(problem, few);
        const double speed = velocity_of(result.bodies, last).dot(last.normal);
        const double push = result.impulses.back().dot(last.normal);
        const double K = impulse_matrix_of(problem.bodies, last).norm();
        const double scale = 64 * (1 + visits(problem)) * K * impulse_size(problem, result);
        check_at_least(speed, last.separation_speed, "v.n, by s", scale);
        if (push > 0) REQUIRE_THAT(speed, IsClose(last.separation_speed, Rounding(1, scale)));
    }
}

TEST_CASE("contact: two sweeps are one sweep and then another", "[A5.5][contact]")
{
    for (unsigned seed : seeds(50)) {
        const ContactCase problem = guessed_case(seed, seed % 2 == 0);
        const ContactResult whole = resolved(problem, few);
        ContactCase rest = problem; // continues after the first sweeps
        const std::vector<Vector3d> guess = resolved(problem, few - 3).impulses;
        for (std::size_t i = 0; i < guess.size(); ++i)
            rest.contacts[i].impulse = guess[i];
        const double k = 256.0 * (1 + visits(problem)), size = impulse_size(problem, whole);
        REQUIRE_THAT(resolved(rest, 3).impulses, IsClose(whole.impulses, Rounding(k, size)));
    }
}

TEST_CASE("contact: simultaneously depth does not matter nor which body is called the first",
          "[A5.5][contact]")
{
    for (unsigned seed : seeds(50)) {
        const ContactCase problem = guessed_case(seed, seed % 2 == 0);
        ContactCase other = problem;
        for (BodyContact& c : other.contacts) {
            std::swap(c.body1, c.body2);
            c.normal = -c.normal;
            c.impulse = -c.impulse;
            c.depth = -c.depth;
        }
        const ContactResult result = resolved(problem, few);
        ContactResult again = resolved(other, few);
        for (Vector3d& j : again.impulses)
            j = -j;
        const double k = 256.0 * (1 + visits(problem)), size = impulse_size(problem, result);
        REQUIRE_THAT(again.impulses, IsClose(result.impulses, Rounding(k, size)));
    }
}

TEST_CASE("contact: turned by 17 degrees all contacts are resolved the same way", "[A5.5][contact]")
{
    for (unsigned seed : seeds(50)) {
        const ContactCase problem = guessed_case(seed, seed % 2 == 0);
        const Matrix3d R = turn(17, seed % 3 == 0 ? up : Random(seed).unit_vector());
        const ContactResult result = resolved(problem, few);
        const ContactResult again = resolved(turned(problem, {R}), few);
        const double k = 256.0 * (1 + visits(problem)), size = impulse_size(problem, result);
        for (std::size_t i = 0; i < problem.contacts.size(); ++i)
            REQUIRE_THAT(again.impulses[i],
                         IsClose(Vector3d(R * result.impulses[i]), Rounding(k, size)));
    }
}

TEST_CASE("contact: a tower that is pushed obeys all laws at once in the end", "[A5.5][contact]")
{
    for (double friction : {0.0, 0.05, 0.3}) {
        CAPTURE(friction);
        const ContactCase tower = pushed_tower(friction);
        const ContactResult result = resolved(tower, 3000);
        check_laws(tower, result, 256);
        check_at_most(energy(result.bodies), energy(tower.bodies), "kinetic energy", 64);
        // the floor carries three cubes
        double floor = 0;
        for (int corner = 0; corner < 4; ++corner)
            floor += result.impulses[corner].y();
        REQUIRE_THAT(floor, IsClose(3.0, Rounding(256, 3)));
    }
}

} // namespace rigor::testing::contact_convergence_test
