// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include "drawn_forms.hpp"
#include "support/catch.hpp"
#include "support/in_words.hpp"
#include "support/random.hpp"
#include "support/seeds.hpp"
#include "without_texts.hpp"
#include "worker/proxy/proxy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace rigor::testing {

namespace {

constexpr std::size_t most_calls = 1000; // as formulas/validation.hpp says

using Calls = std::vector<KnownCall>;

// Keeps the calls before the question of the test, and adds the question with its answer. The proxy
// has refused a question that is none, but the programs for a debugger have no proxy.
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

// The judgement of the test about a formula. The test begins in a new worker and without known
// calls, so that it cannot remember another formula.
Judgement judged(const StudentsTest& test, const NumericFormula& formula)
{
    renew_worker();
    Calls known;
    // Each round but the last calls the formula once, also if the test forgets earlier calls.
    for (std::size_t round = 0; round <= most_calls; ++round) {
        const Judgement judgement = test.judgement(known);
        if (judgement.question.empty()) return judgement;
        answer(known, judgement, formula, test.arguments);
    }
    FAIL("the test does not come to its end: it makes other calls whenever it is run, although the "
         "results are the same");
    return {};
}

// The line is the test's own word, any number. So it is not told where it could carry the
// results of a hidden formula.
std::string accusation(const Judgement& judgement, Texts texts)
{
    const std::string accusation = "the test rejects a formula that is right";
    if (texts == Texts::kept) return accusation;
    return fmt::format("{}, in line {}", accusation, judgement.rejected_in);
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

// A formula on which a test is tried.
struct Candidate {
    StudentsTest test;
    NumericFormula formula;
    bool is_right;
    std::string clue;
    bool is_accepted = false;
};

// A test that reads the clock can find out how many formulas came before. So their order is random,
// and says nothing about which of them are right.
std::vector<std::size_t> drawn_order(std::size_t n)
{
    Random random(first_seed() + 29);
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), 0);
    for (std::size_t i = n; i > 1; --i) // Fisher and Yates
        std::swap(order[i - 1], order[random.bits() % i]);
    return order;
}

// When this object ends, the test's process ends too, and what it has printed is dropped. It would
// otherwise be told with a later failure.
class PrintsNothing {
public:
    PrintsNothing() = default;
    ~PrintsNothing()
    {
        try {
            renew_worker();
            worker().take_output();
        } catch (const std::exception&) {
            // The next judgement starts a new process, or fails for the same reason.
        }
    }
    PrintsNothing(const PrintsNothing&) = delete;
    PrintsNothing& operator=(const PrintsNothing&) = delete;
};

Judgement judged(const Candidate& candidate, Texts texts)
{
    if (texts == Texts::told) return judged(candidate.test, candidate.formula);
    return without_texts([&] {
        const PrintsNothing printed_is_dropped;
        return judged(candidate.test, candidate.formula);
    });
}

void check_test(std::vector<Candidate> candidates, Texts texts)
{
    std::size_t wrong_ones = 0;
    for (const std::size_t i : drawn_order(candidates.size())) {
        Candidate& candidate = candidates[i];
        candidate.formula = with_drawn_digits(candidate.formula, static_cast<unsigned>(i));
        const Judgement judgement = judged(candidate, texts);
        candidate.is_accepted = judgement.rejected_in == 0;
        if (candidate.is_right && !candidate.is_accepted) FAIL(accusation(judgement, texts));
        wrong_ones += candidate.is_right ? 0 : 1;
    }
    check_that(wrong_ones > 0 && wrong_ones < candidates.size(),
               "formulas that are right, and others that are wrong");
    std::vector<std::string> accepted;
    for (const Candidate& candidate : candidates)
        if (!candidate.is_right && candidate.is_accepted) accepted.push_back(candidate.clue);
    require_rejected(accepted, wrong_ones);
    check_count(accepted.size(), 0, "wrong formulas that your test accepts");
}

} // namespace

StudentsTest students_test_of_units(const FormulaWithUnits& formula)
{
    Random random(static_cast<unsigned>(one_way(17)));
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
                const std::vector<WrongNumeric>& wrong, Texts texts)
{
    std::vector<Candidate> candidates;
    for (const NumericFormula& formula : right)
        candidates.push_back({test, formula, true, ""});
    for (const WrongNumeric& formula : wrong)
        candidates.push_back({test, formula.formula, false, formula.clue});
    check_test(std::move(candidates), texts);
}

void check_test_of_units(const std::vector<FormulaWithUnits>& right,
                         const std::vector<FormulaWithUnits>& wrong, Texts texts)
{
    std::vector<Candidate> candidates;
    const auto add = [&](const FormulaWithUnits& formula, const NumericFormula& form,
                         bool is_right) {
        const unsigned seed = static_cast<unsigned>(candidates.size());
        candidates.push_back({students_test_of_units(formula), with_drawn_factors(form, seed),
                              is_right, is_right ? "" : formula.clue});
    };
    for (const FormulaWithUnits& formula : right)
        add(formula, formula.formula, true);
    for (const FormulaWithUnits& formula : wrong) {
        if (!formula.right) throw std::logic_error("a wrong formula with units has no right one");
        add(formula, formula.formula, false);
        add(formula, formula.right, true);
    }
    check_test(std::move(candidates), texts);
}

} // namespace rigor::testing
