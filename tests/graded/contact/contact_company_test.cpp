// SPDX-License-Identifier: MIT
// A5.2, A5.4 and A5.5: the impulse of a contact depends on its own bodies alone. Groups of bodies
// that touch nothing in common are resolved together as they are alone, whatever their masses. A
// sweep resolves its contacts one after another, and a single contact gets all its iterations.
#include "contact_laws.hpp"
#include "support/seeds.hpp"

#include <algorithm>

namespace rigor::testing::contact_company_test {

namespace {

// One to three random bodies on a static one. Their contacts couple normal and tangential motion.
// About half of them are followed by a second contact with the same bodies and normal, at another
// point.
ContactCase small_group(Random& random)
{
    ContactCase group{{static_body(random)}, {}};
    const int count = 1 + random_index(random, 3);
    for (int i = 1; i <= count; ++i) {
        group.bodies.push_back(random.body());
        BodyContact c = touch(i, random_index(random, static_cast<std::size_t>(i)),
                              random.uniform(0, 1), random.vector(), random.uniform(0, 0.3));
        c.normal = random.unit_vector();
        c.separation_speed = random.uniform(-0.1, 0.1);
        c.impulse = 0.01 * random.vector(); // a start of A5.5
        if (random.bits() % 2 == 0) std::swap(c.body1, c.body2);
        group.contacts.push_back(c);
        if (random.bits() % 2 == 0) continue;
        c.point = random.vector();
        c.depth = random.uniform(0, 1);
        group.contacts.push_back(c);
    }
    return group;
}

// The groups as one case, in which each keeps its own bodies and contacts.
ContactCase together(const std::vector<ContactCase>& groups)
{
    ContactCase all;
    for (const ContactCase& group : groups) {
        const int first = static_cast<int>(all.bodies.size());
        all.bodies.insert(all.bodies.end(), group.bodies.begin(), group.bodies.end());
        for (BodyContact c : group.contacts) {
            c.body1 += first;
            c.body2 += first;
            all.contacts.push_back(c);
        }
    }
    return all;
}

// The same bodies, 2^power times as heavy.
Bodies heavier(Bodies bodies, int power)
{
    for (Body& body : bodies) {
        body.inverse_mass = std::ldexp(body.inverse_mass, -power);
        body.inverse_inertia *= std::ldexp(1, -power);
        body.angular_momentum *= std::ldexp(1, power);
    }
    return bodies;
}

ContactCase heavier(ContactCase group, int power)
{
    for (BodyContact& c : group.contacts)
        c.impulse *= std::ldexp(1, power);
    return {heavier(group.bodies, power), group.contacts};
}

// The groups may have very different masses.
// @param resolve  computes the ContactResult from a ContactCase and a number of iterations
template <class Resolve> void check_company(const Resolve& resolve)
{
    for (Random random : seeds(30)) {
        std::vector<ContactCase> groups, weighted;
        std::vector<int> powers;
        for (int i = 0; i < 4; ++i) {
            groups.push_back(small_group(random));
            powers.push_back(random.bits() % 2 == 0 ? 0 : random_index(random, 121) - 60);
            weighted.push_back(heavier(groups.back(), powers.back()));
        }
        for (const int n : {1, 2, 3, 10}) {
            CAPTURE(n);
            const ContactResult all = resolve(together(weighted), n);
            std::size_t body = 0, contact = 0;
            for (std::size_t i = 0; i < groups.size(); ++i) {
                ContactResult company; // this group's part of the result, in its usual masses
                for (std::size_t k = 0; k < groups[i].bodies.size(); ++k)
                    company.bodies.push_back(all.bodies.at(body++));
                for (std::size_t k = 0; k < groups[i].contacts.size(); ++k)
                    company.impulses.push_back(std::ldexp(1, -powers[i]) *
                                               all.impulses.at(contact++));
                company.bodies = heavier(company.bodies, -powers[i]);
                INFO("groups of bodies that touch nothing in common, together and alone");
                REQUIRE_THAT(company, IsClose(resolve(groups[i], n), Rounding(1 << 12, 16)));
            }
        }
    }
}

std::vector<int> heights(const Bodies& bodies)
{
    std::vector<int> levels;
    for (const Body& body : bodies)
        levels.push_back(body.is_static() ? 0 : levels.back() + 1);
    return levels;
}

// A rod of mass 1 and length 1 leans along the unit vector d in the plane z = 0, and falls on its
// tip. There, K is 4 δ - 3 d dᵀ, so that a push along the normal makes the tip slide to the left.
ContactCase falling_rod(const Vector3d& d, double friction)
{
    Body leaning = block(1, -up, d / 2);
    leaning.inverse_inertia = 12 * (Matrix3d::Identity() - d * d.transpose());
    return {{Body(), leaning}, {touch(1, 0, 0.01, {0, 0, 0}, friction)}};
}

// The sum of the impulses that the rod gets in n iterations. In the first one the tip does not
// slide yet; in the others it slides to the left, too fast for its friction to stop it.
Vector3d falling_rod_impulse(const Vector3d& d, double friction, int n)
{
    const double K_n = 4 - 3 * d.y() * d.y(), K_slide = K_n - 3 * friction * d.x() * d.y();
    double v_n = -1, first = 0, sliding = 0; // m/s, and the normal impulses
    for (int k = 0; k < n; ++k) {
        const double share = (k + 1.0) / n;
        (k == 0 ? first : sliding) += share * -v_n / (k == 0 ? K_n : K_slide);
        v_n *= 1 - share;
    }
    return {friction * sliding, first + sliding, 0};
}

// Checks that a single contact gets n iterations, each with a restitution of its own.
template <class Resolve> void check_single_contact(const Resolve& resolve)
{
    for (Random random : seeds(5)) {
        const View view = random_view(random);
        const double angle = random.uniform(0.6, 0.9), friction = random.uniform(0.05, 0.2);
        const Vector3d d(std::cos(angle), std::sin(angle), 0);
        const ContactCase there = turned(falling_rod(d, friction), view);
        for (const int n : {1, 2, 3, 4, 5, 7, 10, 30}) {
            CAPTURE(n);
            const Vector3d expected = view.impulse(falling_rod_impulse(d, friction, n));
            REQUIRE_THAT(resolve(there, n).impulses[0],
                         IsClose(expected, Rounding(64.0 * (n + 4), view.mass * view.speed)));
        }
    }
}

ContactResult one_at_a_time(const ContactCase& problem, int n)
{
    return resolve_contacts(problem.bodies, problem.contacts, n);
}

ContactResult level_by_level(const ContactCase& problem, int n)
{
    return shock_propagation(problem.bodies, problem.contacts, heights(problem.bodies), n);
}

ContactResult at_once(const ContactCase& problem, int sweeps)
{
    return resolve_simultaneously(problem.bodies, problem.contacts, sweeps);
}

} // namespace

TEST_CASE("contact: one at a time in company as alone", "[A5.2][contact]")
{
    check_company(one_at_a_time);
}

TEST_CASE("contact: level by level in company as alone", "[A5.4][contact]")
{
    check_company(level_by_level);
}

TEST_CASE("contact: simultaneously in company as alone", "[A5.5][contact]")
{
    check_company(at_once);
}

TEST_CASE("contact: one at a time a single contact gets every iteration", "[A5.2][contact]")
{
    check_single_contact(one_at_a_time);
}

TEST_CASE("contact: a level with a single contact gets every iteration", "[A5.4][contact]")
{
    check_single_contact(level_by_level);
}

TEST_CASE("contact: an iteration is its contacts one after another", "[A5.2][contact]")
{
    for (Random random : seeds(50)) {
        ContactCase problem = small_group(random);
        if (random.bits() % 2 == 0) // all contacts are at one point
            for (BodyContact& c : problem.contacts)
                c.point = problem.contacts[0].point;
        std::vector<std::size_t> order(problem.contacts.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return problem.contacts[a].depth > problem.contacts[b].depth;
        });
        ContactResult expected{problem.bodies, std::vector<Vector3d>(order.size())};
        for (const std::size_t i : order) {
            const auto [bodies, impulses] =
                one_at_a_time({expected.bodies, {problem.contacts[i]}}, 1);
            expected.bodies = bodies;
            expected.impulses[i] = impulses[0];
        }
        REQUIRE_THAT(one_at_a_time(problem, 1), IsClose(expected, Rounding(1 << 12, 16)));
    }
}

TEST_CASE("contact: a sweep is its contacts one after another", "[A5.5][contact]")
{
    for (Random random : seeds(50)) {
        ContactCase problem = small_group(random);
        const bool is_one_point = random.bits() % 2 == 0;
        for (BodyContact& c : problem.contacts) {
            c.impulse = 0.1 * random.vector();
            if (is_one_point) c.point = problem.contacts[0].point;
        }
        ContactResult expected = at_once(problem, 0);
        for (int sweep = 1; sweep <= 3; ++sweep) {
            for (std::size_t i = 0; i < problem.contacts.size(); ++i) {
                // this contact alone, with its impulse so far as the warm start
                BodyContact c = problem.contacts[i];
                c.impulse = expected.impulses[i];
                Bodies bodies = expected.bodies;
                bodies[c.body1] = kicked(bodies[c.body1], c.point, -c.impulse);
                bodies[c.body2] = kicked(bodies[c.body2], c.point, c.impulse);
                const ContactResult alone = at_once({bodies, {c}}, 1);
                expected.bodies = alone.bodies;
                expected.impulses[i] = alone.impulses[0];
            }
            CAPTURE(sweep);
            REQUIRE_THAT(at_once(problem, sweep), IsClose(expected, Rounding(1 << 14, 16)));
        }
    }
}

} // namespace rigor::testing::contact_company_test
