// SPDX-License-Identifier: MIT
#include "rigid/contact/solvers/newton_row.hpp"

#include "framework/rigid/worlds.hpp"
#include "support/seeds.hpp"

using namespace rigor;
using namespace rigor::testing;
using namespace rigor::newton;

namespace {

NewtonRow row_with(const Vector3d& normal, double limit)
{
    NewtonRow row;
    row.n = normal;
    row.limit = limit;
    return row;
}

} // namespace

TEST_CASE("newton row: a vector is the sum of its normal and tangential parts", "[rigid]")
{
    const NewtonRow row = row_with({0, 1, 0}, 0);
    const auto [normal, tangential] = split(row, {3, -2, 4});
    CHECK(normal == -2);
    CHECK(tangential == Vector3d(3, 0, 4));
}

TEST_CASE("newton row: the projection keeps what pushes and shortens what slides", "[rigid]")
{
    const NewtonRow row = row_with({0, 1, 0}, 2);
    CHECK(projected(row, {1, 5, 1}) == Vector3d(1, 5, 1)); // it is allowed as it is
    CHECK_THAT(projected(row, {3, 5, 4}), IsClose(Vector3d(1.2, 5, 1.6), Rounding(4)));
    // A contact does not pull. Its friction limit is held fixed during a round.
    CHECK(projected(row, {1, -5, 1}) == Vector3d(1, 0, 1));
    CHECK(projected(row_with({0, 1, 0}, 0), {3, 5, 4}) == Vector3d(0, 5, 0));
}

TEST_CASE("newton row: no allowed impulse is nearer than the projection", "[rigid]")
{
    for (Random random : seeds(20)) {
        const NewtonRow row = row_with(random.unit_vector(), random.uniform(0.1, 1));
        const Vector3d y = 2 * random.vector(), p = projected(row, y);
        CHECK_THAT(projected(row, p), IsClose(p, Rounding(16, 4)));
        for (int i = 0; i < 50; ++i) {
            const Vector3d allowed = projected(row, 3 * random.vector());
            check_at_least((y - allowed).norm(), (y - p).norm(), "distance, by the projection's",
                           16);
        }
    }
}

TEST_CASE("newton row: the slope is the derivative of the projection", "[rigid]")
{
    int sliding = 0, sticking = 0, apart = 0;
    for (Random random : seeds(50)) {
        const NewtonRow row = row_with(random.unit_vector(), random.uniform(0.1, 1));
        const Vector3d y = 2 * random.vector();
        const auto [normal, tangential] = split(row, y);
        constexpr double d = 1e-5; // the central difference is right up to d² and eps/d
        if (std::abs(normal) < 2 * d || std::abs(tangential.norm() - row.limit) < 2 * d) continue;
        ++(normal < 0 ? apart : tangential.norm() > row.limit ? sliding : sticking);
        Matrix3d differences;
        for (int k = 0; k < 3; ++k) {
            const Vector3d e = d * Vector3d::Unit(k);
            differences.col(k) = (projected(row, y + e) - projected(row, y - e)) / (2 * d);
        }
        CHECK_THAT(slope(row, y), IsClose(differences, Order(1e-7)));
        CHECK_THAT(slope(row, y), IsClose(Matrix3d(slope(row, y).transpose()), Rounding(8)));
    }
    CHECK(sliding > 0);
    CHECK(sticking > 0);
    CHECK(apart > 0);
}

TEST_CASE("newton row: u is the velocity between the points less the target", "[rigid]")
{
    Eigen::VectorXd v(12); // V and ω of two bodies
    v << 1, 2, 3, 0, 0, 2, 5, 5, 5, 1, 0, 0;
    NewtonRow row;
    row.body1 = 1;
    row.body2 = 0;
    row.r1 = {0, 1, 0};
    row.r2 = {1, 0, 0};
    // V₁ + ω₁ × r₁ = (5, 5, 6),  V₂ + ω₂ × r₂ = (1, 4, 3)
    CHECK(u(row, v, {0, 0.5, 0}) == Vector3d(4, 0.5, 3));
    row.body2 = -1; // static
    CHECK(u(row, v, {0, 0, 0}) == Vector3d(5, 5, 6));
    CHECK(velocity(v, -1, {1, 2, 3}) == Vector3d(0, 0, 0));
}
