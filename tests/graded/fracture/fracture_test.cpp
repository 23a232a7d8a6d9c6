// SPDX-License-Identifier: MIT
// A7.1 to A7.4: where a solid cracks.
#include "fracture_cases.hpp"
#include "support/close.hpp"
#include "support/in_words.hpp"
#include "support/seeds.hpp"

#include <numbers>

namespace rigor::testing {

namespace {

using Neighbours = std::vector<std::vector<int>>;

const double root2 = std::numbers::sqrt2, root3 = std::numbers::sqrt3;

Matrix3d stress_of(const Vector3d& principal, const Matrix3d& Q)
{
    const Matrix3d sigma = Q * principal.asDiagonal() * Q.transpose();
    return (sigma + sigma.transpose()) / 2;
}

// Checks a unit vector, which may have either sign.
void check_direction(const Vector3d& actual, const Vector3d& expected, double k = 64)
{
    REQUIRE_THAT(actual.norm(), IsClose(1.0, Rounding(64, 1)));
    const double sign = actual.dot(expected) < 0 ? -1 : 1;
    REQUIRE_THAT(actual, IsClose(Vector3d(sign * expected), Rounding(k, 1)));
}

// Checks that σ d = σ₁ d and |d| = 1.
void check_eigenvector(const Matrix3d& sigma, const PrincipalStress& principal)
{
    const Vector3d& d = principal.direction;
    REQUIRE_THAT(d.norm(), IsClose(1.0, Rounding(64, 1)));
    REQUIRE_THAT(Vector3d(sigma * d),
                 IsClose(Vector3d(principal.stress * d), Rounding(256, sigma.norm())));
}

const Matrix3d tridiagonal{{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}};

Neighbours random_neighbours(Random& random, int count)
{
    Neighbours result(count);
    for (int a = 0; a < count; ++a)
        for (int b = 0; b < a; ++b)
            if (random.uniform(0, 1) < 0.4) {
                result[a].push_back(b);
                result[b].push_back(a);
            }
    return result;
}

} // namespace

TEST_CASE("fracture: a stress and its neighbours' are averaged by volume", "[A7.1][fracture]")
{
    const Matrix3d A = tridiagonal, B = Vector3d(1, 2, 3).asDiagonal(), C = Matrix3d::Ones();
    const std::vector<Matrix3d> stresses = {A, B, C};
    // a chain of three elements of 1, 2 and 5 m³
    const std::vector<Matrix3d> smooth = smooth_stress(stresses, {{1}, {0, 2}, {1}}, {1, 2, 5});
    const std::vector<Matrix3d> expected = {(A + 2 * B) / 3, (A + 2 * B + 5 * C) / 8,
                                            (2 * B + 5 * C) / 7};
    REQUIRE_THAT(smooth, IsClose(expected, Rounding(8, 5)));
}

TEST_CASE("fracture: an element without neighbours keeps its stress", "[A7.1][fracture]")
{
    const std::vector<Matrix3d> stresses = {tridiagonal, 2 * tridiagonal};
    REQUIRE_THAT(smooth_stress(stresses, {{}, {}}, {0.5, 3}), IsClose(stresses, Rounding(4, 8)));
    check_count(smooth_stress({}, {}, {}).size(), 0, "stresses");
}

TEST_CASE("fracture: a neighbour counts as often as it is named", "[A7.1][fracture]")
{
    const Matrix3d A = tridiagonal, B = Matrix3d::Ones();
    // The elements have 1 and 2 m³. The first names the second twice, and the second names the
    // first and itself.
    const std::vector<Matrix3d> smooth = smooth_stress({A, B}, {{1, 1}, {0, 1}}, {1, 2});
    const std::vector<Matrix3d> expected = {(A + 4 * B) / 5, (A + 4 * B) / 5};
    REQUIRE_THAT(smooth, IsClose(expected, Rounding(8, 5)));
}

TEST_CASE("fracture: what has no volume does not count in an average", "[A7.1][fracture]")
{
    const Matrix3d A = tridiagonal, B = Matrix3d::Ones(), O = Matrix3d::Zero();
    REQUIRE_THAT(smooth_stress({A, B}, {{1}, {0}}, {1, 0}),
                 IsClose(std::vector<Matrix3d>{A, A}, Rounding(4, 4)));
    // where no element has volume, a stress stays what it is
    REQUIRE_THAT(smooth_stress({A, B, O}, {{1}, {0}, {}}, {0, 0, 0}),
                 IsExactly(std::vector<Matrix3d>{A, B, O}));
}

TEST_CASE("fracture: neighbours without volume at any place in the list", "[A7.1][fracture]")
{
    // an element and three neighbors, each with a volume of 0, 1 or 2 m³, in every combination
    const std::vector<Matrix3d> stresses = {tridiagonal, Matrix3d::Ones(), Matrix3d::Identity(),
                                            Vector3d(1, 2, 3).asDiagonal()};
    for (int pattern = 0; pattern < 81; ++pattern) {
        CAPTURE(pattern);
        const std::vector<double> V = {double(pattern % 3), double(pattern / 3 % 3),
                                       double(pattern / 9 % 3), double(pattern / 27)};
        Matrix3d sum = Matrix3d::Zero();
        for (std::size_t i = 0; i < 4; ++i)
            sum += V[i] * stresses[i];
        const double all = V[0] + V[1] + V[2] + V[3];
        const Matrix3d expected = all > 0 ? Matrix3d(sum / all) : stresses[0];
        const std::vector<Matrix3d> smooth = smooth_stress(stresses, {{1, 2, 3}, {}, {}, {}}, V);
        REQUIRE_THAT(smooth.at(0), IsClose(expected, Rounding(16, 4)));
    }
}

TEST_CASE("fracture: an even stress is smooth already", "[A7.1][fracture][property]")
{
    for (Random random : seeds(20)) {
        const std::vector<Matrix3d> stresses(7, random.positive_definite());
        std::vector<double> volumes;
        for (std::size_t i = 0; i < stresses.size(); ++i)
            volumes.push_back(random.mass());
        REQUIRE_THAT(smooth_stress(stresses, random_neighbours(random, 7), volumes),
                     IsClose(stresses, Rounding(32, stresses[0].norm())));
    }
}

TEST_CASE("fracture: a smooth stress lies between those it is made of",
          "[A7.1][fracture][property]")
{
    for (Random random : seeds(50)) {
        const int count = 9;
        const Neighbours neighbours = random_neighbours(random, count);
        std::vector<Matrix3d> stresses;
        std::vector<double> volumes;
        for (int i = 0; i < count; ++i) {
            stresses.push_back(random.positive_definite());
            volumes.push_back(random.mass());
        }
        const std::vector<Matrix3d> smooth = smooth_stress(stresses, neighbours, volumes);
        check_count(smooth.size(), count, "stresses, one for each element");
        for (int e = 0; e < count; ++e) {
            const double scale = stresses[e].norm();
            REQUIRE_THAT(Matrix3d(smooth[e].transpose()), IsClose(smooth[e], Rounding(32, scale)));
            double low = stresses[e].trace(), high = low;
            for (int n : neighbours[e]) {
                low = std::min(low, stresses[n].trace());
                high = std::max(high, stresses[n].trace());
            }
            check_at_least(smooth[e].trace(), low, "the average trace, by the lowest", 32);
            check_at_most(smooth[e].trace(), high, "the average trace, by the highest", 32);
        }
    }
}

TEST_CASE("fracture: the largest eigenvalue of the second difference", "[A7.2][fracture]")
{
    const PrincipalStress principal = principal_stress(tridiagonal);
    REQUIRE_THAT(principal.stress, IsClose(2 + root2, Rounding(16, 4)));
    check_direction(principal.direction, Vector3d(1, -root2, 1) / 2);
}

TEST_CASE("fracture: of a diagonal stress the largest entry and its axis", "[A7.2][fracture]")
{
    for (int axis = 0; axis < 3; ++axis) {
        Vector3d entries(-5e6, 1e6, -2e6);
        std::rotate(entries.data(), entries.data() + axis, entries.data() + 3);
        CAPTURE(axis);
        const PrincipalStress principal = principal_stress(entries.asDiagonal());
        // not the -5 MPa, which are larger in magnitude
        REQUIRE_THAT(principal.stress, IsClose(1e6, Rounding(16, 5e6)));
        check_direction(principal.direction, Vector3d::Unit((4 - axis) % 3));
    }
}

TEST_CASE("fracture: equal eigenvalues have some unit vector", "[A7.2][fracture]")
{
    const Matrix3d Q = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -2) / 3).toRotationMatrix();
    for (const Vector3d& principal :
         {Vector3d(3, 3, 3), Vector3d(3, 3, 1), Vector3d(3, 1, 1), Vector3d(-2, -2, -2),
          Vector3d(0, 0, -4), Vector3d(0, 0, 0), Vector3d(3e8, 3e8, 3e-8)}) {
        CAPTURE(principal);
        const Matrix3d sigma = stress_of(principal, Q);
        const PrincipalStress found = principal_stress(sigma);
        REQUIRE_THAT(found.stress, IsClose(principal.maxCoeff(), Rounding(64, principal.norm())));
        check_eigenvector(sigma, found);
    }
}

TEST_CASE("fracture: the largest eigenvalue of random stresses", "[A7.2][fracture][property]")
{
    for (Random random : seeds(100)) {
        const Vector3d principal = random.vector() * std::pow(10, random.uniform(-6, 9));
        const Matrix3d sigma = stress_of(principal, random.rotation());
        const PrincipalStress found = principal_stress(sigma);
        REQUIRE_THAT(found.stress, IsClose(principal.maxCoeff(), Rounding(256, sigma.norm())));
        check_eigenvector(sigma, found);
    }
}

TEST_CASE("fracture: the largest eigenvalue is at most the mean and two thirds of von Mises",
          "[A7.2][fracture][property]")
{
    for (Random random : seeds(100)) {
        const Matrix3d sigma = stress_of(random.vector(), random.rotation());
        const double p = sigma.trace() / 3;
        const double sigma_vM = std::sqrt(1.5) * (sigma - p * Matrix3d::Identity()).norm();
        const double sigma_1 = principal_stress(sigma).stress;
        // σ₁ is p + ⅔ σ_vM where the other two eigenvalues are equal
        check_at_most(sigma_1, p + 2 * sigma_vM / 3, "σ₁, by p + ⅔ σ_vM", 16);
        check_at_least(sigma_1, p, "σ₁, by p", 16);
    }
    const Matrix3d uniaxial = Vector3d(6, 0, 0).asDiagonal();
    REQUIRE_THAT(principal_stress(uniaxial).stress, IsClose(2.0 + 4.0, Rounding(16, 6)));
}

TEST_CASE("fracture: a bar that is pulled cracks across the load", "[A7.3][fracture]")
{
    const Vector3d along = Vector3d(2, -1, 2) / 3;
    const Matrix3d sigma = 5e6 * along * along.transpose();
    const std::optional<Vector3d> n = crack_plane(sigma, 4e6);
    check_that(n.has_value(), "a crack, since the largest pull exceeds the strength");
    check_direction(*n, along);
    REQUIRE_THAT(crack_plane(sigma, 6e6), IsExactly(std::optional<Vector3d>()));
}

TEST_CASE("fracture: torsion cracks at 45 degrees", "[A7.3][fracture]")
{
    const double tau = 3e6; // the shear stress on the surface of a shaft along x
    const Matrix3d sigma{{0, tau, 0}, {tau, 0, 0}, {0, 0, 0}};
    const std::optional<Vector3d> n = crack_plane(sigma, 2.9e6);
    check_that(n.has_value(), "a crack, since the largest pull exceeds the strength");
    check_direction(*n, Vector3d(1, 1, 0) / root2);
    REQUIRE_THAT(crack_plane(sigma, 3.1e6), IsExactly(std::optional<Vector3d>()));
}

TEST_CASE("fracture: what only pushes opens no crack", "[A7.3][fracture]")
{
    const std::optional<Vector3d> none;
    for (const double threshold : {1e6, 0.0, -1e3, -1e9}) {
        CAPTURE(threshold);
        REQUIRE_THAT(crack_plane(Vector3d(-5e6, -1e6, -2e6).asDiagonal(), threshold),
                     IsExactly(none));
        REQUIRE_THAT(crack_plane(-3 * Matrix3d::Identity(), threshold), IsExactly(none));
        REQUIRE_THAT(crack_plane(Matrix3d::Zero(), threshold), IsExactly(none));
    }
}

TEST_CASE("fracture: a solid cracks just above its strength and not just below", "[A7.3][fracture]")
{
    // class B: the outcome flips within a billionth
    const Matrix3d sigma = Vector3d(-8, 4, 2).asDiagonal();
    REQUIRE_THAT(crack_plane(sigma, 4 * (1 + 1e-9)), IsExactly(std::optional<Vector3d>()));
    for (const double threshold : {4 * (1 - 1e-9), 0.0, -1.0}) {
        CAPTURE(threshold);
        const std::optional<Vector3d> n = crack_plane(sigma, threshold);
        check_that(n.has_value(), "a crack, since the largest pull exceeds the strength");
        check_direction(*n, Vector3d::UnitY());
    }
}

TEST_CASE("fracture: a crack turns with its stress", "[A7.3][fracture][property]")
{
    for (Random random : seeds(100)) {
        const Vector3d principal(random.uniform(2, 3), random.uniform(-3, 1),
                                 random.uniform(-3, 1));
        const Matrix3d Q = random.rotation();
        const Matrix3d sigma = stress_of(principal, Q);
        const std::optional<Vector3d> n = crack_plane(sigma, 1.9);
        check_that(n.has_value(), "a crack, since the largest pull exceeds the strength");
        check_direction(*n, Q.col(0), 256);
        REQUIRE_THAT(crack_plane(sigma, 3.1), IsExactly(std::optional<Vector3d>()));
    }
}

TEST_CASE("fracture: the faces of the unit tetrahedron by their normals", "[A7.4][fracture]")
{
    const std::array<Vector3d, 4> unit = corners_of(unit_tetrahedron(), 0);
    const Vector3d normals[4] = {Vector3d(1, 1, 1) / root3, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int f = 0; f < 4; ++f) {
        CAPTURE(f);
        // both signs of the normal, and a direction a little off
        REQUIRE_THAT(closest_face(unit, normals[f]), IsExactly(f));
        REQUIRE_THAT(closest_face(unit, -normals[f]), IsExactly(f));
        const Vector3d off = (normals[f] + Vector3d(0.05, -0.08, 0.03)).normalized();
        REQUIRE_THAT(closest_face(unit, off), IsExactly(f));
        REQUIRE_THAT(closest_face(unit, -off), IsExactly(f));
    }
}

TEST_CASE("fracture: a large face is not nearer than a small one", "[A7.4][fracture]")
{
    // a needle along x: the faces along it are a hundred times as large as the face across it
    const std::array<Vector3d, 4> needle = {Vector3d(100, 0, 0), Vector3d(0, 0, 0),
                                            Vector3d(0, 1, 0), Vector3d(0, 0, 1)};
    const double cosine = 0.75;
    REQUIRE_THAT(closest_face(needle, {cosine, std::sqrt(1 - cosine * cosine), 0}), IsExactly(0));
}

TEST_CASE("fracture: of equally near faces the lowest", "[A7.4][fracture]")
{
    const std::array<Vector3d, 4> unit = corners_of(unit_tetrahedron(), 0);
    REQUIRE_THAT(closest_face(unit, Vector3d(0, 1, -1) / root2), IsExactly(2));
    REQUIRE_THAT(closest_face(unit, Vector3d(1, -1, 0) / root2), IsExactly(1));
    // the same corners in another order
    REQUIRE_THAT(closest_face({unit[3], unit[2], unit[1], unit[0]}, Vector3d(0, 1, -1) / root2),
                 IsExactly(0));
}

TEST_CASE("fracture: a face without area is perpendicular to every crack", "[A7.4][fracture]")
{
    // corners 1, 2 and 3 are in a line, so face 0 has no normal
    const std::array<Vector3d, 4> flat = {Vector3d(0, 1, 0), Vector3d(0, 0, 0), Vector3d(1, 0, 0),
                                          Vector3d(2, 0, 0)};
    REQUIRE_THAT(closest_face(flat, {0, 0, 1}), IsExactly(1));
    REQUIRE_THAT(closest_face(flat, {0, 0.6, 0.8}), IsExactly(1));
    const Vector3d x(1, 2, 3);
    REQUIRE_THAT(closest_face({x, x, x, x}, {1, 0, 0}), IsExactly(0));
}

TEST_CASE("fracture: the nearest face goes with its corner when corners change places",
          "[A7.4][fracture][property]")
{
    for (Random random : seeds(100)) {
        std::array<Vector3d, 4> x;
        for (Vector3d& corner : x)
            corner = random.vector();
        const Vector3d n = random.unit_vector();
        const int face = closest_face(x, n);
        check_that(face >= 0 && face < 4, "the number of a face, 0 to 3");
        const Vector3d opposite = x[face];
        std::rotate(x.begin(), x.begin() + 1, x.end());
        std::swap(x[0], x[2]);
        const int again = closest_face(x, -n);
        check_that(again >= 0 && again < 4, "the number of a face, 0 to 3");
        REQUIRE_THAT(x[again], IsExactly(opposite));
    }
}

} // namespace rigor::testing
