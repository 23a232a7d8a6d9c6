// SPDX-License-Identifier: MIT
#include "diagnosis/workers/diagnosis.hpp"

#include "diagnosis/formula_types.hpp"
#include "diagnosis/search.hpp"
#include "diagnosis/special_cases.hpp"
#include "worker/protocol/wire.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace rigor::diagnosis {

namespace {

using Seconds = std::chrono::duration<double>;

// A yes or no says less than a number, so that more of them are needed.
constexpr unsigned drawn_inputs = 48, drawn_for_yes_or_no = 144;
constexpr unsigned first_seed = 90000; // apart from the seeds of the tests
constexpr int neighbours_each = 3;
constexpr int failures_allowed = 3; // crashes of an implementation, before it is not asked again

// The time that a diagnosis has left. It counts processor time, so that a busy machine does not
// change what is found, and bounds the time on the clock to a multiple of that.
class Budget {
public:
    explicit Budget(Seconds time)
        : time_(time), processor_(processor_time()), start_(std::chrono::steady_clock::now())
    {
    }
    bool used_up() const
    {
        constexpr double most_waiting = 10;
        return processor_time() - processor_ > time_ ||
               std::chrono::steady_clock::now() - start_ > most_waiting * time_;
    }

private:
    static Seconds processor_time()
    {
        return Seconds(static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
    }

    Seconds time_, processor_;
    std::chrono::steady_clock::time_point start_;
};

// One implementation, which may fail in every way.
class Asked {
public:
    Asked(Worker& worker, FormulaIndex formula, const Budget& budget)
        : worker_(worker), formula_(formula), budget_(budget)
    {
    }

    std::optional<Value> operator()(const Value& arguments)
    {
        if (failures_ >= failures_allowed || budget_.used_up()) return {};
        const FormulaType& type = type_of(formula_);
        try {
            return type.decode_answer(
                worker_.call(formula_, type.arguments.encode(arguments), type.largest));
        } catch (const std::exception&) {
            ++failures_; // whatever happened: no answer, and no diagnosis from it
            return {};
        }
    }

private:
    Worker& worker_;
    FormulaIndex formula_;
    const Budget& budget_;
    int failures_ = 0;
};

// Random arguments, all different from those of the tests.
std::vector<Input> drawn_inputs_of(const FormulaType& type, unsigned seed)
{
    std::vector<Input> inputs;
    const Form form = type.answer.roles[0].form;
    const bool is_number = form == Form::real || form == Form::quaternion;
    const unsigned n = is_number ? drawn_inputs : drawn_for_yes_or_no;
    for (unsigned i = 0; i < n; ++i)
        inputs.push_back({type.arguments.decode(type.draw(first_seed + seed * n + i)), true, 1});
    return inputs;
}

// Special cases of the drawn arguments, and the calls of tests, each with a few inputs like it.
std::vector<Input> special_inputs_of(const FormulaType& type, const std::vector<Input>& drawn,
                                     const std::vector<Bytes>& calls)
{
    std::vector<Value> values;
    for (const Input& input : drawn)
        values.push_back(input.arguments);
    std::vector<Input> inputs = special_cases(type.arguments, values);
    for (const Bytes& call : calls) {
        inputs.push_back({type.arguments.decode(call), false, 1e-9});
        for (Input& near :
             neighbours(type.arguments, inputs.back().arguments, first_seed, neighbours_each))
            inputs.push_back(std::move(near));
    }
    return inputs;
}

// The size of usual answers.
double usual_size(const std::vector<Case>& cases)
{
    std::vector<double> sizes;
    for (const Case& c : cases)
        if (c.is_drawn) sizes.push_back(norm(c.right.numbers));
    if (sizes.empty()) return 0;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<long>(sizes.size() / 2),
                     sizes.end());
    return std::isfinite(sizes[sizes.size() / 2]) ? sizes[sizes.size() / 2] : 0;
}

// Asks for the answers to more inputs. @return how many of them have both answers
std::size_t gather(Evidence& evidence, const std::vector<Input>& inputs, Asked& student,
                   Asked& reference)
{
    constexpr double rounding_noise = 1e-13; // relative to a usual answer
    std::vector<Case> cases;
    std::vector<double> smallest;
    for (const Input& input : inputs) {
        auto answer = student(input.arguments);
        auto right = reference(input.arguments);
        if (!answer || !right) continue;
        cases.push_back({input.arguments, *right, *answer, input.is_drawn, 0, {}});
        smallest.push_back(input.smallest);
    }
    const double size = usual_size(evidence.cases.empty() ? cases : evidence.cases);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        cases[i].noise = rounding_noise * size * smallest[i];
        evidence.cases.push_back(compared(evidence.answer, std::move(cases[i])));
    }
    return cases.size();
}

std::size_t wrong_in(const Evidence& evidence)
{
    return static_cast<std::size_t>(std::count_if(evidence.cases.begin(), evidence.cases.end(),
                                                  [](const Case& c) { return c.is_different(); }));
}

// Whether a known mistake answers as the implementation does, and how often that is wrong.
bool answers_alike(const Evidence& evidence, Asked& mistake)
{
    std::size_t wrong_drawn = 0, wrong = 0, unlike = 0;
    for (const Case& c : evidence.cases) {
        const auto answer = mistake(c.arguments);
        if (!answer) return false;
        const bool is_alike = agree(evidence.answer, *answer, c.answer, c.noise);
        if (!is_alike && c.is_drawn) return false;
        unlike += !is_alike;
        if (!is_alike || !c.is_different()) continue;
        ++wrong;
        wrong_drawn += c.is_drawn;
    }
    // Special cases of a formula that is wrong everywhere may be wrong in their own way.
    constexpr std::size_t enough_special = 3;
    return wrong_drawn >= enough || (unlike == 0 && wrong >= enough_special);
}

Diagnosis by_known_mistake(FormulaIndex formula, const Evidence& evidence, const Means& means,
                           const Budget& budget)
{
    for (const KnownMistake& known : known_mistakes(means.mistakes, formula)) {
        if (known.name == means.left_out) continue;
        Limits limits = means.limits;
        limits.trust = Trust::ours;
        Worker worker(known.worker, limits);
        Asked mistake(worker, formula, budget);
        if (answers_alike(evidence, mistake))
            return {Diagnosis::By::known_mistake, known.name,
                    "This mistake gives the same answers: " + known.explanation};
    }
    return {};
}

// Whether the implementation answers the same arguments differently later.
bool remembers(const Evidence& evidence, Asked& student)
{
    constexpr std::size_t step = 5;
    for (std::size_t i = 0; i < evidence.cases.size(); i += step) {
        const Case& c = evidence.cases[evidence.cases.size() - 1 - i];
        const auto again = student(c.arguments);
        if (again && !agree(evidence.answer, c.answer, *again, c.noise)) return true;
    }
    return false;
}

Diagnosis::By sort_of(Finding::Sort sort)
{
    switch (sort) {
    case Finding::Sort::relation:
        return Diagnosis::By::relation;
    case Finding::Sort::condition:
        return Diagnosis::By::condition;
    case Finding::Sort::no_effect:
        return Diagnosis::By::no_effect;
    case Finding::Sort::part:
        break;
    }
    return Diagnosis::By::part;
}

// The diagnosis of what was asked, by known mistakes and then by relations.
Diagnosis concluded(FormulaIndex formula, const Evidence& evidence, const Means& means,
                    const Budget& budget, Asked& student)
{
    if (means.uses_known)
        if (Diagnosis known = by_known_mistake(formula, evidence, means, budget);
            !known.sentence.empty())
            return known;
    if (!means.uses_relations) return {};
    if (remembers(evidence, student))
        return {Diagnosis::By::memory, "",
                "Your answer to the same arguments changes with the calls before it: a variable "
                "keeps its value between calls, or the code reads what lies behind the end of a "
                "list."};
    const auto found = explain(evidence, std::ref(student));
    // What was refused for lack of time may have been simpler.
    if (!found || budget.used_up()) return {};
    return {sort_of(found->sort), "", found->sentence};
}

} // namespace

Diagnosis diagnose(FormulaIndex formula, const std::vector<Bytes>& calls, const Means& means)
{
    const Budget budget(means.time);
    Worker implementation(means.implementation, means.limits);
    Asked student(implementation, formula, budget), reference(*means.reference, formula, budget);
    try {
        const FormulaType& type = type_of(formula);
        const std::vector<Input> drawn = drawn_inputs_of(type, means.seed);
        Evidence evidence = {type.arguments, type.answer, {}, std::ref(reference)};
        // An answer that is missing would make the others look alike.
        if (gather(evidence, drawn, student, reference) < drawn.size()) return {};
        if (wrong_in(evidence) < enough)
            gather(evidence, special_inputs_of(type, drawn, calls), student, reference);
        if (wrong_in(evidence) == 0) return {};
        return concluded(formula, evidence, means, budget, student);
    } catch (const std::exception&) {
        return {}; // an answer that cannot be taken apart is no fault of the grading
    }
}

} // namespace rigor::diagnosis
