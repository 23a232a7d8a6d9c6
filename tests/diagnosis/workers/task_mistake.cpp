// SPDX-License-Identifier: MIT
#include "diagnosis/workers/task_mistake.hpp"

#include "diagnosis/formula_types.hpp"
#include "diagnosis/workers/diagnosis.hpp"
#include "worker/proxy/proxy.hpp"

#include <map>

namespace rigor::diagnosis {

namespace {

using Seconds = std::chrono::duration<double>;

constexpr Seconds for_a_task{1.0 * sanitizer_factor}, for_a_call{0.1 * sanitizer_factor};

struct TaskState {
    Seconds used{};
    std::string sentence;
};

Limits limits_for(Trust trust)
{
    Limits limits;
    if (!is_sanitized) limits.trust = trust;
    limits.start = for_a_task;
    limits.call = for_a_call;
    limits.all_calls = for_a_task; // without an oracle, one formula may take all of it
    return limits;
}

// A test that a student wrote may ask what it likes, so what it asks first says nothing about its
// mistake. The verdict says which wrong formulas it accepts.
bool is_test(FormulaIndex formula)
{
    return formulas[static_cast<unsigned>(formula)].topic == "validation";
}

std::string diagnosed(FormulaIndex formula, Seconds time)
{
    std::vector<Bytes> calls;
    for (const FormulaCall& call : recent_calls())
        if (call.formula == formula) calls.push_back(call.arguments);
    // The oracle of the tests has all the time it needs; this one has as little as the student's.
    static Worker reference(oracle()->executable(), limits_for(Trust::ours));
    Means means;
    means.implementation = worker().executable();
    means.limits = limits_for(Trust::students);
    means.reference = &reference;
    means.time = time;
    return diagnose(formula, calls, means).sentence;
}

} // namespace

std::string task_mistake(const std::string& tag)
{
    static std::map<std::string, TaskState> states;
    const auto formula = formula_with(tag);
    if (!formula || is_test(*formula) || !oracle() || worker().budget().starts_are_used_up())
        return "";
    TaskState& state = states[tag];
    if (!state.sentence.empty() || state.used >= for_a_task) return state.sentence;
    const auto start = std::chrono::steady_clock::now();
    try {
        state.sentence = diagnosed(*formula, for_a_task - state.used);
    } catch (const std::exception&) {
        // No diagnosis may end the grading.
    }
    state.used += std::chrono::steady_clock::now() - start;
    return state.sentence;
}

} // namespace rigor::diagnosis
