// SPDX-License-Identifier: MIT
// The ways in which an implementation can fail to give a valid answer. A student's code can cause
// no other exceptions in a call of a `Worker` than these and `NotImplemented`. A call through the
// proxy can also throw std::out_of_range (proxy/answer_sizes.hpp), and the run of a scene
// std::domain_error, if with the answers a spring is too stiff or a longest step is 0. Any other
// exception is a fault in the framework.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace rigor {

/// The worker gave no answer. what() is a sentence:
/// `A4.10 apply_impulse crashed: segmentation fault`.
struct WorkerFailure : std::runtime_error {
    enum Cause {
        crashed,   // a signal ended or stopped the process, or it made a forbidden system call
        exited,    // the process ended itself, with an exit status
        timed_out, // no answer within the time limit, or the formula was given up (TimeBudget)
        flooded,   // the process printed or streamed more bytes than its limit
        malformed, // the process sent bytes that are not a valid answer
        threw,     // the formula threw an exception
    };

    WorkerFailure(Cause why, const std::string& about, const std::string& what_happened)
        : std::runtime_error(about + " " + what_happened), cause(why), subject(about)
    {
    }

    /// The status of a test that ended with this failure.
    std::string_view status() const { return cause == timed_out ? "timed_out" : "crashed"; }

    Cause cause;
    std::string subject; // what failed: "A4.10 apply_impulse", "scene bounce"
    std::string output;  // the beginning of what the implementation printed
};

/// The test itself, or the engine in one of its scenes, takes too long. The formula that is being
/// called is not the cause.
struct OwnTimeOver : WorkerFailure {
    OwnTimeOver(const std::string& about, const std::string& what_happened)
        : WorkerFailure(timed_out, about, what_happened)
    {
    }
};

/// A formula that the implementation does not define, or defines with another signature. what()
/// is, for example, `A4.10 apply_impulse is not defined`.
struct FormulaMissing : std::runtime_error {
    /// @param asked    what the client asked for: a formula, a formula in a scene, or a scene
    /// @param missing  the formula that is not defined: the same one, or one that `asked` calls
    FormulaMissing(const std::string& asked, const std::string& missing)
        : std::runtime_error(asked.starts_with(missing)
                                 ? missing + " is not defined"
                                 : asked + " calls " + missing + ", which is not defined")
    {
    }
};

/// An answer, or a state in a scene, that contains NaN or infinity. what() is, for example,
/// `A4.10 apply_impulse: angular_momentum.y is NaN`.
struct NotFinite : std::runtime_error {
    NotFinite(const std::string& about, const std::string& which)
        : std::runtime_error(about + ": " + which), subject(about), quantity(which)
    {
    }
    std::string subject, quantity;
};

/// The reference has no answer for numbers beyond `largest_for_reference`. No test and no scene
/// asks for them by itself, so the submission's answers led there, and the reference is not to
/// blame.
struct BeyondReference : NotFinite {
    using NotFinite::NotFinite;
};

} // namespace rigor
