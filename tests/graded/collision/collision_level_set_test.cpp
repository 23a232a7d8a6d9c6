// SPDX-License-Identifier: MIT
// A4.1 and A4.2: signed distances on a grid.
#include "formulas/collision.hpp"
#include "support/close.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <array>
#include <cmath>

namespace rigor::testing {

namespace {

template <class Function>
LevelSet sampled(const Vector3d& origin, double h, const std::array<int, 3>& size,
                 const Function& phi)
{
    LevelSet grid{origin, h, size, {}};
    for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
            for (int i = 0; i < size[0]; ++i)
                grid.distances.push_back(phi(origin + h * Vector3d(i, j, k)));
    return grid;
}

// One cell of the level set of a unit sphere. The point p of the sphere is in the cell, at the
// fractions `at` of its edges.
LevelSet cell_of_sphere(const Vector3d& p, double h, const Vector3d& at)
{
    const auto sphere = [](const Vector3d& x) { return x.norm() - 1; };
    return sampled(p - h * at, h, {2, 2, 2}, sphere);
}

// The function a + b x + c y + d z + e xy + f yz + g zx + h xyz, which trilinear interpolation
// reproduces exactly.
struct Trilinear {
    std::array<double, 8> c{};

    explicit Trilinear(Random& random)
    {
        for (double& coefficient : c)
            coefficient = random.uniform(-1, 1);
    }
    double operator()(const Vector3d& p) const
    {
        const double x = p.x(), y = p.y(), z = p.z();
        return c[0] + c[1] * x + c[2] * y + c[3] * z + c[4] * x * y + c[5] * y * z + c[6] * z * x +
               c[7] * x * y * z;
    }
    Vector3d gradient(const Vector3d& p) const
    {
        const double x = p.x(), y = p.y(), z = p.z();
        return {c[1] + c[4] * y + c[6] * z + c[7] * y * z,
                c[2] + c[4] * x + c[5] * z + c[7] * z * x,
                c[3] + c[5] * y + c[6] * x + c[7] * x * y};
    }
};

// Three, four and five nodes, so that no two axes can be mistaken for each other.
const std::array<int, 3> some_size = {3, 4, 5};

Vector3d point_inside(Random& random, const LevelSet& grid)
{
    const auto along = [&](int axis) {
        return random.uniform(0, grid.cell_size * (grid.size[axis] - 1));
    };
    const double x = along(0), y = along(1), z = along(2);
    return grid.origin + Vector3d(x, y, z);
}

// The level set φ = x - 1 on [0, 2] × [0, 3] × [0, 4].
const LevelSet slab =
    sampled(Vector3d::Zero(), 1, some_size, [](const Vector3d& p) { return p.x() - 1; });

} // namespace

TEST_CASE("collision: a level set has the value of a node at that node", "[A4.1][collision]")
{
    Random random(1);
    const Vector3d origin(-0.5, 2, 1);
    const LevelSet grid =
        sampled(origin, 0.25, some_size, [&](const Vector3d&) { return random.uniform(-1, 1); });

    int index = 0;
    for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 3; ++i, ++index) {
                CAPTURE(i, j, k);
                const double distance = sample_level_set(grid, origin + 0.25 * Vector3d(i, j, k));
                REQUIRE_THAT(distance, IsClose(grid.distances[index], Rounding(8, 1)));
            }
}

TEST_CASE("collision: cells of any size meet at their nodes", "[A4.1][collision]")
{
    // A cell size such as 0.1 m is rounded, so a node may seem to lie a little before its place or
    // after it.
    std::vector<double> sizes = {0.1, 0.2, 0.3, 0.6, 0.7, 1.0 / 3, 0.05, 0.01};
    for (Random random : seeds(20))
        sizes.push_back(random.uniform(0.01, 1));
    Random random(3);
    for (const double h : sizes)
        for (const bool is_at_origin : {true, false}) {
            const Vector3d origin = is_at_origin ? Vector3d(Vector3d::Zero()) : random.vector();
            const LevelSet grid = sampled(origin, h, {50, 2, 3},
                                          [&](const Vector3d&) { return random.uniform(-1, 1); });
            for (int i = 0; i < 50; ++i) {
                CAPTURE(h, origin, i);
                // rounding moves the node by some eps (50 h + 1), and a cell changes by 2/h
                REQUIRE_THAT(
                    sample_level_set(grid, origin + h * Vector3d(i, 1, 2)),
                    IsClose(grid.distances[i + 50 * (1 + 2 * 2)], Rounding(16, 2 * (50 + 1 / h))));
            }
        }
}

TEST_CASE("collision: between its nodes a level set is trilinear", "[A4.1][collision]")
{
    for (Random random : seeds(50)) {
        const Trilinear phi(random);
        const LevelSet grid = sampled(random.vector(), 0.3, some_size, phi);
        const Vector3d p = point_inside(random, grid);

        // eight terms; coordinates are at most 1.6, 1.9 and 2.2, so each term is less than 8
        REQUIRE_THAT(sample_level_set(grid, p), IsClose(phi(p), Rounding(64, 8 * 8)));
    }
}

TEST_CASE("collision: inside a solid the distance is negative", "[A4.1][collision]")
{
    REQUIRE_THAT(sample_level_set(slab, Vector3d(0.25, 1.5, 2)), IsClose(-0.75, Rounding(8)));
    REQUIRE_THAT(sample_level_set(slab, Vector3d(1.5, 1.5, 2)), IsClose(0.5, Rounding(8)));
    REQUIRE_THAT(sample_level_set(slab, Vector3d(1, 1.5, 2)), IsClose(0.0, Rounding(8, 1)));
}

TEST_CASE("collision: outside the grid the distance to its box is added", "[A4.1][collision]")
{
    // points beyond a face, an edge and a corner; φ = 1, 1, -1 at the nearest points of the box
    REQUIRE_THAT(sample_level_set(slab, Vector3d(5, 1, 1)), IsClose(1 + 3.0, Rounding(16)));
    REQUIRE_THAT(sample_level_set(slab, Vector3d(5, 7, 1)), IsClose(1 + 5.0, Rounding(16)));
    REQUIRE_THAT(sample_level_set(slab, Vector3d(-2, -3, 10)), IsClose(-1 + 7.0, Rounding(16)));
    // a point beside the box, where φ = -0.5
    REQUIRE_THAT(sample_level_set(slab, Vector3d(0.5, -2, 1)), IsClose(-0.5 + 2, Rounding(16)));
    // on the border nothing is added
    REQUIRE_THAT(sample_level_set(slab, Vector3d(2, 3, 4)), IsClose(1.0, Rounding(16)));
}

TEST_CASE("collision: beyond each face, edge and corner the distance to the box is added",
          "[A4.1][collision]")
{
    // the 27 regions into which the planes of the box divide space: below, between and above them
    for (int region = 0; region < 27; ++region)
        for (Random random : seeds(8)) {
            const std::array<int, 3> place = {region % 3, region / 3 % 3, region / 9};
            const Trilinear phi(random);
            const LevelSet grid = sampled(random.vector(), 0.5, some_size, phi);
            const Vector3d nearest_in = point_inside(random, grid);
            Vector3d p = nearest_in, nearest = nearest_in;
            for (int axis = 0; axis < 3; ++axis) {
                const double low = grid.origin[axis], high = low + 0.5 * (some_size[axis] - 1);
                if (place[axis] == 1) continue;
                nearest[axis] = place[axis] == 0 ? low : high;
                p[axis] = nearest[axis] + (place[axis] - 1) * random.uniform(0.01, 3);
            }
            CAPTURE(p, nearest);
            REQUIRE_THAT(sample_level_set(grid, p),
                         IsClose(phi(nearest) + (p - nearest).norm(), Rounding(64, 32)));
        }
}

TEST_CASE("collision: a small way beyond a face counts beside a long one", "[A4.1][collision]")
{
    const Vector3d corner(2, 3, 4); // the highest one, where φ = 1
    for (int axis = 0; axis < 3; ++axis)
        for (const double far : {0.125, 1.0, 1024.0})
            for (int power = 0; power <= 22; ++power) {
                const double near = std::ldexp(far, -power);
                CAPTURE(axis, far, near);
                Vector3d p = corner;
                p[axis] += far;
                p[(axis + 1) % 3] += near;
                const double away = std::hypot(far, near);
                REQUIRE_THAT(sample_level_set(slab, p), IsClose(1 + away, Rounding(16, 1 + away)));
            }
}

TEST_CASE("collision: far outside the grid the distance is finite", "[A4.1][collision]")
{
    for (double far : {1e6, 1e9, 1e12, 1e20, 1e100}) {
        CAPTURE(far);
        REQUIRE_THAT(sample_level_set(slab, Vector3d(far, 1, 1)),
                     IsClose(1 + (far - 2), Rounding(16)));
        REQUIRE_THAT(sample_level_set(slab, Vector3d(-far, 1, 1)), IsClose(-1 + far, Rounding(16)));
    }
}

TEST_CASE("collision: a sphere's level set is off by a quarter of the squared cell size",
          "[A4.1][collision]")
{
    for (Random random : seeds(10)) {
        const Vector3d p = random.unit_vector();
        std::vector<double> errors;
        for (double h : {0.1, 0.05, 0.025}) {
            const LevelSet grid = cell_of_sphere(p, h, Vector3d::Constant(0.5));
            errors.push_back(sample_level_set(grid, p));
            // |x| has the Laplacian 2/|x|: the mean of the corners is off by h²/8 times that
            REQUIRE_THAT(errors.back(), IsClose(h * h / 4, Order(h * h * h * h)));
        }
        check_order(errors, 2);
    }
}

TEST_CASE("collision: no point of a sphere's level set is off by more", "[A4.1][collision]")
{
    for (Random random : seeds(100)) {
        const double h = 1.0 / 64;
        const Vector3d p = random.unit_vector();
        const Vector3d at = (random.vector() + Vector3d::Ones()) / 2;
        const double error = std::abs(sample_level_set(cell_of_sphere(p, h, at), p));
        // the second derivatives of |x| vary by about h within the cell
        check_at_most(error, h * h / 4 * (1 + 4 * h), "the error of the sampled sphere");
    }
}

TEST_CASE("collision: the normal of a plane's level set is the plane's", "[A4.2][collision]")
{
    for (Random random : seeds(50)) {
        const Vector3d n = random.unit_vector();
        const LevelSet grid = sampled(random.vector(), 0.3, some_size,
                                      [&](const Vector3d& x) { return x.dot(n) - 0.2; });
        const Vector3d p = point_inside(random, grid);

        // A difference over a cell magnifies the rounding of the distances by 1/h.
        REQUIRE_THAT(level_set_normal(grid, p), IsClose(n, Rounding(32, 1 / 0.3)));
    }
}

TEST_CASE("collision: the normal is the gradient inside the cell", "[A4.2][collision]")
{
    for (Random random : seeds(100)) {
        const Trilinear phi(random);
        const LevelSet grid = sampled(random.vector(), 0.3, some_size, phi);
        const Vector3d p = point_inside(random, grid);
        const Vector3d gradient = phi.gradient(p);

        // the rounding of φ, divided by the cell size, relative to the gradient
        const double scale = 8 * 8 / 0.3 / gradient.norm();
        REQUIRE_THAT(level_set_normal(grid, p),
                     IsClose(gradient.normalized(), Rounding(32, scale)));
    }
}

TEST_CASE("collision: the normal of a steep or a flat level set is unit", "[A4.2][collision]")
{
    for (double slope : {1e-6, 0.1, 3.0, 1e6}) {
        CAPTURE(slope);
        const LevelSet grid = sampled(Vector3d::Zero(), 0.5, some_size, [&](const Vector3d& p) {
            return slope * (3 * p.x() - 4 * p.z());
        });
        const Vector3d n = level_set_normal(grid, Vector3d(0.3, 0.2, 1.1));
        REQUIRE_THAT(n, IsClose(Vector3d(0.6, 0, -0.8), Rounding(64)));
    }
}

TEST_CASE("collision: a point on a face between cells belongs to the higher cell",
          "[A4.2][collision]")
{
    // along each axis in turn, φ is level in the first cell and rises in the second and last one
    for (int axis = 0; axis < 3; ++axis) {
        CAPTURE(axis);
        const int across = (axis + 1) % 3;
        const LevelSet grid = sampled(Vector3d::Zero(), 1, {3, 3, 3}, [&](const Vector3d& p) {
            return p[across] / 2 + (p[axis] == 2 ? 0.5 : 0.0);
        });
        const auto at = [&](double place) {
            Vector3d p = Vector3d::Constant(0.5);
            p[axis] = place;
            return level_set_normal(grid, p);
        };
        const Vector3d level = Vector3d::Unit(across);
        const Vector3d rising = (Vector3d::Unit(across) + Vector3d::Unit(axis)).normalized();

        REQUIRE_THAT(at(0.5), IsClose(level, Rounding(8)));
        REQUIRE_THAT(at(1), IsClose(rising, Rounding(8)));
        REQUIRE_THAT(at(1.5), IsClose(rising, Rounding(8)));
        REQUIRE_THAT(at(2), IsClose(rising, Rounding(8))); // on the last face the last cell counts
    }
}

TEST_CASE("collision: a point on faces of several cells belongs to the highest of them",
          "[A4.2][collision]")
{
    // Along each axis of the mask, the coordinate of the point is that of a face between cells: so
    // the point lies on a face, on an edge (two axes) or at a node (three axes). A point slightly
    // higher along all axes lies in the same cell, and the gradient there is nearly the same.
    for (int mask = 1; mask < 8; ++mask)
        for (Random random : seeds(8)) {
            const LevelSet grid = sampled(Vector3d::Zero(), 0.5, {4, 4, 4}, [&](const Vector3d& p) {
                return p.x() + p.y() + p.z() + 0.2 * random.uniform(-1, 1);
            });
            Vector3d p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = 0.5 * static_cast<double>(random.bits() % 3) +
                          (mask >> axis & 1 ? 0 : 0.5 * random.uniform(0.1, 0.9));
            CAPTURE(mask, p);
            REQUIRE_THAT(
                level_set_normal(grid, p),
                IsClose(level_set_normal(grid, p + 0x1p-30 * Vector3d::Ones()), Order(0x1p-24)));
        }
}

TEST_CASE("collision: outside the grid the normal is that of the nearest point",
          "[A4.2][collision]")
{
    for (Random random : seeds(50)) {
        const Trilinear phi(random);
        const LevelSet grid = sampled(Vector3d::Zero(), 0.5, some_size, phi);
        const Vector3d p = 10 * random.vector();
        const Vector3d nearest = p.cwiseMax(0).cwiseMin(Vector3d(1, 1.5, 2));
        const Vector3d gradient = phi.gradient(nearest);

        const double scale = 8 * 8 / 0.5 / gradient.norm();
        REQUIRE_THAT(level_set_normal(grid, p),
                     IsClose(gradient.normalized(), Rounding(32, scale)));
    }
    REQUIRE_THAT(level_set_normal(slab, Vector3d(1e100, -1e100, 0)),
                 IsClose(Vector3d(1, 0, 0), Rounding(8)));
}

TEST_CASE("collision: beyond each face, edge and corner the normal is that of the nearest point",
          "[A4.2][collision]")
{
    // Along some axes p lies outside of the grid, near it or far away. Along the others p lies in
    // the middle of a cell or on a face, where it belongs to the higher cell.
    for (int region = 0; region < 27; ++region)
        for (Random random : seeds(12)) {
            const LevelSet grid = sampled(Vector3d::Zero(), 0.5, {4, 4, 4}, [&](const Vector3d& p) {
                return p.x() + p.y() + p.z() + 0.2 * random.uniform(-1, 1);
            });
            const std::array<int, 3> place = {region % 3, region / 3 % 3, region / 9};
            Vector3d p, inside;
            for (int axis = 0; axis < 3; ++axis) {
                const double face = 0.5 * random_index(random, 3), low = 0, high = 1.5;
                const double away =
                    random.uniform(1, 2) * std::ldexp(1, random_index(random, 80) - 8);
                p[axis] = place[axis] == 0 ? low - away : high + away;
                if (place[axis] == 1) p[axis] = face + random_index(random, 2) * 0.25;
                inside[axis] = std::min(std::max(p[axis], low) + 0x1p-30, high - 0x1p-30);
            }
            CAPTURE(p, inside);
            REQUIRE_THAT(level_set_normal(grid, p),
                         IsClose(level_set_normal(grid, inside), Order(0x1p-24)));
        }
}

TEST_CASE("collision: where the gradient is zero the normal points up", "[A4.2][collision]")
{
    const LevelSet level =
        sampled(Vector3d::Zero(), 1, some_size, [](const Vector3d&) { return 0.5; });
    REQUIRE_THAT(level_set_normal(level, Vector3d(0.5, 1.25, 3.5)), IsExactly(Vector3d(0, 1, 0)));
    REQUIRE_THAT(level_set_normal(level, Vector3d(9, 1.25, -3)), IsExactly(Vector3d(0, 1, 0)));

    // the middle of a saddle, where the gradient is 0
    const LevelSet saddle = sampled(Vector3d::Zero(), 1, {2, 2, 2}, [](const Vector3d& p) {
        return (p.x() - 0.5) * (p.y() - 0.5) * (p.z() - 0.5);
    });
    REQUIRE_THAT(level_set_normal(saddle, Vector3d(0.5, 0.5, 0.5)), IsExactly(Vector3d(0, 1, 0)));
}

TEST_CASE("collision: the normal of a sampled sphere points outward", "[A4.2][collision]")
{
    for (Random random : seeds(10)) {
        const Vector3d p = random.unit_vector();
        std::vector<double> errors;
        for (double h : {0.02, 0.01, 0.005}) {
            const LevelSet grid = cell_of_sphere(p, h, Vector3d(0.1, 0.3, 0.8));
            const Vector3d n = level_set_normal(grid, p);
            errors.push_back((n - p).norm());
            // second derivatives are at most 1, and p is at most 0.4 h from the middle of the cell
            // along each axis
            REQUIRE_THAT(n, IsClose(p, Order(h)));
        }
        check_order(errors, 1);
    }
}

} // namespace rigor::testing
