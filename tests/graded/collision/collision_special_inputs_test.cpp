// SPDX-License-Identifier: MIT
// A4: inputs that a special case easily swallows: collisions that do not slide but whose K couples
// the directions, negative restitutions, jams of every kind, and long or large grids.
#include "formulas/collision.hpp"
#include "sliding_pair.hpp"
#include "support/close.hpp"

#include <stdexcept>

namespace collision_special_inputs_test {

using namespace rigor;
using namespace rigor::testing;

namespace {

// K of a leaning rod, and below it K of a contact that jams from μ = 2 on if it slides along x.
Matrix3d leaning()
{
    Matrix3d K;
    K << 2.5, -1.5, 0, -1.5, 2.5, 0, 0, 0, 4;
    return K;
}

Matrix3d jamming()
{
    Matrix3d K;
    K << 3, 2, 2, 2, 4, 1, 2, 1, 2;
    return K;
}

Vector3d sticking(const Matrix3d& K, const Vector3d& v, double restitution)
{
    return K.inverse() * (-v - restitution * v.dot(up) * up);
}

// The size of the terms whose sum is the sticking impulse [N s].
double terms_of_sticking(const Matrix3d& K, const Vector3d& v, double restitution)
{
    return K.inverse().norm() * (1 + std::abs(restitution)) * v.norm();
}

// The sticking impulse, shortened to the cone.
Vector3d jammed(const Matrix3d& K, const Vector3d& v, double restitution, double friction)
{
    const Vector3d j = sticking(K, v, restitution), j_T = tangential(j, up);
    const double j_n = j.dot(up);
    if (j_n <= 0) return Vector3d::Zero();
    return j_n * up + std::min(1.0, friction * j_n / j_T.norm()) * j_T;
}

// Topic `contact` uses -1 < ε ≤ 0, and ε = -1 + 1/n in the first of n iterations.
constexpr double negative_restitutions[] = {-1,     -1 + 0x1p-44, -1 + 0x1p-31, -1 + 0x1p-20,
                                            -0.999, -0.95,        -0.9,         -0.5,
                                            -0.1,   -0x1p-20,     -0x1p-44};
constexpr double restitutions[] = {-1, -1 + 0x1p-40, -0.95, -0.5, 0, 0.5, 1};
constexpr double jamming_frictions[] = {2.5, 3, 6, 2000};

LevelSet grid_of(const std::array<int, 3>& size, double (*value)(const Vector3d& node))
{
    LevelSet grid;
    grid.cell_size = 1;
    grid.size = size;
    for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
            for (int i = 0; i < size[0]; ++i)
                grid.distances.push_back(value(Vector3d(i, j, k)));
    return grid;
}

double square(const Vector3d& node)
{
    return node.squaredNorm();
}

double slope(const Vector3d& node)
{
    return node.dot(Vector3d(1, 2, 3));
}

} // namespace

TEST_CASE("collision: what falls straight sticks where K couples the directions",
          "[A4.9][collision]")
{
    const Vector3d v = -up;
    REQUIRE_THAT(collision_impulse(leaning(), v, up, 0.5, 1),
                 IsClose(Vector3d(0.5625, 0.9375, 0), Rounding(32)));
    for (const Matrix3d& K : {leaning(), jamming()})
        for (const double restitution : restitutions)
            for (const double friction : {0.1, 1.0, 5.0}) {
                CAPTURE(K, restitution, friction);
                const Vector3d j = sticking(K, v, restitution);
                const bool sticks = tangential(j, up).norm() <= friction * j.dot(up);
                const Vector3d frictionless = (1 + restitution) / K(1, 1) * up;
                const double scale = terms_of_sticking(K, v, restitution);
                REQUIRE_THAT(collision_impulse(K, v, up, restitution, friction),
                             IsClose(sticks ? j : frictionless, Rounding(64, scale)));
            }
}

TEST_CASE("collision: a negative restitution of an impulse without friction", "[A4.5][collision]")
{
    const Matrix3d K = leaning();
    for (const double v_n : {-2, 2}) // also of bodies that separate
        for (const double restitution : negative_restitutions) {
            CAPTURE(v_n, restitution);
            const Vector3d j = -(1 + restitution) * v_n / K(1, 1) * up;
            REQUIRE_THAT(frictionless_impulse(K, {3, v_n, 1}, up, restitution),
                         IsClose(j, Rounding(16, 1)));
        }
}

TEST_CASE("collision: a negative restitution of what sticks", "[A4.6][collision]")
{
    const Matrix3d K = leaning();
    for (const double v_n : {-2, 2}) // also of bodies that separate
        for (const double restitution : negative_restitutions) {
            CAPTURE(v_n, restitution);
            const Vector3d v(3, v_n, 1);
            REQUIRE_THAT(static_friction_impulse(K, v, up, restitution),
                         IsClose(sticking(K, v, restitution),
                                 Rounding(64, terms_of_sticking(K, v, restitution))));
        }
}

TEST_CASE("collision: a negative restitution of what slides", "[A4.8][collision]")
{
    const Matrix3d K = leaning();
    const double friction = 0.3;
    for (const Vector3d& T : {Vector3d(1, 0, 0), Vector3d(-1, 0, 0), Vector3d(0, 0, 1)})
        for (const double v_n : {-2, 2}) // also of bodies that separate
            for (const double restitution : negative_restitutions) {
                CAPTURE(T, v_n, restitution);
                const Vector3d cone = up - friction * T, v = 5 * T + v_n * up;
                const double j_n = -(1 + restitution) * v_n / up.dot(K * cone);
                REQUIRE_THAT(sliding_friction_impulse(K, v, up, restitution, friction),
                             IsClose(Vector3d(j_n * cone), Rounding(64, 1)));
            }
}

TEST_CASE("collision: a negative restitution leaves a part of the approach", "[A4.9][collision]")
{
    for (const double restitution : negative_restitutions) {
        CAPTURE(restitution);
        REQUIRE_THAT(collision_impulse(Matrix3d::Identity(), -up, up, restitution, 1),
                     IsClose(Vector3d((1 + restitution) * up), Rounding(16, 1)));
    }
}

namespace {

// Checks an impulse wherever the contact jams.
template <class Impulse> void check_jams(Impulse impulse, std::initializer_list<double> v_ns)
{
    const Matrix3d K = jamming();
    int jams = 0;
    for (const Vector3d& v_T : {Vector3d(2, 0, 0), Vector3d(0, 0, 1), Vector3d(1, 0, 1)})
        for (const double v_n : v_ns)
            for (const double restitution : restitutions)
                for (const double friction : jamming_frictions) {
                    const Vector3d v = v_n * up + v_T;
                    if (up.dot(K * (up - friction * v_T.normalized())) > 0) continue;
                    const Vector3d j = sticking(K, v, restitution);
                    const double j_n = std::abs(j.dot(up));
                    if (j_n < 1e-9 * j.norm()) continue; // rounding decides whether it pulls
                    CAPTURE(v, restitution, friction);
                    ++jams;
                    // an error of j_n is magnified by at most |j|/j_n where j_T is shortened
                    const double scale = terms_of_sticking(K, v, restitution) * j.norm() / j_n;
                    REQUIRE_THAT(impulse(K, v, up, restitution, friction),
                                 IsClose(jammed(K, v, restitution, friction), Rounding(64, scale)));
                }
    if (jams == 0) throw std::logic_error("no case jams");
}

} // namespace

TEST_CASE("collision: a contact jams at any restitution, also without approach",
          "[A4.8][collision]")
{
    check_jams(sliding_friction_impulse, {-2.0, -1.0, 0.0});
}

TEST_CASE("collision: the impulse of a jam at any restitution", "[A4.9][collision]")
{
    check_jams(collision_impulse, {-2.0, -1.0});
}

TEST_CASE("collision: the last cells of long and large grids", "[A4.1][collision]")
{
    for (int axis = 0; axis < 3; ++axis) {
        std::array<int, 3> size = {2, 2, 2};
        for (const int count : {300, 70'000}) {
            size[axis] = count;
            const LevelSet grid = grid_of(size, square);
            // half-way between two nodes, where the other coordinates are 0
            const double node = count - 3;
            const Vector3d p = (node + 0.5) * Vector3d::Unit(axis);
            REQUIRE_THAT(sample_level_set(grid, p),
                         IsClose((node * node + (node + 1) * (node + 1)) / 2, Rounding(16)));
        }
    }
    const LevelSet large = grid_of({41, 41, 41}, slope);
    REQUIRE_THAT(sample_level_set(large, {40, 40, 40}), IsClose(240.0, Rounding(16)));
    REQUIRE_THAT(sample_level_set(large, {39.5, 39.5, 39.5}), IsClose(237.0, Rounding(16)));
}

TEST_CASE("collision: the normal in the last cells of long and large grids", "[A4.2][collision]")
{
    for (int axis = 0; axis < 3; ++axis) {
        std::array<int, 3> size = {2, 2, 2};
        for (const int count : {300, 70'000}) {
            size[axis] = count;
            const Vector3d p = (count - 2.5) * Vector3d::Unit(axis);
            // the slope of the squares is 2 count - 5 along the axis and 1 across it
            const Vector3d gradient = Vector3d::Ones() + (2 * count - 6) * Vector3d::Unit(axis);
            REQUIRE_THAT(level_set_normal(grid_of(size, square), p),
                         IsClose(Vector3d(gradient.normalized()), Rounding(64)));
        }
    }
    REQUIRE_THAT(level_set_normal(grid_of({41, 41, 41}, slope), {39.5, 39.5, 39.5}),
                 IsClose(Vector3d(Vector3d(1, 2, 3).normalized()), Rounding(256)));
}

} // namespace collision_special_inputs_test
