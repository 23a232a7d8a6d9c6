// SPDX-License-Identifier: MIT
// Defines every formula of the table in formulas/table.hpp. Each function encodes its arguments,
// asks the worker, decodes the result, and checks it for NaN and infinity and for the lengths of
// its lists. While a scene runs, the next answer of the stream is the result, and its numbers must
// also be in the range of those of a scene. If the reference fails, and an argument is so large
// that the submission's answers must have led to it, the submission failed.
#include "worker/proxy/proxy.hpp"

#include "rigid/bodies/non_finite.hpp"
#include "worker/protocol/define_formulas.hpp"
#include "worker/protocol/finite.hpp"
#include "worker/proxy/answer_sizes.hpp"
#include "worker/proxy/own_time.hpp"

#include <memory>

namespace rigor {

namespace {

std::unique_ptr<Worker> under_test, reference;
Worker* asked = nullptr;
SceneAnswers* run = nullptr;
FormulaCall last;      // keeps its memory, since a long list needs much
bool has_last = false; // whether there was a call since `forget_calls`
std::vector<FormulaCall> recent;
FormulaSet replaced;
std::size_t oldest = 0; // index of the recent call that is replaced next, once the list is full

/// Formulas whose result may be infinite: the longest time step of a rotation, which may be
/// arbitrarily slow, and the yield strain of a material without stiffness.
constexpr bool may_be_infinite(FormulaIndex formula)
{
    return formula == FormulaIndex::max_time_step || formula == FormulaIndex::yield_strain;
}

template <class Result>
void refuse_non_finite(FormulaIndex formula, const Result& result, double largest = any_magnitude)
{
    if (is_finite(result, largest)) return;
    if constexpr (std::is_same_v<Result, double>)
        if (may_be_infinite(formula) && result > 0) return;
    throw NotFinite(subject_of(formula), find_non_finite(result, largest));
}

/// Called after the reference failed. If an argument is larger than those that the reference must
/// handle, throws `BeyondReference`.
template <class... Argument>
void excuse_reference(FormulaIndex formula, const Argument&... arguments)
{
    std::string which;
    ((which.empty() ? void(which = find_non_finite(arguments, largest_for_reference)) : void()),
     ...);
    if (which.empty()) return;
    throw BeyondReference(subject_of(formula),
                          "the answers so far lead to an argument without an answer: " + which);
}

/// Keeps a call among the recent ones. A call with long arguments is left out, to save memory.
void keep(FormulaIndex formula, const wire::Bytes& arguments)
{
    constexpr std::size_t most = 64, longest = std::size_t{1} << 14;
    if (arguments.size() > longest) return;
    if (recent.size() < most) {
        recent.push_back({formula, arguments});
        return;
    }
    recent[oldest].formula = formula;
    recent[oldest].arguments.assign(arguments.begin(), arguments.end());
    oldest = (oldest + 1) % most;
}

template <class Result> Result decoded(FormulaIndex formula, std::span<const std::byte> encoded)
{
    try {
        return wire::decode_all<Result>(encoded);
    } catch (const wire::Malformed& malformed) {
        asked->renew();
        throw WorkerFailure(WorkerFailure::malformed, subject_of(formula),
                            std::string("sent no answer: ") + malformed.what());
    }
}

/// Encodes the arguments of a call; the result is valid until the next call. A call of the worker
/// under test is also kept, for `last_call` and `recent_calls`.
template <class... Argument>
const wire::Bytes& note_call(FormulaIndex formula, const Argument&... arguments)
{
    if (asked == reference.get()) {
        static wire::Bytes bytes;
        wire::encode_all(bytes, arguments...);
        return bytes;
    }
    last.formula = formula;
    has_last = true;
    wire::encode_all(last.arguments, arguments...);
    keep(formula, last.arguments);
    return last.arguments;
}

/// Gives the worker under test an answer of the reference, if that worker runs a scene.
template <FormulaIndex formula, class Result> void give(const Result& result)
{
    if (!run) return;
    static wire::Bytes bytes;
    wire::encode_all(bytes, result);
    run->give(formula, bytes);
}

template <FormulaIndex formula, class Formula, class... Argument>
typename Formula::Result answer(const Argument&... arguments)
{
    using Result = typename Formula::Result;
    static const std::size_t largest = wire::encoded_size<Result>().most;
    if (!asked) throw std::logic_error("a formula was called before use_worker said whom to ask");
    note_formula(formula);
    const bool is_by_reference = asked == reference.get();
    if (replaced[static_cast<unsigned>(formula)] && !is_by_reference) {
        Result result = by_reference([&] { return answer<formula, Formula>(arguments...); });
        give<formula>(result);
        return result;
    }
    if (run && !is_by_reference) {
        try {
            Result result = decoded<Result>(formula, run->next(formula, largest));
            // The result becomes a part of the states, and an argument of formulas of the
            // reference, which must not fail because of it.
            refuse_non_finite(formula, result, largest_in_scene);
            check_sizes<formula>(result, arguments...);
            return result;
        } catch (...) {
            note_call(formula, arguments...);
            throw;
        }
    }
    const wire::Bytes& encoded = note_call(formula, arguments...);
    try {
        Result result = decoded<Result>(formula, asked->call(formula, encoded, largest));
        refuse_non_finite(formula, result);
        check_sizes<formula>(result, arguments...);
        return result;
    } catch (const std::exception&) {
        if (is_by_reference) excuse_reference(formula, arguments...);
        throw;
    }
}

} // namespace

RIGOR_FORMULAS(RIGOR_DEFINE_FORMULA)

void use_worker(const std::filesystem::path& executable,
                const std::optional<std::filesystem::path>& oracle_executable, const Limits& limits)
{
    asked = nullptr;
    under_test.reset();
    Limits patient = limits; // the limits of the reference, which is trusted and has long limits
    patient.trust = Trust::ours;
    patient.call = patient.scene = limits.oracle;
    reference = oracle_executable ? std::make_unique<Worker>(*oracle_executable, patient) : nullptr;
    under_test = std::make_unique<Worker>(executable, limits, reference.get());
    asked = under_test.get();
}

Worker& worker()
{
    if (!under_test) throw std::logic_error("use_worker has not been called");
    return *under_test;
}

Worker* oracle()
{
    return reference.get();
}

const FormulaCall* last_call()
{
    return has_last ? &last : nullptr;
}

std::span<const FormulaCall> recent_calls()
{
    return recent;
}

void replace_by_reference(const FormulaSet& these)
{
    if (these.any() && !reference) throw std::logic_error("there is no reference to ask");
    replaced = these;
}

const FormulaSet& replaced_by_reference()
{
    return replaced;
}

void answer_from(SceneAnswers* answers)
{
    run = answers;
}

void forget_calls()
{
    has_last = false;
    recent.clear();
    oldest = 0;
}

void renew_worker()
{
    forget_calls();
    worker().renew();
}

AskOracle::AskOracle()
{
    if (!reference) throw std::logic_error("there is no reference to ask");
    asked = reference.get();
}
AskOracle::~AskOracle()
{
    asked = under_test.get();
}

} // namespace rigor
