// SPDX-License-Identifier: MIT
// A8.6: wrong formulas that students do not see. They are wrong by less, or for fewer arguments,
// than those that students see. No clue is given.
#include "graded/validation/drawn_forms.hpp"
#include "graded/validation/judge.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace rigor;
using namespace rigor::testing;

namespace {

using N = std::vector<double>;

// A number in single precision.
double rounded(double number)
{
    return static_cast<float>(number);
}

NumericFormula in_single_precision(const NumericFormula& formula)
{
    return [formula](N arguments) {
        for (double& number : arguments)
            number = rounded(number);
        N result = formula(arguments);
        for (double& number : result)
            number = rounded(number);
        return result;
    };
}

// The right formula on other arguments, or with another result.
NumericFormula with_arguments(const NumericFormula& formula, const std::function<void(N&)>& change)
{
    return [=](N arguments) {
        change(arguments);
        return formula(arguments);
    };
}

NumericFormula with_result(const NumericFormula& formula,
                           const std::function<void(const N& arguments, N& result)>& change)
{
    return [=](const N& arguments) {
        N result = formula(arguments);
        change(arguments, result);
        return result;
    };
}

std::vector<WrongNumeric> without_clues(const std::vector<NumericFormula>& formulas)
{
    std::vector<WrongNumeric> all;
    for (const NumericFormula& formula : formulas)
        all.push_back({"", formula});
    return all;
}

FormulaWithUnits with_units(const NumericFormula& wrong, const NumericFormula& right,
                            const N& example, const std::vector<Dimension>& arguments,
                            const Dimension& result)
{
    return {"", wrong, example, arguments, {result}, right};
}

} // namespace

TEST_CASE("line collision: hidden mistakes are rejected", "[A8.6][validation][hidden]")
{
    const auto right = right_collisions();
    const NumericFormula& f = right[0];
    check_test(students_test(test_line_collision), right,
               without_clues({
                   in_single_precision(f),
                   with_result(f, [](const N&, N& after) { after[0] *= 1 + 1e-6; }),
                   with_arguments(f, [](N& a) { a[4] = a[4] > 0.9 ? 1 : a[4]; }),
                   with_arguments(f, [](N& a) { a[4] = a[2] - a[3] < 1e-5 ? 0 : a[4]; }),
                   with_arguments(f, [](N& a) { a[0] = a[0] > 1e4 * a[1] ? 1e30 : a[0]; }),
                   with_arguments(f, [](N& a) { a[4] = a[2] < 0 ? 0 : a[4]; }),
                   with_arguments(f, [](N& a) { a[1] = std::min(a[1], 1e5); }),
                   with_arguments(f, [](N& a) { a[4] = a[4] < 1e-4 ? 0 : a[4]; }),
                   with_result(f, [](const N&, N& after) { after[0] *= 1 + 1e-9; }),
                   with_result(f, [](const N&, N& after) { after[1] *= 1 - 1e-11; }),
                   with_arguments(f, [](N& a) { a[1] = a[1] > 1e8 * a[0] ? 1e30 : a[1]; }),
                   with_arguments(f, [](N& a) { a[4] = a[2] - a[3] > 1e7 ? 1 : a[4]; }),
                   with_arguments(f,
                                  [](N& a) {
                                      const bool tiny = std::abs(a[2]) < 1e-7 * std::abs(a[3]);
                                      a[2] = tiny && a[2] > a[3] ? 0 : a[2];
                                  }),
               }),
               Texts::kept);
}

TEST_CASE("spring force: hidden mistakes are rejected", "[A8.6][validation][hidden]")
{
    const auto right = right_springs();
    const NumericFormula& f = right[0];
    const auto distance = [](const N& a) {
        return std::hypot(a[3] - a[0], a[4] - a[1], a[5] - a[2]);
    };
    check_test(
        students_test(test_spring_force), right,
        without_clues({
            in_single_precision(f),
            with_result(f, [](const N& a, N& force) { force[2] += 1e-6 * a[6]; }),
            with_arguments(f, [](N& a) { a[7] = std::max(a[7], 1e-4); }),
            with_arguments(f, [](N& a) { a[6] = std::min(a[6], 1e5); }),
            with_arguments(
                f,
                [=](N& a) { a[7] = std::abs(distance(a) / a[7] - 1) < 1e-5 ? distance(a) : a[7]; }),
            with_arguments(
                f, [](N& a) { a[7] *= a[3] > a[0] && a[4] > a[1] && a[5] > a[2] ? 1.01 : 1; }),
            with_result(f, [](const N& a, N& force) { force[1] -= 1e-4 * (a[1] + a[4]); }),
            with_result(f, [](const N&, N& force) { force[0] *= 1 + 1e-9; }),
            with_result(f, [](const N&, N& force) { force[1] *= 1 + 1e-11; }),
            with_arguments(f, [](N& a) { a[6] = a[6] > 1e7 ? 1e7 : a[6]; }),
            with_result(f, [](const N& a, N& force) { force[1] *= a[4] == a[1] ? NAN : 1; }),
            with_arguments(f, [](N& a) { a[7] = a[7] < 1e-7 ? 0 : a[7]; }),
            with_result(f,
                        [=](const N& a, N& force) {
                            const double away = std::hypot(a[0], a[1], a[2]);
                            if (distance(a) < 1e-5 * away) force = {0, 0, 0};
                        }),
        }),
        Texts::kept);
}

TEST_CASE("tangent: hidden mistakes are rejected", "[A8.6][validation][hidden]")
{
    const auto right = right_tangents();
    const NumericFormula& f = right[0];
    check_test(
        students_test(test_tangent), right,
        in_drawn_directions(without_clues({
            in_single_precision(f),
            with_result(f, [](const N& n, N& t) { t[0] *= n[0] == n[1] ? 0 : 1; }),
            with_result(f, [](const N& n, N& t) { t[2] += n[2] < -0.999 ? 1e-9 : 0; }),
            [](const N& n) { // loses its digits near -z
                const double a = 1 / (1 + n[2]);
                if (n[2] < -0.9999999) return N{0, -1, 0};
                return N{1 - n[0] * n[0] * a, -n[0] * n[1] * a, -n[0]};
            },
            with_result(f, [](const N& n, N& t) { t[1] *= n[0] > 0 && n[0] < 0.05 ? 0.99 : 1; }),
            with_result(f,
                        [](const N&, N& t) {
                            t = {t[0], t[1], t[2] * (1 + 1e-9)};
                        }),
            with_result(f,
                        [](const N& n, N& t) {
                            for (int i = 0; i < 3; ++i)
                                t[i] += 1e-11 * n[i];
                        }),
            with_result(f,
                        [](const N& n, N& t) {
                            if (std::hypot(n[0], n[1]) < 1e-9 && n[2] < 0) t = {0, 1, 0};
                        }),
            with_result(f,
                        [](const N& n, N& t) {
                            if (std::hypot(n[1] - n[2], n[0]) < 1e-6) t = {1, 0, 0};
                        }),
            with_result(f,
                        [](const N& n, N& t) {
                            const double away = std::hypot(n[0] - n[1], n[0] + n[2]);
                            if (n[2] > 0 && away < 1e-7) t = {M_SQRT1_2, -M_SQRT1_2, 0};
                        }),
        })),
        Texts::kept);
}

TEST_CASE("oscillator: hidden mistakes are rejected", "[A8.6][validation][hidden]")
{
    const auto right = right_steps();
    const NumericFormula& f = right[0];
    check_test(
        students_test(test_oscillator_step), right,
        without_clues({
            in_single_precision(f),
            with_result(f, [](const N& s, N& after) { after[1] *= 1 - 0.001 * s[2] * s[3]; }),
            with_result(f, [](const N& s,
                              N& after) { after[0] += 0.02 * s[2] * s[3] * s[2] * s[3] * s[0]; }),
            with_arguments(f, [](N& s) { s[1] = s[0] == 0 ? 0 : s[1]; }),
            with_arguments(f, [](N& s) { s[2] = std::max(s[2], 1e-3); }),
            with_arguments(f, [](N& s) { s[1] = std::min(s[1], 1e4); }),
            with_arguments(f, [](N& s) { s[2] = std::min(s[2], 1e7); }),
            with_arguments(f, [](N& s) { s[0] = std::abs(s[0]) < 1e-6 ? 0 : s[0]; }),
            with_result(f,
                        [](const N& s, N& after) {
                            after[0] += 1.3 * std::pow(s[2] * s[3], 3) * s[1] / s[2];
                        }),
            with_result(f,
                        [](const N& s, N& after) {
                            after[1] -= 1.3 * std::pow(s[2] * s[3], 3) * s[0] * s[2];
                        }),
            with_arguments(
                f, [](N& s) { s[3] *= s[2] * s[3] > 0.28 && s[2] * s[3] < 0.45 ? 0.8 : 1; }),
            with_result(f,
                        [](const N& s, N& after) { after[0] *= s[0] == 0 && s[1] == 0 ? NAN : 1; }),
        }),
        Texts::kept);
}

TEST_CASE("units: hidden mistakes are rejected", "[A8.6][validation][hidden]")
{
    const Dimension mass = {1, 0, 0}, length = {0, 1, 0}, time = {0, 0, 1}, speed = {0, 1, -1},
                    force = {1, 1, -2}, pressure = {1, -1, -2}, volume = {0, 3, 0};
    const auto product = [](const N& a) { return N{a[0] * a[1]}; };
    check_test_of_units(
        right_units(),
        {
            with_units([](const N& a) { return N{std::sqrt(a[0] * a[0] + a[1] * a[1] + 1e-12)}; },
                       [](const N& a) { return N{std::sqrt(a[0] * a[0] + a[1] * a[1])}; }, {3, 4},
                       {length, length}, length),
            with_units([](const N& a) { return N{a[0] * std::min(a[1], 1e9)}; }, product, {1.5, 2},
                       {pressure, {0, 2, 0}}, force),
            with_units([](const N& a) { return N{a[0] * a[1] * (a[1] > 1000 ? 1.001 : 1)}; },
                       product, {4, 0.2}, {speed, time}, length),
            with_units([](const N& a) { return N{std::sqrt(a[0] / a[1]) * a[2]}; },
                       [](const N& a) { return N{a[2] / 2}; }, {3, 2, 1.2},
                       {pressure, {1, -3, 0}, time}, time),
            with_units([](const N& a) { return N{std::pow(a[0], 0.333) * a[1] / a[1]}; },
                       [](const N& a) { return N{std::cbrt(a[0]) * a[1] / a[1]}; }, {8, 2},
                       {volume, mass}, length),
            with_units([](const N& a) { return N{a[0] + 1e-7 * a[1] * a[1]}; },
                       [](const N& a) { return N{a[0] + 1e-7 * a[1]}; }, {1, 1}, {mass, mass},
                       mass),
            with_units([](const N& a) { return N{a[2] < 1e-9 ? 0 : a[0] * a[1] / a[2]}; },
                       [](const N& a) { return N{a[0] * a[1] / a[2]}; }, {2, 3, 0.5},
                       {mass, speed, time}, force),
            with_units([](const N& a) { return N{a[0] * a[1] * (1 + 1e-9 * std::tanh(a[1]))}; },
                       product, {2, 3}, {speed, time}, length),
            with_units([](const N& a) { return N{a[0] * a[1] * (1 + 1e-11 * std::tanh(a[1]))}; },
                       product, {2, 3}, {speed, time}, length),
            with_units([](const N& a) { return N{a[0] * std::max(a[1], 4e-12)}; }, product, {3, 1},
                       {speed, time}, length),
            with_units([](const N& a) { return N{a[1] < 1 ? 0 : std::min(a[1] - 1, a[0])}; },
                       [](const N& a) { return N{std::max(0.0, a[1] - a[0])}; }, {3, 0.2},
                       {time, time}, time),
        },
        Texts::kept);
}
