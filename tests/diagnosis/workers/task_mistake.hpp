// SPDX-License-Identifier: MIT
// The diagnosis of a task while its tests run.
#pragma once

#include <string>

namespace rigor::diagnosis {

/// Why the answers of the worker under test to the formula of a task are wrong, in one sentence.
/// Empty if nothing is known: without an oracle, for a task without a formula, or if no relation
/// was found. The calls of the running test case help, so the next test case is another chance, as
/// long as the task has time left.
std::string task_mistake(const std::string& tag);

} // namespace rigor::diagnosis
