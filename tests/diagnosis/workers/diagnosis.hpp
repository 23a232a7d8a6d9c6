// SPDX-License-Identifier: MIT
// Why the answers of an implementation are wrong, in one sentence.
//
// An implementation and the reference are asked the same: random arguments of the formula, special
// cases of them, and calls that a test has made. A known mistake that gives the same answers is
// named first; otherwise a relation of the answers to the right ones that holds on every input. If
// there is none, nothing is said.
#pragma once

#include "diagnosis/evidence.hpp"
#include "diagnosis/workers/known_mistakes.hpp"
#include "worker/client.hpp"

namespace rigor::diagnosis {

struct Diagnosis {
    enum class By { nothing, known_mistake, relation, condition, no_effect, part, memory };
    By by = By::nothing;
    std::string mistake;  // the name of the known mistake
    std::string sentence; // empty if nothing is known
};

/// What may be used for a diagnosis.
struct Means {
    std::filesystem::path implementation; // the worker that is asked
    Limits limits;                        // for it
    Worker* reference = nullptr;
    MistakeFolders mistakes = own_mistake_folders();
    std::string left_out; // a known mistake that must not be named
    bool uses_known = true, uses_relations = true;
    std::chrono::duration<double> time{1}; // processor time for all [s]
    unsigned seed = 0;                     // draws the inputs
};

/// Why the answers of the implementation to a formula are wrong. Whatever the implementation does,
/// this returns in about the time allowed.
/// @param calls  encoded arguments of calls in which tests found it wrong
Diagnosis diagnose(FormulaIndex formula, const std::vector<Bytes>& calls, const Means& means);

} // namespace rigor::diagnosis
