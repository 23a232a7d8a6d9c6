// SPDX-License-Identifier: MIT
// The handouts show functions with a bug to find, which no task asks for. The wrong function gives
// the result that its handout describes, and it breaks a law. The right function keeps this law.
#include "handouts/bugs.hpp"

#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <numeric>

using namespace rigor::handouts;

namespace {

namespace fs = std::filesystem;
using bugs::Root;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using rigor::Judgement;
using Numbers = std::vector<double>;
using Vectors = std::vector<Vector3d>;

bool near(double a, double b, double tolerance = 1e-12)
{
    return std::abs(a - b) <= tolerance;
}

// The code in the section "Find the bug".
std::string bug_of(const Handout& handout)
{
    const std::size_t section = handout.text.find("\n## Find the bug\n");
    if (section == std::string::npos) return "";
    const std::string open = "```cpp\n";
    const std::size_t start = handout.text.find(open, section) + open.size();
    return handout.text.substr(start, handout.text.find("```", start) - start);
}

// The file of the bugs as handouts show it, without `inline`.
std::string listings()
{
    std::string text = content(fs::path(RIGOR_SOURCE_DIR) / "tests/handouts/bugs.hpp");
    const std::string word = "inline ";
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;)
        text.erase(at, word.size());
    return text;
}

// The right functions, where the standard library does not have them.

double right_power(const Vectors& forces, const Vectors& velocities)
{
    double sum = 0;
    for (std::size_t i = 0; i < forces.size(); ++i)
        sum += forces[i].dot(velocities[i]);
    return sum;
}

double right_disc_moment(double mass, double radius, int rings)
{
    double J = 0;
    for (int i = 0; i < rings; ++i) {
        const double inner = radius * i / rings, outer = radius * (i + 1) / rings;
        const double r = (inner + outer) / 2;
        J += mass * (outer * outer - inner * inner) / (radius * radius) * r * r;
    }
    return J;
}

Matrix3d right_turn(const Matrix3d& R, const Vector3d& axis, double angle)
{
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix() * R;
}

Vector3d right_bounce(const Vector3d& v, const Vector3d& n, double restitution)
{
    const double v_n = v.dot(n);
    return v_n >= 0 ? v : Vector3d(v - (1 + restitution) * v_n * n);
}

Numbers right_couplings(Numbers v)
{
    for (std::size_t i = 0; i + 1 < v.size(); ++i)
        if (v[i] > v[i + 1]) v[i] = v[i + 1] = (v[i] + v[i + 1]) / 2;
    return v;
}

double right_flow(double plastic, double strain, double E, double sigma_Y)
{
    return std::clamp(plastic, strain - sigma_Y / E, strain + sigma_Y / E);
}

Numbers right_heights(const Numbers& heights)
{
    Numbers smooth = heights;
    for (std::size_t i = 1; i + 1 < heights.size(); ++i)
        smooth[i] = (heights[i - 1] + heights[i] + heights[i + 1]) / 3;
    return smooth;
}

Judgement right_root_test(const Root& root)
{
    const auto is_root = [&](double a, double x) { return x >= 0 && near(x * x, a, 1e-12 * a); };
    for (int power = -30; power <= 30; ++power)
        if (const double a = std::ldexp(1.0, power); !is_root(a, root(a))) return rigor::rejected();
    return rigor::accepted();
}

} // namespace

TEST_CASE("bugs: each handout shows one, in a function that no task asks for", "[bugs]")
{
    const std::string formulas =
        content(fs::path(RIGOR_SOURCE_DIR) / "framework/formulas/table.hpp");
    int shown = 0;
    for (const Handout& handout : all_handouts()) {
        if (handout.label == "A0") continue; // the warm-up has its bug in the loop
        CAPTURE(handout.label);
        const std::string bug = bug_of(handout);
        REQUIRE(bug.size() > 50);
        CHECK(listings().find("// " + handout.label + "\n\n" + bug + "\n") != std::string::npos);
        const std::string before = bug.substr(0, bug.find('('));
        const std::string name = before.substr(before.rfind(' ') + 1);
        CHECK(formulas.find(" " + name + ")") == std::string::npos);
        CHECK(formulas.find(" " + name + ",") == std::string::npos);
        ++shown;
    }
    CHECK(shown == 8);
}

TEST_CASE("bugs: A1 a couple has power although its forces add up to 0", "[bugs]")
{
    const Vector3d x(1, 0, 0), y(0, 1, 0);
    CHECK(near(bugs::power({2 * x}, {3 * x + y}), 6)); // one force
    CHECK(near(right_power({y, -y}, {2 * y, -2 * y}), 4));
    CHECK_FALSE(near(bugs::power({y, -y}, {2 * y, -2 * y}), 4));
}

TEST_CASE("bugs: A2 the moment of a disc converges to half of M R²", "[bugs]")
{
    CHECK(near(right_disc_moment(3, 2, 10000), 6, 1e-6));
    CHECK(near(bugs::disc_moment(3, 2, 10000), 4, 1e-6)); // it converges, to something else
    CHECK_FALSE(near(bugs::disc_moment(3, 2, 10000), 6, 1));
}

TEST_CASE("bugs: A3 a turn about a world axis leaves what lies along that axis", "[bugs]")
{
    const Vector3d x(1, 0, 0), z(0, 0, 1);
    const Matrix3d R = Eigen::AngleAxisd(1, x).toRotationMatrix();
    const Vector3d along = R.transpose() * z; // the body's direction that points along z
    CHECK((bugs::turned_about_world_axis(R, x, 0.5) - right_turn(R, x, 0.5)).norm() < 1e-12);
    CHECK((right_turn(R, z, 0.5) * along - z).norm() < 1e-12);
    CHECK_FALSE((bugs::turned_about_world_axis(R, z, 0.5) * along - z).norm() < 0.1);
}

TEST_CASE("bugs: A4 a smooth wall changes the velocity along its normal only", "[bugs]")
{
    const Vector3d n(0, 1, 0), falls(0, -2, 0), oblique(3, -2, 0);
    CHECK((bugs::after_a_smooth_wall(falls, n, 0.5) - n).norm() < 1e-12);
    CHECK(right_bounce(oblique, n, 0.5).cross(n).isApprox(oblique.cross(n)));
    CHECK_FALSE(bugs::after_a_smooth_wall(oblique, n, 0.5).cross(n).isApprox(oblique.cross(n)));
}

TEST_CASE("bugs: A5 wagons that couple keep their momentum", "[bugs]")
{
    const auto momentum = [](const Numbers& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
    CHECK(near(momentum(bugs::couple_wagons({2, 0})), 2)); // two wagons
    CHECK(near(momentum(right_couplings({4, 2, 0})), 6));
    CHECK_FALSE(near(momentum(bugs::couple_wagons({4, 2, 0})), 6));
}

TEST_CASE("bugs: A6 a rod that flows does not give work", "[bugs]")
{
    constexpr double E = 200, sigma_Y = 1;
    const auto work = [&](double (*flowed)(double, double, double, double), double strain) {
        const double plastic = flowed(0, strain, E, sigma_Y);
        CHECK(std::abs(E * (strain - plastic)) <= sigma_Y * (1 + 1e-12)); // inside, both ways
        return E * (strain - plastic) * plastic;
    };
    CHECK(near(bugs::flowed_rod(0, 0.02, E, sigma_Y), right_flow(0, 0.02, E, sigma_Y)));
    CHECK(work(right_flow, -0.02) > 0);
    CHECK_FALSE(work(bugs::flowed_rod, -0.02) > 0);
}

TEST_CASE("bugs: A7 a row smoothed from the other end is the same row", "[bugs]")
{
    const auto other_end = [](Numbers row) {
        std::reverse(row.begin(), row.end());
        return row;
    };
    const Numbers row = {1, 5, 2, 0, 3};
    CHECK(bugs::smooth_heights({2, 2, 2, 2}) == Numbers{2, 2, 2, 2});
    CHECK(other_end(right_heights(other_end(row))) == right_heights(row));
    CHECK_FALSE(other_end(bugs::smooth_heights(other_end(row))) == bugs::smooth_heights(row));
}

TEST_CASE("bugs: A8 a test of roots rejects a formula that divides by zero", "[bugs]")
{
    const Root right = [](double a) { return std::sqrt(a); };
    const Root divides = [](double a) { return std::sqrt(a) * (a - 1) / (a - 1); };
    const Root twice = [](double a) { return 2 * std::sqrt(a); };
    for (const auto test : {bugs::test_root, right_root_test}) {
        CHECK(test(right).rejected_in == 0);
        CHECK_FALSE(test(twice).rejected_in == 0);
    }
    CHECK_FALSE(right_root_test(divides).rejected_in == 0);
    CHECK(bugs::test_root(divides).rejected_in == 0); // the bug
}
