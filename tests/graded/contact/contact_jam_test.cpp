// SPDX-License-Identifier: MIT
// A5.2: a jammed contact whose sticking impulse pulls at a restitution near -1 and pushes at higher
// ones. It gets nothing in the first iterations, and its impulses in the later ones.
#include "contact_laws.hpp"
#include "support/in_words.hpp"

namespace rigor::testing::contact_jam_test {

namespace {

// A body whose impulse matrix at `point` is in whole numbers. With the friction 0.81 or more, the
// contact jams if the body slides along (1, 0, -1).
Body sliding_body()
{
    Body body = block(1, {2, -2, -2});
    body.inverse_inertia.diagonal() = Vector3d(0, 4, 7);
    return body;
}
const Vector3d point(1, -2, 2);

// A4.9 with the normal y, and whether the contact jams.
struct Impulse {
    Vector3d j;
    bool jams = false;
};
Impulse impulse_at(const Matrix3d& K, const Vector3d& v, double restitution, double friction)
{
    const Vector3d sticking = K.inverse() * (-v - restitution * v.y() * up),
                   v_T = tangential(v, up), j_T = tangential(sticking, up);
    const double limit = friction * sticking.y();
    if (j_T.norm() <= limit) return {sticking};
    const double frictionless = -(1 + restitution) * v.y();
    if (v_T.norm() <= 1e-12 * v.norm()) return {frictionless / K(1, 1) * up};
    const Vector3d cone = up - friction * v_T.normalized();
    if (const double nKc = up.dot(K * cone); nKc > 0) return {frictionless / nKc * cone};
    if (limit <= 0) return {Vector3d::Zero(), true};
    return {sticking.y() * up + limit / j_T.norm() * j_T, true};
}

} // namespace

TEST_CASE("contact: an iteration without an impulse is not the last", "[A5.2][contact]")
{
    const double friction = 2;
    for (const int n : {10, 11, 40}) {
        CAPTURE(n);
        const Matrix3d K = response_at(sliding_body(), point);
        Vector3d v = sliding_body().velocity, sum = Vector3d::Zero();
        int without = 0;
        for (int k = 0; k < n && v.y() < 0; ++k) {
            const auto [j, jams] = impulse_at(K, v, (k + 1.0) / n - 1, friction);
            without += jams && j.isZero(0) ? 1 : 0;
            sum += j;
            v += K * j;
        }
        check_that(without > 0, "an iteration in which the contact jams and pulls");
        BodyContact c = touch(1, 0, 0.01, point, friction);
        const ContactResult found = resolve_contacts({Body(), sliding_body()}, {c}, n);
        REQUIRE_THAT(found.impulses[0], IsClose(sum, Rounding(1 << 10, 4)));
    }
}

} // namespace rigor::testing::contact_jam_test
