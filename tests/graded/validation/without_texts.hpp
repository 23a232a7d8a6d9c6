// SPDX-License-Identifier: MIT
// A judgement about a hidden formula. A student's test has seen calls of this formula with their
// results, and can quote them in what it throws. The report tells of hidden formulas how many
// passed, and no more, so the texts of the test are replaced by words that it cannot choose.
#pragma once

#include "formulas/table.hpp"
#include "support/catch.hpp"
#include "worker/failure.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

namespace rigor::testing {

/// What a student's test did instead of sending a judgement.
inline std::string without_details(WorkerFailure::Cause cause)
{
    switch (cause) {
    case WorkerFailure::crashed:
        return "crashed";
    case WorkerFailure::exited:
        return "ended the program";
    case WorkerFailure::timed_out:
        return "did not return in time";
    case WorkerFailure::flooded:
        return "printed too much";
    case WorkerFailure::malformed:
        return "sent no judgement";
    case WorkerFailure::threw:
        return "threw an exception";
    }
    return "failed";
}

/// Whether a text is that of the stub of a student's test.
inline bool is_stub_of_test(std::string_view text)
{
    return std::any_of(std::begin(formulas), std::end(formulas), [&](const Formula& formula) {
        return formula.topic == "validation" &&
               text == std::string(formula.topic) + "::" + std::string(formula.name);
    });
}

/// The result of `judge()`, which may throw. What is thrown has no text of the student's test.
template <class Judge> Judgement without_texts(const Judge& judge)
{
    try {
        return judge();
    } catch (const OwnTimeOver&) {
        throw; // this text is ours
    } catch (const WorkerFailure& failure) {
        throw WorkerFailure(failure.cause, failure.subject,
                            without_details(failure.cause) +
                                " on a hidden formula; its texts are not shown");
    } catch (const NotFinite& failure) {
        throw NotFinite(failure.subject, "a question has a number that is not finite");
    } catch (const std::out_of_range&) {
        FAIL("the test sent a question that is none");
    } catch (const NotImplemented& stub) {
        if (is_stub_of_test(stub.what())) throw;
        FAIL("the test calls a stub on a hidden formula");
    }
    return {};
}

} // namespace rigor::testing
