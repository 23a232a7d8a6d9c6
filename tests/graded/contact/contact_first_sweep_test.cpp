// SPDX-License-Identifier: MIT
// A5.5: the first sweep of a single contact, from any starting impulse, by its formula. The normal
// lies along an axis or very near one, where tangents are easily chosen badly.
#include "contact_cases.hpp"
#include "formulas/contact.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

namespace rigor::testing {

namespace {

// A body at the origin that turns, and a contact at x with static ground.
struct SingleContact {
    Body body;
    Vector3d x;

    Matrix3d K() const
    {
        Matrix3d arm;
        arm << 0, -x.z(), x.y(), //
            x.z(), 0, -x.x(),    //
            -x.y(), x.x(), 0;
        return body.inverse_mass * Matrix3d::Identity() -
               arm * body.inverse_inertia * arm; // arm is skew-symmetric
    }
    Vector3d velocity() const { return body.velocity + body.angular_velocity.cross(x); }
};

SingleContact random_contact(Random& random)
{
    SingleContact contact{random.body(), random.vector()};
    contact.body.position.setZero();
    return contact;
}

// The larger eigenvalue of K in the plane of the tangents t and b.
double larger_eigenvalue(const Matrix3d& K, const Vector3d& t, const Vector3d& b)
{
    const double a = t.dot(K * t), c = b.dot(K * b), mixed = t.dot(K * b);
    return (a + c) / 2 + std::hypot((a - c) / 2, mixed);
}

// @param n, t, b  an orthonormal frame
void check_first_sweep(const SingleContact& contact, const Vector3d& n, const Vector3d& t,
                       const Vector3d& b, double friction, const Vector3d& start)
{
    const Matrix3d K = contact.K();
    const Vector3d v = contact.velocity() + K * start;
    const double j_n = std::max(0.0, start.dot(n) - v.dot(n) / n.dot(K * n));
    const double lambda = larger_eigenvalue(K, t, b);
    Vector3d j_T = start - start.dot(n) * n - (v - v.dot(n) * n) / lambda;
    if (j_T.norm() > friction * j_n) j_T *= friction * j_n / j_T.norm();

    BodyContact touching = touch(1, 0, 0.01, contact.x, friction);
    touching.normal = n;
    touching.impulse = start;
    const ContactResult result = resolve_simultaneously({Body(), contact.body}, {touching}, 1);
    const double scale = 1 + start.norm() + v.norm() / std::min(lambda, n.dot(K * n));
    REQUIRE_THAT(result.impulses[0], IsClose(Vector3d(j_n * n + j_T), Rounding(1 << 8, scale)));
}

template <class Check> void for_each_axis(const Check& check)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            check(sign * Vector3d::Unit(axis), Vector3d::Unit((axis + 1) % 3),
                  sign * Vector3d::Unit((axis + 2) % 3));
}

} // namespace

TEST_CASE("contact: the first sweep on a floor or a wall", "[A5.5][contact]")
{
    for (Random random : seeds(20)) {
        const SingleContact contact = random_contact(random);
        for_each_axis([&](const Vector3d& n, const Vector3d& t, const Vector3d& b) {
            for (const double friction : {0.0, 0.3, 10.0})
                check_first_sweep(contact, n, t, b, friction, {0, 0, 0});
        });
    }
}

TEST_CASE("contact: the first sweep where the normal leans a little", "[A5.5][contact]")
{
    for (Random random : seeds(5)) {
        const SingleContact contact = random_contact(random);
        for (int power = -2; power >= -50; power -= 4)
            for_each_axis([&](const Vector3d& axis, const Vector3d& t, const Vector3d& b) {
                const double angle = std::ldexp(1, power);
                CAPTURE(axis, angle);
                const Vector3d n = std::cos(angle) * axis + std::sin(angle) * t,
                               across = std::cos(angle) * t - std::sin(angle) * axis;
                check_first_sweep(contact, n, across, b, 10, {0, 0, 0});
            });
    }
}

TEST_CASE("contact: the first sweep where the tangential eigenvalues are nearly equal",
          "[A5.5][contact]")
{
    for (Random random : seeds(5))
        for (int power = -1; power >= -50; --power)
            for_each_axis([&](const Vector3d& n, const Vector3d& t, const Vector3d& b) {
                CAPTURE(n, power);
                SingleContact contact = random_contact(random);
                contact.x = -0.75 * n;
                const Vector3d moments = Vector3d::Ones() + std::ldexp(1, power) * t.cwiseAbs();
                contact.body.inverse_inertia = moments.asDiagonal();
                contact.body.angular_velocity =
                    contact.body.inverse_inertia * contact.body.angular_momentum;
                check_first_sweep(contact, n, t, b, 10, {0, 0, 0});
            });
}

TEST_CASE("contact: without friction no tangential impulse is left of the start", "[A5.5][contact]")
{
    for (Random random : seeds(20)) {
        const SingleContact contact = random_contact(random);
        for_each_axis([&](const Vector3d& n, const Vector3d& t, const Vector3d& b) {
            for (const double along : {0.0, 1.0})
                check_first_sweep(contact, n, t, b, 0, along * n + 0.25 * t - 0.5 * b);
        });
    }
}

TEST_CASE("contact: a part of the normal that is almost nothing changes nothing", "[A5.5][contact]")
{
    for (Random random : seeds(5)) {
        const SingleContact contact = random_contact(random);
        for (const double tiny : {0x1p-54, 0x1p-200, 0x1p-500, 0x1p-560, 0x1p-1000, 0x1p-1074})
            for_each_axis([&](const Vector3d& n, const Vector3d& t, const Vector3d& b) {
                CAPTURE(tiny);
                // to rounding these normals are still unit and perpendicular to t and b
                for (const Vector3d& beside : {t, Vector3d(-b), Vector3d(t + b)})
                    check_first_sweep(contact, n + tiny * beside, t, b, 0.3, {0, 0, 0});
            });
    }
}

} // namespace rigor::testing
