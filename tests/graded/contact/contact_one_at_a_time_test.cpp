// SPDX-License-Identifier: MIT
// A5.2: the laws of contacts that are resolved one point at a time, on random bodies.
#include "contact_laws.hpp"
#include "support/seeds.hpp"

#include <algorithm>

namespace rigor::testing::contact_one_at_a_time_test {

namespace {

constexpr int n = 5; // iterations

ContactResult resolved(const ContactCase& problem)
{
    return resolve_contacts(problem.bodies, problem.contacts, n);
}

int visits(const ContactCase& problem)
{
    return n * static_cast<int>(problem.contacts.size());
}

} // namespace

TEST_CASE("contact: one at a time each body moves by the impulses that are reported",
          "[A5.2][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = random_case(seed, seed % 2 == 0);
        check_bookkeeping(problem, resolved(problem), visits(problem));
    }
}

TEST_CASE("contact: one at a time keeps momentum and angular momentum", "[A5.2][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = random_case(seed, false);
        check_momenta(problem, resolved(problem), visits(problem));
    }
}

TEST_CASE("contact: one at a time contacts push and friction stays in its cone", "[A5.2][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = random_case(seed, seed % 2 == 0);
        check_cones(problem, resolved(problem), visits(problem));
    }
}

TEST_CASE("contact: one at a time never raises the energy", "[A5.2][contact]")
{
    for (unsigned seed : seeds(100)) {
        const ContactCase problem = random_case(seed, seed % 2 == 0);
        const double before = energy(problem.bodies);
        check_at_most(energy(resolved(problem).bodies), before, "kinetic energy afterwards",
                      64 * (1 + visits(problem)) * before);
    }
}

TEST_CASE("contact: the contact that was visited last does not approach", "[A5.2][contact]")
{
    for (unsigned seed : seeds(100)) {
        ContactCase problem = random_case(seed, seed % 2 == 0);
        for (BodyContact& c : problem.contacts)
            c.separation_speed = seed % 3 == 0 ? 0 : Random(seed).uniform(-0.5, 0.5);
        const BodyContact& last = *std::min_element(
            problem.contacts.begin(), problem.contacts.end(),
            [](const BodyContact& a, const BodyContact& b) { return a.depth < b.depth; });
        const Matrix3d K = impulse_matrix_of(problem.bodies, last);
        if (K.isZero(0)) continue; // both static

        const ContactResult result = resolved(problem);

        const Vector3d v = velocity_of(result.bodies, last);
        const double condition = K.norm() * K.inverse().norm();
        check_at_least(v.dot(last.normal), last.separation_speed, "v.n of the last contact, by s",
                       64 * condition * condition * K.norm() * impulse_size(problem, result));
    }
}

TEST_CASE("contact: one at a time the order of the list does not matter", "[A5.2][contact]")
{
    for (unsigned seed : seeds(50)) {
        const ContactCase problem = random_case(seed, seed % 2 == 0); // no two depths are equal
        ContactCase listed_backwards = problem;
        std::reverse(listed_backwards.contacts.begin(), listed_backwards.contacts.end());

        const ContactResult result = resolved(problem);
        ContactResult again = resolved(listed_backwards);

        std::reverse(again.impulses.begin(), again.impulses.end());
        const double size = impulse_size(problem, result);
        REQUIRE_THAT(again.impulses, IsClose(result.impulses, Rounding(64, size)));
    }
}

TEST_CASE("contact: one at a time it does not matter which body is called the first",
          "[A5.2][contact]")
{
    for (unsigned seed : seeds(50)) {
        const ContactCase pile = pile_of_balls(seed);
        ContactCase swapped = pile;
        for (BodyContact& c : swapped.contacts) {
            std::swap(c.body1, c.body2);
            c.normal = -c.normal;
        }
        const ContactResult result = resolved(pile);
        ContactResult again = resolved(swapped);
        for (Vector3d& j : again.impulses)
            j = -j;
        const double k = 64.0 * (1 + visits(pile)), size = impulse_size(pile, result);
        REQUIRE_THAT(again.impulses, IsClose(result.impulses, Rounding(k, size)));
    }
}

TEST_CASE("contact: one at a time starts from nothing and spares those who touch nothing",
          "[A5.2][contact]")
{
    for (unsigned seed : seeds(20)) {
        const ContactCase problem = random_case(seed, seed % 2 == 0);
        ContactCase guessed = problem;
        Random random(seed);
        for (BodyContact& c : guessed.contacts)
            c.impulse = random.vector(); // a warm start, which only A5.5 uses
        guessed.bodies.push_back(random.body());

        const ContactResult result = resolved(problem), again = resolved(guessed);

        const double size = impulse_size(problem, result);
        REQUIRE_THAT(again.impulses, IsClose(result.impulses, Rounding(64, size)));
        REQUIRE_THAT(again.bodies.back(), IsExactly(guessed.bodies.back()));
    }
}

TEST_CASE("contact: a pile of balls turned by 17 degrees is resolved the same way",
          "[A5.2][contact]")
{
    std::size_t contacts = 0;
    for (unsigned seed : seeds(50)) {
        const ContactCase pile = pile_of_balls(seed);
        const Matrix3d R = turn(17, Random(seed).unit_vector());
        const ContactResult result = resolved(pile), again = resolved(turned(pile, {R}));
        contacts += pile.contacts.size();
        const double k = 64.0 * (1 + visits(pile)), size = impulse_size(pile, result);
        for (std::size_t i = 0; i < pile.contacts.size(); ++i)
            REQUIRE_THAT(again.impulses[i],
                         IsClose(Vector3d(R * result.impulses[i]), Rounding(k, size)));
    }
    check_that(contacts > 100, "more than 100 contacts could be judged");
}

} // namespace rigor::testing::contact_one_at_a_time_test
