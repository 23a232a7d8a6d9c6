// SPDX-License-Identifier: MIT
// A7.4, A7.6 and A7.7 where something is nearly so, by any power of two: faces that are nearly
// parallel to a crack, edges that are cut near an end, corners next to a plane, and thin parts.
#include "element_laws.hpp"
#include "fracture_laws.hpp"
#include "virtual_nodes_laws.hpp"

#include <algorithm>
#include <cmath>

namespace rigor::testing::fracture_nearness_test {

namespace {

using Order = std::array<int, 4>;

// All orders of four corners.
std::vector<Order> all_orders()
{
    std::vector<Order> result;
    Order order = {0, 1, 2, 3};
    do
        result.push_back(order);
    while (std::next_permutation(order.begin(), order.end()));
    return result;
}

// The tetrahedron with these corners in this order.
TetrahedralMesh alone(const std::array<Vector3d, 4>& corners, const Order& order)
{
    TetrahedralMesh mesh = {{}, {{0, 1, 2, 3}}};
    for (const int c : order)
        mesh.vertices.push_back(corners[c]);
    return mesh;
}

// The place of a corner in an order.
int place(const Order& order, int corner)
{
    return corner_of(order, corner);
}

} // namespace

TEST_CASE("fracture: of faces that are nearly parallel to a crack the nearest one",
          "[A7.4][fracture]")
{
    // A flat tetrahedron: its tip, corner 3, is h above its foot. The normals of its faces are
    // (slope, 1), with slope 0 for the foot. A crack whose slope is a quarter of that of another
    // face is nearer to the foot, and one with three quarters of it is nearer to the other face. So
    // all |n_f·n| are 1 but for less than 16 h², and the largest is larger by 2 h² at least.
    int number = 0;
    for (int power = 3; power <= 23; power += 4)
        for (const Order& order : all_orders()) {
            const double h = std::ldexp(1, -power);
            const Vector3d slopes[] = {{2 * h, 2 * h, 0}, {-4 * h, 0, 0}, {0, -4 * h, 0}};
            const int axis = ++number % 3; // the axes x, y, z become axis, axis + 1, axis + 2
            const double sign = number % 2 == 0 ? 1 : -1, away = number % 5 == 0 ? 8 : 0;
            std::array<Vector3d, 4> x = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0),
                                         Vector3d(0.25, 0.25, h)};
            const auto turned = [axis](const Vector3d& v) {
                return Vector3d(v[(3 - axis) % 3], v[(4 - axis) % 3], v[(5 - axis) % 3]);
            };
            std::array<Vector3d, 4> tetrahedron;
            for (int i = 0; i < 4; ++i)
                tetrahedron[i] = turned(x[order[i]]) + Vector3d(away, -away, away);
            for (int other = 0; other < 3; ++other)
                for (const double part : {0.0, 0.25, 0.75, 1.0}) {
                    CAPTURE(power, order, axis, other, part);
                    const Vector3d n = (part * slopes[other] + Vector3d::UnitZ()).normalized();
                    REQUIRE_THAT(closest_face(tetrahedron, sign * turned(n)),
                                 IsExactly(place(order, part < 0.5 ? 3 : other)));
                }
        }
}

TEST_CASE("fracture: what is on the plane stays on it when the longest edge is cut",
          "[A7.6][fracture]")
{
    // The longest edge, of 1 m, is cut in two. Vertex 3 is nearer to the plane than 0.05 m, and
    // farther from it than 0.05 of any edge that is left.
    for (Random random : seeds(20))
        for (const double height : {0.035, 0.04, 0.045, 0.049, -0.035, -0.049}) {
            CAPTURE(height);
            const double x = random.uniform(0.1, 0.2), y = random.uniform(0.1, 0.2);
            const Placed at(
                {{{0, 0, 0}, {x, 0, 0.5}, {x, 0, -0.5}, {0, y, height}}, {{0, 1, 2, 3}}}, random);
            const SplitMesh result = cut_at(at.mesh, at.vertex[0], at.R * Vector3d::UnitZ());
            check_count(tetrahedron_count(result.mesh), 2, "tetrahedra");
        }
}

TEST_CASE("fracture: a plane may cross the longest edge near its ends", "[A7.6][fracture]")
{
    // The edge between the corners 1 and 2 is the longest. The plane through the corners 0 and 3
    // is farther from its end than 0.05 of its length, but hardly.
    const std::vector<Order> orders = all_orders();
    std::size_t number = 0;
    std::vector<double> lengths = {1, 20};
    for (Random random : seeds(3))
        lengths.push_back(random.uniform(0.1, 10));
    for (const double length : lengths)
        for (int power = 1; power <= 44; ++power)
            for (const double sign : {1.0, -1.0}) {
                const double t = 0.05 * (1 + std::ldexp(1, -power));
                const double h = t * length, r = 0.1 * length;
                const std::array<Vector3d, 4> corners = {Vector3d(0, 0, 0), Vector3d(r, h, 0),
                                                         Vector3d(r, h - length, 0),
                                                         Vector3d(r, 0, r)};
                TetrahedralMesh mesh;
                Order order{};
                do { // the next order that does not invert the tetrahedron
                    order = orders[++number % orders.size()];
                    mesh = alone(corners, order);
                } while (volume(mesh, 0) < 0);
                CAPTURE(length, power, sign, order);
                const int vertex = place(order, number % 4 < 2 ? 0 : 3);
                const SplitMesh result = cut_at(mesh, vertex, sign * Vector3d::UnitY());
                check_count(tetrahedron_count(result.mesh), 2, "tetrahedra");
                check_count(piece_count(result.mesh), 2, "pieces");
            }
}

namespace {

// The share of a tetrahedron above a plane, from the heights of its corners.
double share_above(const std::array<double, 4>& h)
{
    std::vector<double> up, down;
    for (const double height : h) {
        if (height > 0) up.push_back(height);
        if (height < 0) down.push_back(-height);
    }
    if (up.empty()) return 0;
    if (down.empty()) return 1;
    if (up.size() == 1) { // a tip: a product of fractions of edges
        double share = 1;
        for (const double below : down)
            share *= up[0] / (up[0] + below);
        return share;
    }
    if (down.size() == 1) {
        double share = 1;
        for (const double above : up)
            share *= down[0] / (down[0] + above);
        return 1 - share;
    }
    // three tetrahedra, with fractions of the cut edges
    const double pr = up[0] / (up[0] + down[0]), ps = up[0] / (up[0] + down[1]);
    const double qr = up[1] / (up[1] + down[0]), qs = up[1] / (up[1] + down[1]);
    return qr * qs + pr * ps * (1 - qr) + ps * qr * (1 - qs);
}

// Cracks a tetrahedron whose corners have these heights above the plane through `x` along an axis.
void check_heights(const std::array<double, 4>& h, double x, int axis, double sign)
{
    const std::array<std::array<double, 2>, 4> beside = {{{0, 0}, {1, 0}, {0, 1}, {3, 5}}};
    TetrahedralMesh mesh = {{}, {{0, 1, 2, 3}}};
    for (const double mirror : {1.0, -1.0}) {
        if (mirror < 0 && volume(mesh, 0) >= 0) break;
        mesh.vertices.clear();
        for (int i = 0; i < 4; ++i) {
            Vector3d v;
            v[axis] = x + h[i];
            v[(axis + 1) % 3] = beside[i][0];
            v[(axis + 2) % 3] = mirror * beside[i][1];
            mesh.vertices.push_back(v);
        }
    }
    Tetrahedron above{}, below{};
    std::array<double, 4> heights{};
    for (int i = 0; i < 4; ++i) {
        heights[i] = sign * h[i];
        above[i] = heights[i] >= 0;
        below[i] = 1 - above[i];
    }
    const EmbeddedMesh result =
        embedded(mesh, {{0, x * Vector3d::Unit(axis), sign * Vector3d::Unit(axis)}});
    std::vector<Tetrahedron> real = {above, below};
    std::vector<double> shares = {share_above(heights), 1 - share_above(heights)};
    const Tetrahedron none = {0, 0, 0, 0};
    for (const std::size_t i : {1, 0})
        if (real[i] == none) {
            real.erase(real.begin() + static_cast<std::ptrdiff_t>(i));
            shares = {1};
        }
    if (real.size() == 2 && real[0] < real[1]) {
        std::swap(real[0], real[1]);
        std::swap(shares[0], shares[1]);
    }
    REQUIRE_THAT(result.real, IsExactly(real));
    check_shares(result, shares, Rounding(64, 1));
}

} // namespace

TEST_CASE("fracture: a corner next to a plane is on its own side of it", "[A7.7][fracture]")
{
    // One corner is `near` above or below the plane, and the others are on it, as near to it, or
    // farther away by any power of two. All heights are exact.
    std::vector<int> powers;
    for (int power = 1; power <= 61; power += 3)
        powers.push_back(power);
    for (int power = 100; power <= 500; power += 100)
        powers.push_back(power);
    int number = 0;
    for (const int power : powers)
        for (int corner = 0; corner < 4; ++corner)
            for (const double near : {std::ldexp(1, -power), std::ldexp(-1, -power)})
                for (const auto& others : {std::array<double, 3>{1, 1, 1},
                                           {-1, -1, -1},
                                           {1, -1, 1},
                                           {1, 0, 2},
                                           {-near, -1, 1},
                                           {-near, near, -1},
                                           {-4 * near, 2 * near, -0.5}}) {
                    const double size = power < 100 && ++number % 3 == 0 ? 0x1p-30 : 1;
                    const double x = power <= 40 && number % 2 == 0 ? 8 * size : 0;
                    std::array<double, 4> h{};
                    for (int i = 0; i < 4; ++i)
                        h[i] = size * (i == corner ? near : others[i < corner ? i : i - 1]);
                    const int axis = number % 5 % 3;
                    const double sign = number / 2 % 2 == 0 ? 1 : -1;
                    CAPTURE(power, h, x, axis, sign);
                    check_heights(h, x, axis, sign);
                }
}

namespace {

// Cracks a tetrahedron along y = u, x = 0 and z = 0, in this order, in all orders of its corners.
// Each corner is then alone, with these shares.
void check_three_cracks(const std::array<Vector3d, 4>& corners, double u,
                        const std::array<double, 4>& shares)
{
    unsigned number = 0;
    for (const Order& order : all_orders()) {
        const TetrahedralMesh mesh = alone(corners, order);
        if (volume(mesh, 0) < 0) continue;
        const auto sign = [bits = ++number](int i) { return (bits >> i & 1u) == 0 ? 1.0 : -1.0; };
        CAPTURE(u, order);
        const EmbeddedMesh result =
            virtual_nodes(mesh, {{0, {0, u, 0}, sign(0) * Vector3d::UnitY()},
                                 {0, {0, 0, 0}, sign(1) * Vector3d::UnitX()},
                                 {0, {0, 0, 0}, sign(2) * Vector3d::UnitZ()}});
        REQUIRE_THAT(result.real, IsExactly(std::vector<Tetrahedron>{
                                      {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}));
        std::vector<double> expected;
        for (const int c : order)
            expected.push_back(shares[c]);
        check_shares(result, expected, Rounding(64, 1));
    }
}

} // namespace

TEST_CASE("fracture: later cracks divide a part however thin it is", "[A7.7][fracture]")
{
    // a, b, c and d are the distances of corners from the planes x = 0 and z = 0, in which the
    // other corners lie
    for (const auto& [a, b, c, d] : {std::array<double, 4>{1, 1, 1, 1}, {1, 3, 2, 1}, {7, 1, 1, 2}})
        for (int power = 1; power <= 45; ++power) {
            CAPTURE(a, b, c, d, power);
            const double u = std::ldexp(1, -power);
            const double near_a = a / (a + b), near_c = c / (c + d);
            // the first crack leaves a slab with the corners 1, 2 and 3
            const double slab = u * (3 - 3 * u + u * u), rest = slab * (1 - near_a * near_a);
            check_three_cracks(
                {Vector3d(0, 1, 0), Vector3d(a, 0, 0), Vector3d(-b, 0, c), Vector3d(-b, 0, -d)}, u,
                {1 - slab, slab * near_a * near_a, rest * near_c, rest * (1 - near_c)});
            if (power > 23) continue;
            // the first crack leaves a wedge with the corners 0 and 1
            const double wedge = u * u * (3 - 2 * u);
            check_three_cracks(
                {Vector3d(a, 0, 0), Vector3d(-b, 0, 0), Vector3d(0, 1, c), Vector3d(0, 1, -d)}, u,
                {wedge * near_a, wedge * (1 - near_a), (1 - wedge) * near_c,
                 (1 - wedge) * (1 - near_c)});
        }
}

} // namespace rigor::testing::fracture_nearness_test
