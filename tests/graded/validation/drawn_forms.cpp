// SPDX-License-Identifier: MIT
#include "drawn_forms.hpp"

#include "support/random.hpp"
#include "support/seeds.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rigor::testing {

namespace {

using Numbers = std::vector<double>;

// A generator for these arguments. It is the same for the same digits, whatever the powers of two,
// and another one with another number `secret`, which is drawn by `one_way`.
Random drawn_for(const Numbers& arguments, std::uint64_t secret)
{
    constexpr std::uint64_t prime = 1099511628211u;
    std::uint64_t hash = secret;
    int exponent = 0;
    for (const double number : arguments)
        hash = hash * prime + std::bit_cast<std::uint64_t>(std::frexp(number, &exponent));
    return {static_cast<unsigned>(hash ^ hash >> 32)};
}

// A right formula whose results have rounding errors nearly as large as A8 allows.
// @param largest_terms  for these arguments, the largest term of each number of the result, or 0 if
//                       the number is exact
template <class Terms>
NumericFormula rounded(const NumericFormula& formula, const Terms& largest_terms)
{
    // Two such formulas differ, and a vector of three such components is wrong, by less than the
    // 1e-12 that a test has to allow.
    constexpr double rounding = 0.25e-12;
    return [=, secret = one_way(1)](const Numbers& from) {
        Random random = drawn_for(from, secret);
        Numbers result = formula(from);
        const Numbers terms = largest_terms(from);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] += rounding * terms[i] * random.uniform(-1, 1);
        return result;
    };
}

// The weighted mean of two formulas.
NumericFormula mean(const NumericFormula& a, const NumericFormula& b, double weight)
{
    return [=](const Numbers& from) {
        Numbers result = a(from);
        const Numbers other = b(from);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] += weight * (other[i] - result[i]);
        return result;
    };
}

} // namespace

NumericFormula with_drawn_digits(const NumericFormula& formula, unsigned seed)
{
    constexpr double change = 2e-14;
    return [=, secret = one_way(seed)](const Numbers& from) {
        Random random = drawn_for(from, secret);
        Numbers result = formula(from);
        for (double& number : result)
            number *= 1 + change * random.uniform(-1, 1);
        return result;
    };
}

NumericFormula with_drawn_factors(const NumericFormula& formula, unsigned seed)
{
    return [=, secret = one_way(seed)](const Numbers& from) {
        Random random = drawn_for({}, secret);
        Numbers result = formula(from);
        for (double& number : result)
            number *= random.uniform(1, 2);
        return result;
    };
}

NumericFormula in_drawn_directions(const NumericFormula& tangent, unsigned seed)
{
    Random random = drawn_for({}, one_way(seed));
    const double angle = random.uniform(0, 2 * M_PI);
    const Vector3d slope = random.vector();
    return [=](const Numbers& from) {
        const Vector3d n = numbers::taken<Vector3d>(from);
        const Vector3d t = numbers::taken<Vector3d>(tangent(from));
        // Rodrigues' formula for a turn about n, which is a unit vector.
        const double c = std::cos(angle + slope.dot(n)), s = std::sin(angle + slope.dot(n));
        Numbers result;
        numbers::append(result, Vector3d(c * t + s * n.cross(t) + (1 - c) * n.dot(t) * n));
        return result;
    };
}

std::vector<WrongNumeric> in_drawn_directions(std::vector<WrongNumeric> tangents)
{
    unsigned seed = 100;
    for (WrongNumeric& wrong : tangents)
        wrong.formula = in_drawn_directions(wrong.formula, seed++);
    return tangents;
}

std::vector<NumericFormula> right_collisions()
{
    std::vector<NumericFormula> all = numeric(line_collisions().right);
    all.push_back(rounded(all[0], [](const Numbers& a) {
        const double fastest = std::max(std::abs(a[2]), std::abs(a[3])); // also moving apart
        return Numbers{fastest, fastest};
    }));
    return all;
}

std::vector<NumericFormula> right_springs()
{
    std::vector<NumericFormula> all = numeric(spring_forces().right);
    all.push_back(rounded(all[0], [](const Numbers& a) {
        const double r = (Vector3d(a[3], a[4], a[5]) - Vector3d(a[0], a[1], a[2])).norm();
        const double k = a[6], L = a[7];
        return Numbers(3, r > 0 ? k * std::max(r, L) : 0);
    }));
    return all;
}

std::vector<NumericFormula> right_tangents()
{
    std::vector<NumericFormula> all = numeric(tangents().right);
    for (unsigned i = 0; i < all.size(); ++i)
        all[i] = in_drawn_directions(all[i], i);
    all.push_back(rounded(all[0], [](const Numbers&) { return Numbers(3, 1.0); }));
    return all;
}

std::vector<NumericFormula> right_steps()
{
    std::vector<NumericFormula> all = numeric(oscillator_steps().right);
    const std::size_t methods = all.size();
    Random random = drawn_for({}, one_way(2));
    for (std::size_t i = 0; i + 1 < methods; i += 2)
        all.push_back(mean(all[i], all[i + 1], random.uniform(0.2, 0.8)));
    all.push_back(rounded(all[0], [](const Numbers& a) {
        const double w = a[2], A = std::hypot(a[0], a[1] / w);
        return Numbers{A, w * A};
    }));
    return all;
}

} // namespace rigor::testing
