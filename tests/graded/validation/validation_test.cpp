// SPDX-License-Identifier: MIT
// A8.1 to A8.5: the tests that a student wrote accept every right formula and reject the wrong
// ones. Each test case tries a test on all right formulas and on wrong ones, in a random order. So
// rejecting everything earns nothing, and neither does accepting everything.
#include "drawn_forms.hpp"
#include "judge.hpp"
#include "mutants.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

constexpr std::size_t mutant_count = 12;

std::vector<double> bodies_on_a_line(unsigned seed)
{
    Random random(first_seed() + seed);
    const double v2 = random.uniform(-3, 3);
    return {random.mass(), random.mass(), v2 + random.uniform(0.1, 3), v2, random.uniform(0, 1)};
}

std::vector<double> ends_of_a_spring(unsigned seed)
{
    Random random(first_seed() + seed);
    std::vector<double> numbers;
    numbers::append(numbers, random.vector());
    numbers::append(numbers, random.vector());
    numbers.push_back(random.uniform(2, 50));
    numbers.push_back(random.uniform(0.2, 2));
    return numbers;
}

std::vector<double> oscillator(unsigned seed)
{
    Random random(first_seed() + seed);
    const double w = random.uniform(0.5, 4);
    return {random.uniform(-2, 2), random.uniform(-2, 2), w, random.uniform(0.1, 0.5) / w};
}

} // namespace

TEST_CASE("line collision: ordinary mistakes are rejected", "[A8.1][validation]")
{
    check_test(students_test(test_line_collision), right_collisions(),
               numeric(line_collisions().ordinary));
}

TEST_CASE("line collision: mistakes in special cases are rejected", "[A8.1][validation]")
{
    check_test(students_test(test_line_collision), right_collisions(),
               numeric(line_collisions().special));
}

TEST_CASE("line collision: mutants made by a program are rejected", "[A8.1][validation]")
{
    const auto right = right_collisions();
    check_test(students_test(test_line_collision), right,
               mutants(right[0], bodies_on_a_line, mutant_count));
}

TEST_CASE("spring force: ordinary mistakes are rejected", "[A8.2][validation]")
{
    check_test(students_test(test_spring_force), right_springs(),
               numeric(spring_forces().ordinary));
}

TEST_CASE("spring force: mistakes in special cases are rejected", "[A8.2][validation]")
{
    check_test(students_test(test_spring_force), right_springs(), numeric(spring_forces().special));
}

TEST_CASE("spring force: mutants made by a program are rejected", "[A8.2][validation]")
{
    const auto right = right_springs();
    check_test(students_test(test_spring_force), right,
               mutants(right[0], ends_of_a_spring, mutant_count));
}

TEST_CASE("tangent: ordinary mistakes are rejected", "[A8.3][validation]")
{
    check_test(students_test(test_tangent), right_tangents(), numeric(tangents().ordinary));
}

TEST_CASE("tangent: mistakes in special cases are rejected", "[A8.3][validation]")
{
    check_test(students_test(test_tangent), right_tangents(),
               in_drawn_directions(numeric(tangents().special)));
}

TEST_CASE("oscillator: ordinary mistakes are rejected", "[A8.4][validation]")
{
    check_test(students_test(test_oscillator_step), right_steps(),
               numeric(oscillator_steps().ordinary));
}

TEST_CASE("oscillator: mistakes in special cases are rejected", "[A8.4][validation]")
{
    check_test(students_test(test_oscillator_step), right_steps(),
               numeric(oscillator_steps().special));
}

TEST_CASE("oscillator: mutants made by a program are rejected", "[A8.4][validation]")
{
    const auto right = right_steps();
    check_test(students_test(test_oscillator_step), right,
               mutants(right[0], oscillator, mutant_count));
}

TEST_CASE("units: wrong powers of a unit are rejected", "[A8.5][validation]")
{
    check_test_of_units(right_units(), wrong_powers());
}

TEST_CASE("units: thresholds that have a unit are rejected", "[A8.5][validation]")
{
    check_test_of_units(right_units(), wrong_thresholds());
}
