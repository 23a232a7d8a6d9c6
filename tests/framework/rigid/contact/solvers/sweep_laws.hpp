// SPDX-License-Identifier: MIT
// Laws of the sweeps over the contacts of an island, whichever formulas they use.
#pragma once

#include "formulas/contact.hpp"
#include "framework/rigid/contact/hand_made.hpp"
#include "rigid/contact/active_contacts.hpp"
#include "rigid/contact/blocks.hpp"
#include "rigid/contact/solvers/sweeps.hpp"
#include "support/seeds.hpp"

namespace rigor::testing {

/// Random bodies that touch each other and the ground, and their active contacts.
struct Pile : HandMade {
    UninitializedVector<int> active;

    explicit Pile(Random random)
    {
        for (int i = 1; i < 7; ++i)
            add(random_body(random));
        for (int i = 0; i < 15; ++i) {
            const int body1 = 1 + i % 6, body2 = i < 6 ? 0 : 1 + (i * 5 + 3) % 6;
            if (body1 == body2) continue;
            const Vector3d point = 2 * random.vector();
            ContactConstraint& c = touch(body1, body2, point, random.unit_vector());
            c.gap = random.uniform(-0.01, 0.01);
            c.friction = random.uniform(0, 1);
            c.initial_impulse = 0.1 * c.normal;
        }
        split_into_blocks(*this, island);
        active = activate_contacts(*this, island);
    }

    /// The contacts as input for the formula.
    std::vector<BodyContact> for_formula() const
    {
        std::vector<BodyContact> all;
        for (int i : active) {
            const ContactConstraint& c = contacts[i];
            all.push_back({c.body1, c.body2, c.point, c.normal, -c.gap, c.friction, c.target_speed,
                           c.initial_impulse});
        }
        return all;
    }

    /// Checks the stored impulses and velocities.
    void check_result(const ContactResult& expected, const Tolerance& rounding) const
    {
        for (std::size_t k = 0; k < active.size(); ++k)
            CHECK_THAT(contacts[active[k]].contact_impulse,
                       IsClose(expected.impulses[k], rounding));
        for (int i : island.bodies)
            CHECK_THAT(bodies[i], IsClose(expected.bodies[i], rounding));
        CHECK(moves_alike(bodies[0], Body()));
    }

private:
    static Body random_body(Random& random)
    {
        Body body;
        const Matrix3d A = random.rotation();
        const Vector3d moments(random.uniform(0.1, 10), random.uniform(0.1, 10),
                               random.uniform(0.1, 10));
        body.inverse_mass = random.uniform(0.1, 10);
        body.inverse_inertia = A * moments.asDiagonal() * A.transpose();
        body.position = random.vector();
        body.velocity = random.vector();
        body.angular_velocity = random.vector();
        body.angular_momentum = random.vector();
        return body;
    }
};

/// n sweeps give the impulses and bodies of `resolve_simultaneously` with n sweeps.
///
/// @param make  makes the sweeps of a pile
template <class Make> void check_sweeps_are_those_of_the_formula(const Make& make)
{
    for (Random random : seeds(20))
        for (int sweeps : {0, 1, 7}) {
            CAPTURE(sweeps);
            Pile pile(random);
            REQUIRE(pile.active.size() > 8);
            const ContactResult expected =
                resolve_simultaneously(pile.bodies, pile.for_formula(), sweeps);
            const std::unique_ptr<Sweeps> made = make(pile);
            std::vector<Vector3d> steps(pile.active.size());
            for (int i = 0; i < sweeps; ++i)
                made->sweep(steps);
            made->finish();
            // Each sweep adds some rounding error of velocities up to 10 m/s and impulses up to 10
            // N s.
            pile.check_result(expected, Rounding(1000.0 * (sweeps + 1), 10));
        }
}

/// Changes that are added to the impulses count as if the sweeps had started with them.
template <class Make> void check_added_impulses_act_on_the_bodies(const Make& make)
{
    for (Random random : seeds(20))
        for (const int combination : {0, 1, 2, 3}) {
            const int sweeps_before = combination / 2, sweeps_after = combination % 2;
            CAPTURE(sweeps_before, sweeps_after);
            Pile pile(random);
            std::vector<Vector3d> steps(pile.active.size()), changes;
            std::vector<BodyContact> contacts = pile.for_formula();
            const ContactResult before =
                resolve_simultaneously(pile.bodies, contacts, sweeps_before);
            for (std::size_t k = 0; k < contacts.size(); ++k) {
                changes.emplace_back(0.1 * random.uniform(-1, 1) * contacts[k].normal);
                contacts[k].impulse = before.impulses[k] + changes[k];
            }
            const ContactResult expected =
                resolve_simultaneously(pile.bodies, contacts, sweeps_after);
            const std::unique_ptr<Sweeps> made = make(pile);
            for (int i = 0; i < sweeps_before; ++i)
                made->sweep(steps);
            made->add(changes);
            const std::vector<Vector3d> now = made->impulses();
            REQUIRE(now.size() == contacts.size());
            for (std::size_t k = 0; k < now.size(); ++k)
                CHECK_THAT(now[k], IsClose(contacts[k].impulse, Rounding(1000, 10)));
            for (int i = 0; i < sweeps_after; ++i)
                made->sweep(steps);
            made->finish();
            pile.check_result(expected, Rounding(3000, 10));
        }
}

/// One contact below a body of 2 kg that arrives at -3 m/s: the first sweep stops the body, the
/// second one finds nothing to do.
template <class Make> void check_progress_of_a_single_contact(const Make& make)
{
    HandMade problem;
    const int ball = problem.add(ball_at({0, 0.5, 0}, 2, {0, -3, 0}));
    problem.touch(ball, 0, {0, 0, 0});
    const std::vector<int> active = {0};
    const std::unique_ptr<Sweeps> made = make(problem, active);
    std::vector<Vector3d> steps(1);
    const SweepProgress first = made->sweep(steps);
    CHECK(steps[0] == Vector3d(0, 6, 0));
    CHECK(first.change == 3);
    CHECK(first.total == 3);
    CHECK(first.squared == 0.5 * 6 * 6);
    const SweepProgress second = made->sweep(steps);
    CHECK(steps[0] == Vector3d(0, 0, 0));
    CHECK(second.change == 0);
    CHECK(second.total == 3);
    CHECK(second.squared == 0);
    made->finish();
    CHECK(problem.bodies[ball].velocity == Vector3d(0, 0, 0));
    CHECK(problem.contacts[0].contact_impulse == Vector3d(0, 6, 0));
    CHECK(moves_alike(problem.bodies[0], Body()));
}

/// A body that leaves gets no impulse, and one without contacts has nothing to sweep.
template <class Make> void check_sweeps_without_work(const Make& make)
{
    HandMade problem;
    const int ball = problem.add(ball_at({0, 0.5, 0}, 2, {4, 3, 0}));
    problem.touch(ball, 0, {0, 0, 0}).friction = 1;
    const Body before = problem.bodies[ball];
    for (const std::vector<int>& active : {std::vector<int>{0}, std::vector<int>{}}) {
        const std::unique_ptr<Sweeps> made = make(problem, active);
        std::vector<Vector3d> steps(active.size());
        const SweepProgress progress = made->sweep(steps);
        CHECK(progress.change == 0);
        CHECK(progress.total == 0);
        CHECK(progress.squared == 0);
        made->finish();
        CHECK(moves_alike(problem.bodies[ball], before));
        CHECK(problem.contacts[0].contact_impulse == Vector3d::Zero());
        CHECK(problem.counted.contact_impulses == 0);
    }
}

} // namespace rigor::testing
