// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"
#include "worker/proxy/proxy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rigor::testing {

namespace {

constexpr std::size_t most_calls = 1000;
constexpr int most_rounds = 2000; // a test that asks anew each time would never come to its end

using Calls = std::vector<KnownCall>;

// The calls up to the question of the test, with its answer.
void answer(Calls& known, const Judgement& question, const NumericFormula& formula,
            std::size_t arguments)
{
    if (question.question.size() != arguments || question.calls_before < 0 ||
        question.calls_before > static_cast<int>(known.size()))
        FAIL("the test sent a question that is none");
    if (question.calls_before >= static_cast<int>(most_calls))
        FAIL("the test calls the formula more than " << most_calls << " times");
    known.resize(static_cast<std::size_t>(question.calls_before));
    known.push_back({question.question, formula(question.question)});
}

// What the test says of a formula in the end. `asked` are the calls that it probably makes, since
// it has made them before; they become the calls that it has made.
Judgement judged(const StudentsTest& test, const NumericFormula& formula, Calls& asked)
{
    renew_worker();
    for (KnownCall& call : asked)
        call.result = formula(call.arguments);
    for (int round = 0; round < most_rounds; ++round) {
        const Judgement judgement = test.judgement(asked);
        if (judgement.question.empty()) return judgement;
        answer(asked, judgement, formula, test.arguments);
    }
    FAIL("the test does not come to its end: it makes other calls whenever it is run, although the "
         "results are the same");
    return {};
}

std::string accusation(const Judgement& judgement)
{
    return fmt::format("the test rejects a formula that is right, in line {}",
                       judgement.rejected_in);
}

// Fails for a test that accepts some of the wrong formulas.
void require_rejected(const std::vector<std::string>& accepted, std::size_t all)
{
    if (accepted.empty()) return;
    std::string text = fmt::format("{} of {} wrong formulas pass the test", accepted.size(), all);
    const auto clue = std::find_if(accepted.begin(), accepted.end(),
                                   [](const std::string& words) { return !words.empty(); });
    if (clue != accepted.end())
        text += fmt::format("; {} {}", accepted.size() == 1 ? "it" : "one of them", *clue);
    FAIL(text);
}

double largest(const std::vector<double>& numbers)
{
    double result = 0;
    for (const double number : numbers)
        result = std::max(result, std::abs(number));
    return result;
}

bool differs(const std::vector<double>& a, const std::vector<double>& b)
{
    constexpr double clearly = 1e-3; // a part of the largest number
    const double scale = std::max(largest(a), largest(b));
    for (std::size_t i = 0; i < a.size(); ++i)
        if (!(std::abs(a[i] - b[i]) <= clearly * scale)) return true;
    return false;
}

std::size_t index_below(std::size_t n, Random& random)
{
    return static_cast<std::size_t>(random.bits() % n);
}

NumericFormula wrong_result(const NumericFormula& formula, std::size_t i, int kind, Random& random)
{
    const double factor = 1 + random.uniform(0.01, 0.5), threshold = random.uniform(-1, 1);
    return [=, before = std::optional<double>()](const std::vector<double>& from) mutable {
        std::vector<double> result = formula(from);
        double& number = result[i];
        const double right = number;
        if (kind == 0) number *= factor;
        if (kind == 1) number = -number;
        if (kind == 2) number = before.value_or(number);
        if (kind == 3 && number > threshold) number *= factor;
        before = right;
        return result;
    };
}

NumericFormula wrong_arguments(const NumericFormula& formula, std::size_t i, std::size_t k,
                               bool exchanges)
{
    return [=](std::vector<double> from) {
        if (exchanges)
            std::swap(from[i], from[k]);
        else
            from[i] = 1;
        return formula(from);
    };
}

NumericFormula mutant(const NumericFormula& formula, const std::vector<double>& arguments,
                      Random& random)
{
    const std::size_t results = formula(arguments).size();
    const int kind = static_cast<int>(random.bits() % 6);
    if (kind < 4) return wrong_result(formula, index_below(results, random), kind, random);
    const std::size_t i = index_below(arguments.size(), random);
    return wrong_arguments(formula, i, index_below(arguments.size(), random), kind == 4);
}

} // namespace

StudentsTest students_test_of_units(const FormulaWithUnits& formula)
{
    Random random(first_seed() + 17);
    std::vector<double> example = formula.example;
    const double factor = random.uniform(1, 2); // so that no example can be known beforehand
    for (double& number : example)
        number *= factor;
    return {[formula, example](const Calls& known) {
                UnknownFormula under_test;
                under_test.known = known;
                return test_units(under_test, example, formula.arguments, formula.result);
            },
            example.size()};
}

void check_test(const StudentsTest& test, const std::vector<NumericFormula>& right,
                const std::vector<WrongNumeric>& wrong)
{
    REQUIRE(!right.empty());
    Calls asked;
    for (const NumericFormula& formula : right) {
        const Judgement judgement = judged(test, formula, asked);
        if (judgement.rejected_in != 0) FAIL(accusation(judgement));
    }
    std::vector<std::string> accepted;
    for (const WrongNumeric& formula : wrong)
        if (judged(test, formula.formula, asked).rejected_in == 0) accepted.push_back(formula.clue);
    require_rejected(accepted, wrong.size());
    CHECK(accepted.empty());
}

void check_test_of_units(const std::vector<FormulaWithUnits>& right,
                         const std::vector<FormulaWithUnits>& wrong)
{
    REQUIRE(!right.empty());
    std::vector<std::string> accepted;
    for (const FormulaWithUnits& formula : right) {
        Calls asked;
        const Judgement judgement = judged(students_test_of_units(formula), formula.formula, asked);
        if (judgement.rejected_in != 0) FAIL(accusation(judgement));
    }
    for (const FormulaWithUnits& formula : wrong) {
        Calls asked;
        if (judged(students_test_of_units(formula), formula.formula, asked).rejected_in == 0)
            accepted.push_back(formula.clue);
    }
    require_rejected(accepted, wrong.size());
    CHECK(accepted.empty());
}

std::vector<WrongNumeric> mutants(const NumericFormula& formula,
                                  const std::function<std::vector<double>(unsigned seed)>& draw,
                                  std::size_t count)
{
    constexpr unsigned cases = 40;
    Random random(first_seed() + 4000);
    std::vector<WrongNumeric> all;
    while (all.size() < count) {
        const NumericFormula wrong = mutant(formula, draw(0), random);
        NumericFormula tried = wrong; // has a memory of its own
        unsigned different = 0;
        for (unsigned seed = 0; seed < cases; ++seed)
            different += differs(formula(draw(seed)), tried(draw(seed))) ? 1 : 0;
        if (4 * different >= cases) all.push_back({"", wrong});
    }
    return all;
}

} // namespace rigor::testing
