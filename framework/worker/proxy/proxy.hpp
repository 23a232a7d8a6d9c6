// SPDX-License-Identifier: MIT
// The formulas as functions that ask a worker. A program links the library `proxy` and calls
// `use_worker`. Then it calls the formulas as the usual headers declare them, for example
// `combine(a, b)`, and an implementation in another process answers.
#pragma once

#include "worker/scene_answers.hpp"

#include <filesystem>
#include <optional>
#include <span>

namespace rigor {

/// Makes the formulas ask this worker from now on. The oracle, the worker of the reference, tells
/// how long a slow call may take and answers `by_reference`.
/// @param oracle  the program of the oracle; it has no value if there is no reference
void use_worker(const std::filesystem::path& executable,
                const std::optional<std::filesystem::path>& oracle = {}, const Limits& limits = {});

/// The worker under test, which the formulas ask as long as no `AskOracle` lives.
/// @throws std::logic_error before use_worker
Worker& worker();

/// The worker that runs the reference; nullptr if there is none.
Worker* oracle();

/// Makes the formulas take their answers from this run of a scene. After a call with nullptr, each
/// formula asks the worker again.
void answer_from(SceneAnswers* run);

/// Until the next call of this function, the reference answers these formulas in place of the
/// worker under test. In a scene, that worker gets these answers too. Outside of scenes, it sees an
/// answer only if a test passes it on as an argument of another formula.
/// @throws std::logic_error if there is no reference
void replace_by_reference(const FormulaSet& these);

/// The formulas that the reference answers at present.
const FormulaSet& replaced_by_reference();

/// Clears `last_call` and `recent_calls`.
void forget_calls();

/// Ends the process of the worker under test, so that the next call starts a fresh one, and forgets
/// the calls.
void renew_worker();

/// A call of a formula with its encoded arguments.
struct FormulaCall {
    FormulaIndex formula;
    Bytes arguments;
};

/// The last call of a formula of the worker under test since `forget_calls`; nullptr without one.
/// Within a scene, only a call that failed is kept.
const FormulaCall* last_call();

/// The last calls of the worker under test since `forget_calls`: up to 64 calls, in any order.
/// Calls whose arguments take more than 16 kB are left out, and within a scene all calls that did
/// not fail.
std::span<const FormulaCall> recent_calls();

/// The largest number for which the reference has to have an answer: formulas multiply up to ten
/// numbers, and their product must fit in a double. Tests ask for larger numbers only where it has
/// an answer too.
inline constexpr double largest_for_reference = 1e30;

/// The reference failed, which is never the fault of the implementation under test.
struct OracleFailure : std::runtime_error {
    /// @param late  whether the time for the reference was over, as on a busy machine
    explicit OracleFailure(const std::string& what, bool late = false)
        : std::runtime_error(what), is_late(late)
    {
    }
    bool is_late;
};

/// Makes the formulas ask the oracle as long as this object lives.
class AskOracle {
public:
    AskOracle();
    ~AskOracle();
    AskOracle(const AskOracle&) = delete;
    AskOracle& operator=(const AskOracle&) = delete;
};

/// The answer of the reference: `by_reference([&] { return combine(a, b); })`.
/// @throws OracleFailure, OwnTimeOver, BeyondReference
template <class Call> auto by_reference(const Call& call)
{
    const AskOracle ask;
    try {
        return call();
    } catch (const OwnTimeOver&) {
        throw; // the answers of the submission keep the test itself busy
    } catch (const BeyondReference&) {
        throw; // the answers of the submission led to arguments without an answer
    } catch (const WorkerFailure& failure) {
        throw OracleFailure(std::string("the reference: ") + failure.what(),
                            failure.cause == WorkerFailure::timed_out);
    } catch (const NotFinite& failure) {
        throw OracleFailure(std::string("the reference: ") + failure.what());
    } catch (const FormulaMissing& failure) {
        throw OracleFailure(std::string("the reference: ") + failure.what());
    } catch (const NotImplemented& failure) {
        throw OracleFailure(std::string("the reference: not implemented: ") + failure.what());
    }
}

} // namespace rigor
