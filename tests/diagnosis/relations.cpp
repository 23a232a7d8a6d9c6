// SPDX-License-Identifier: MIT
// Each relation is a function that takes all pairs. A free number in it, such as a factor, is
// computed from one pair and then has to fit all others.
#include "diagnosis/relations.hpp"

#include "diagnosis/transforms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rigor::diagnosis {

namespace {

constexpr double exact = 1e-8; // how well a relation has to fit, relative to the answer

template <class Predicate> bool all_of(const Pairs& pairs, const Predicate& predicate)
{
    return std::all_of(pairs.list.begin(), pairs.list.end(), predicate);
}

std::vector<double> scaled(Numbers numbers, double factor)
{
    std::vector<double> result(numbers.begin(), numbers.end());
    for (double& x : result)
        x *= factor;
    return result;
}

bool fits(Numbers expected, const Pair& pair)
{
    return close(expected, pair.answer, exact, pair.noise);
}

double dot(Numbers a, Numbers b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

// The factor c for which c times the right answer is nearest to the student's.
double factor_of(const Pair& pair)
{
    const double square = dot(pair.right, pair.right);
    return square > 0 ? dot(pair.right, pair.answer) / square : std::nan("");
}

bool is_zero(Numbers numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return x == 0; });
}

bool is_finite(Numbers numbers)
{
    return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

std::string constant(const Pairs& pairs)
{
    const Numbers first = pairs.list[0].answer;
    if (all_of(pairs, [](const Pair& p) { return !is_finite(p.answer); }))
        return "not a finite number";
    if (all_of(pairs, [](const Pair& p) { return is_zero(p.answer); }))
        return pairs.role.form == Form::boolean ? "always false" : "always 0";
    if (!all_of(pairs, [&](const Pair& p) { return close(first, p.answer, exact); })) return "";
    if (pairs.role.form == Form::boolean) return "always true";
    return first.size() == 1 ? "always " + number_in_words(first[0]) : "the same for all arguments";
}

std::string constant_factor(const Pairs& pairs)
{
    if (pairs.role.form == Form::boolean) return "";
    const auto used = std::find_if(pairs.list.begin(), pairs.list.end(), [](const Pair& p) {
        return !is_zero(p.right) && !is_zero(p.answer);
    });
    if (used == pairs.list.end()) return "";
    const double c = factor_of(*used);
    if (!std::isfinite(c) ||
        !all_of(pairs, [&](const Pair& p) { return fits(scaled(p.right, c), p); }))
        return "";
    return c == -1 ? "the right one with the opposite sign"
                   : number_in_words(c) + " times the right one";
}

std::string changed_right_one(const Pairs& pairs)
{
    for (const LeafChange& change : changes_of(pairs.role))
        if (all_of(pairs, [&](const Pair& p) {
                std::vector<double> numbers(p.right.begin(), p.right.end());
                return change.apply(numbers) && fits(numbers, p);
            }))
            return "the right one " + change.words;
    return "";
}

// Each number of the answer is the right one or its negative.
std::string negated_components(const Pairs& pairs)
{
    if (!pairs.role.is_vector()) return "";
    for (int signs = 1; signs < 7; ++signs) {
        std::string negated;
        for (int i = 0; i < 3; ++i)
            if (signs >> i & 1) negated += std::string(negated.empty() ? "" : ", ") + "xyz"[i];
        if (all_of(pairs, [&](const Pair& p) {
                std::vector<double> numbers(p.right.begin(), p.right.end());
                for (int i = 0; i < 3; ++i)
                    if (signs >> i & 1) numbers[i] = -numbers[i];
                return fits(numbers, p);
            }))
            return "the right one with the opposite sign of " + negated;
    }
    return "";
}

std::string positive_part(const Pairs& pairs)
{
    if (pairs.role.size() != 1 || pairs.role.form != Form::real) return "";
    return all_of(pairs,
                  [](const Pair& p) {
                      return p.answer[0] == std::max(0.0, p.right[0]) || fits(p.right, p);
                  })
               ? "0 where the right one is negative"
               : "";
}

std::string shifted(const Pairs& pairs)
{
    const Pair& first = pairs.list[0];
    if (pairs.role.size() != 1 || pairs.role.form == Form::boolean) return "";
    const double c = first.answer[0] - first.right[0];
    if (!all_of(pairs, [&](const Pair& p) {
            return std::abs(p.answer[0] - p.right[0] - c) <= exact * std::abs(c);
        }))
        return "";
    return fmt::format("the right one {} {}", c > 0 ? "plus" : "minus",
                       number_in_words(std::abs(c)));
}

} // namespace

Pairs pairs_of(const Layout& answer, int role, const std::vector<const Case*>& cases)
{
    Pairs pairs = {answer.roles[role], {}};
    for (const Case* c : cases) {
        if (!c->is_same_shape()) continue;
        for (std::size_t i = 0; i < c->right.leaves.size(); ++i) {
            const Leaf& leaf = c->right.leaves[i];
            if (leaf.role == role)
                pairs.list.push_back({c->right.of(leaf, pairs.role), c->answer.of(leaf, pairs.role),
                                      &c->arguments, c->noise});
        }
    }
    return pairs;
}

std::string plain_relation(const Pairs& pairs)
{
    if (pairs.list.empty()) return "";
    using Relation = std::string (*)(const Pairs&);
    for (const Relation relation : {&constant, &constant_factor, &changed_right_one,
                                    &negated_components, &positive_part, &shifted})
        if (std::string words = relation(pairs); !words.empty()) return words;
    return "";
}

std::string number_in_words(double number)
{
    constexpr double allowed = 1e-9;
    const auto is = [&](double x) { return std::abs(number - x) <= allowed * std::abs(x); };
    constexpr std::pair<double, const char*> known[] = {
        {0.5, "½"}, {0.25, "¼"}, {0.75, "¾"}, {1.0 / 3, "⅓"}, {2.0 / 3, "⅔"}};
    for (const auto& [value, words] : known)
        if (is(value)) return words;
    const double pi = std::numbers::pi;
    for (const auto& [unit, words] :
         {std::pair(1.0, ""), std::pair(pi, "π"), std::pair(std::sqrt(2.0), "√2"),
          std::pair(std::sqrt(3.0), "√3"), std::pair(std::sqrt(2.0 / 3), "√(2/3)"),
          std::pair(std::sqrt(1.5), "√(3/2)"), std::pair(1 / pi, "1/π")})
        for (int divisor = 1; divisor <= 24; ++divisor) {
            const double n = std::round(number / unit * divisor);
            if (n == 0 || std::abs(n) > 48 || !is(n / divisor * unit)) continue;
            std::string text = fmt::format("{:g}", n);
            if (*words)
                text = n == 1 ? words : n == -1 ? std::string("-") + words : text + " " + words;
            return divisor == 1 ? text : fmt::format("{}/{}", text, divisor);
        }
    return fmt::format("{:.6g}", number);
}

} // namespace rigor::diagnosis
