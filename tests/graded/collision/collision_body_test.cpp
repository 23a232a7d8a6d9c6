// SPDX-License-Identifier: MIT
// A4.10 and A4.11: the effect of an impulse on a body, and the contact that gets an impulse first.
#include "colliding_pair.hpp"
#include "formulas/collision.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

namespace rigor::testing {

namespace {

// Angular momentum about the point c.
Vector3d angular_momentum(const Body& body, const Vector3d& c)
{
    return body.angular_momentum + (body.position - c).cross(body.velocity) / body.inverse_mass;
}

ContactPoint contact(double depth, const Vector3d& v)
{
    return {Vector3d::Zero(), Vector3d(0, 1, 0), depth, v};
}

const Vector3d approaching(5, -1, 0), separating(-5, 1, 0), sliding(5, 0, 0);

using Contacts = std::vector<ContactPoint>;

void check_deepest(const Contacts& contacts, std::optional<int> expected)
{
    REQUIRE_THAT(deepest_approaching_point(contacts), IsExactly(expected));
}

} // namespace

TEST_CASE("collision: a rod bounces off its tip and starts to spin", "[A4.10][collision]")
{
    // A rod of mass 1 and length 1 at 45°, its tip at the origin, falls at 1 m/s. The tip gets an
    // impulse of 0.6 N s upwards.
    const Vector3d d = Vector3d(1, 1, 0) / std::sqrt(2.0);
    Body rod;
    rod.inverse_mass = 1;
    rod.inverse_inertia = 12 * (Matrix3d::Identity() - d * d.transpose());
    rod.position = d / 2;
    rod.velocity = Vector3d(0, -1, 0);

    const Body after = apply_impulse(rod, Vector3d::Zero(), Vector3d(0, 0.6, 0));

    Body expected = rod;
    expected.velocity = Vector3d(0, -0.4, 0);
    expected.angular_momentum = Vector3d(0, 0, -2.54558441227157 / 12);
    expected.angular_velocity = Vector3d(0, 0, -2.54558441227157);
    REQUIRE_THAT(after, IsClose(expected, Rounding(16, 2)));
}

TEST_CASE("collision: an impulse through the center of mass does not spin", "[A4.10][collision]")
{
    Random random(1);
    const Body body = random.body();
    const Vector3d j = random.vector();
    Body expected = body;
    expected.velocity += body.inverse_mass * j;
    const double scale = body.velocity.norm() + body.inverse_mass * j.norm() +
                         body.inverse_inertia.norm() * body.angular_momentum.norm();
    REQUIRE_THAT(apply_impulse(body, body.position, j), IsClose(expected, Rounding(8, scale)));
}

TEST_CASE("collision: an impulse changes momentum and angular momentum about any point",
          "[A4.10][collision]")
{
    for (Random random : seeds(100)) {
        const Body body = random.body();
        const Vector3d x = random.vector(), j = random.vector(), c = 3 * random.vector();

        const Body after = apply_impulse(body, x, j);

        const double M = 1 / body.inverse_mass;
        const Vector3d before = angular_momentum(body, c);
        const double momentum = M * body.velocity.norm() + j.norm();
        REQUIRE_THAT(Vector3d(M * after.velocity),
                     IsClose(M * body.velocity + j, Rounding(16, momentum)));
        const double scale = body.angular_momentum.norm() + 16 * momentum; // arms are at most 8 m
        REQUIRE_THAT(angular_momentum(after, c),
                     IsClose(Vector3d(before + (x - c).cross(j)), Rounding(16, scale)));
    }
}

TEST_CASE("collision: an impulse moves its point by K times itself", "[A4.10][collision]")
{
    for (Random random : seeds(100)) {
        const Body body = random.body();
        const Vector3d x = random.vector(), j = random.vector();
        const Matrix3d K = response_at(body, x);

        const Body after = apply_impulse(body, x, j);

        const double r = x.norm() + body.position.norm();
        const double spin = body.angular_momentum.norm() + 2 * r; // |j| is at most √3
        const double scale =
            body.velocity.norm() + 2 * body.inverse_mass + r * body.inverse_inertia.norm() * spin;
        REQUIRE_THAT(velocity_at(after, x),
                     IsClose(Vector3d(velocity_at(body, x) + K * j), Rounding(16, scale)));
    }
}

TEST_CASE("collision: after an impulse angular velocity and momentum still belong together",
          "[A4.10][collision]")
{
    for (Random random : seeds(100)) {
        const Body body = random.body();

        const Body after = apply_impulse(body, random.vector(), random.vector());

        const double spin = after.angular_momentum.norm() + body.angular_momentum.norm() + 8;
        REQUIRE_THAT(after.angular_velocity,
                     IsClose(Vector3d(body.inverse_inertia * after.angular_momentum),
                             Rounding(64, body.inverse_inertia.norm() * spin)));
    }
}

TEST_CASE("collision: an impulse moves no body and changes no mass", "[A4.10][collision]")
{
    Random random(1);
    const Body body = random.body();
    const Body after = apply_impulse(body, random.vector(), random.vector());
    REQUIRE_THAT(after.position, IsExactly(body.position));
    REQUIRE_THAT(after.inverse_mass, IsExactly(body.inverse_mass));
    REQUIRE_THAT(after.inverse_inertia, IsExactly(body.inverse_inertia));
    // a zero impulse changes nothing, but ω may be computed again from L
    const double spin = body.inverse_inertia.norm() * body.angular_momentum.norm();
    REQUIRE_THAT(apply_impulse(body, random.vector(), Vector3d::Zero()),
                 IsClose(body, Rounding(8, spin)));
}

TEST_CASE("collision: opposite impulses keep the momentum of a pair", "[A4.10][collision]")
{
    for (Random random : seeds(100)) {
        const Body body1 = random.body(), body2 = random.body();
        const Vector3d x = random.vector(), j = random.vector(), c = random.vector();

        const Body after1 = apply_impulse(body1, x, j), after2 = apply_impulse(body2, x, -j);

        const double M1 = 1 / body1.inverse_mass, M2 = 1 / body2.inverse_mass;
        const double momentum = 2 * (M1 + M2) + 4; // speeds and impulses are at most √3
        REQUIRE_THAT(Vector3d(M1 * after1.velocity + M2 * after2.velocity),
                     IsClose(M1 * body1.velocity + M2 * body2.velocity, Rounding(16, momentum)));
        const double scale =
            8 * momentum + body1.angular_momentum.norm() + body2.angular_momentum.norm();
        REQUIRE_THAT(Vector3d(angular_momentum(after1, c) + angular_momentum(after2, c)),
                     IsClose(Vector3d(angular_momentum(body1, c) + angular_momentum(body2, c)),
                             Rounding(16, scale)));
    }
}

TEST_CASE("collision: a static body is not changed by an impulse", "[A4.10][collision]")
{
    REQUIRE_THAT(apply_impulse(Body(), Vector3d(1, 2, 3), Vector3d(-4, 5, 6)), IsExactly(Body()));
    Random random(1);
    const Body conveyor = static_body(random);
    REQUIRE_THAT(apply_impulse(conveyor, Vector3d(1, 2, 3), Vector3d(-4, 5, 6)),
                 IsExactly(conveyor));
}

TEST_CASE("collision: the deepest contact comes first", "[A4.11][collision]")
{
    check_deepest({contact(0.1, approaching), contact(0.3, approaching), contact(0.2, approaching)},
                  1);
    check_deepest({contact(0.3, approaching), contact(0.1, approaching)}, 0);
    check_deepest({contact(0.1, approaching)}, 0);
}

TEST_CASE("collision: an angular momentum that turns nothing hides no impulse",
          "[A4.10][collision]")
{
    // About the axis of a rod, I⁻¹ is 0: L may be of any size there, and ω has no part of it.
    for (Random random : seeds(10))
        for (const double size : {0.0, 1e3, 1e6, 1e9, 1e12}) {
            const Vector3d n = random.unit_vector(), arm = random.vector(), j = random.vector();
            Body rod;
            rod.inverse_mass = 0.5;
            rod.inverse_inertia = 3 * (Matrix3d::Identity() - n * n.transpose());
            rod.angular_momentum = size * n;
            CAPTURE(size, n);
            const Body after = apply_impulse(rod, rod.position + arm, j);
            REQUIRE_THAT(after.angular_velocity,
                         IsClose(Vector3d(rod.inverse_inertia * arm.cross(j)), Rounding(32, 20)));
        }
}

TEST_CASE("collision: contacts that separate already are passed over", "[A4.11][collision]")
{
    check_deepest({contact(0.1, approaching), contact(0.3, separating), contact(0.2, approaching)},
                  2);
    check_deepest({contact(0.9, sliding), contact(0.8, separating), contact(0.1, approaching)}, 2);
}

TEST_CASE("collision: a contact that only slides does not approach", "[A4.11][collision]")
{
    // v·n is 0 or -0, for a normal and velocities of any signs
    for (const double x : {-1.0, 0.0, -0.0, 1.0})
        for (const double y : {0.0, -0.0})
            for (const Vector3d& n : {Vector3d(0, 1, 0), Vector3d(-0.0, -1, -0.0)}) {
                CAPTURE(x, y);
                ContactPoint slides, approaches;
                slides.depth = 2;
                slides.normal = approaches.normal = n;
                slides.relative_velocity = {x, y, x};
                approaches.depth = 1;
                approaches.relative_velocity = -n;
                check_that(deepest_approaching_point({slides, approaches}) == 1,
                           "the contact that approaches, not the deeper one that slides");
            }
}

TEST_CASE("collision: whether a contact approaches is seen along its normal", "[A4.11][collision]")
{
    ContactPoint wall = contact(0.2, Vector3d(-1, 3, 0)); // body 1 runs into a wall on the left
    wall.normal = Vector3d(1, 0, 0);
    check_deepest({contact(0.1, approaching), wall}, 1);
    wall.normal = Vector3d(-1, 0, 0); // body 1 moves away from a wall on the right
    check_deepest({contact(0.1, approaching), wall}, 0);
}

TEST_CASE("collision: where no contact approaches there is no deepest one", "[A4.11][collision]")
{
    check_deepest({}, std::nullopt);
    check_deepest({contact(0.3, separating)}, std::nullopt);
    check_deepest({contact(0.3, sliding), contact(0.1, separating)}, std::nullopt);
}

TEST_CASE("collision: of equally deep contacts the first one is taken", "[A4.11][collision]")
{
    check_deepest({contact(0.4, separating), contact(0.2, approaching), contact(0.2, approaching),
                   contact(0.1, approaching), contact(0.2, approaching)},
                  1);
}

TEST_CASE("collision: contacts that only touch count too", "[A4.11][collision]")
{
    check_deepest({contact(0, approaching)}, 0);
    check_deepest({contact(-0.2, approaching), contact(-0.1, approaching)}, 1);
}

TEST_CASE("collision: the deepest of many random contacts", "[A4.11][collision]")
{
    for (Random random : seeds(50)) {
        Contacts contacts;
        int deepest = -1;
        for (int i = 0; i < 20; ++i) {
            contacts.push_back(
                {random.vector(), random.unit_vector(), random.uniform(0, 1), random.vector()});
            const ContactPoint& c = contacts.back();
            const bool approaches = c.normal.dot(c.relative_velocity) < 0;
            if (approaches && (deepest < 0 || c.depth > contacts[deepest].depth)) deepest = i;
        }
        check_deepest(contacts, deepest < 0 ? std::nullopt : std::optional<int>(deepest));
    }
}

} // namespace rigor::testing
