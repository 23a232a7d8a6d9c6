// SPDX-License-Identifier: MIT
// A build of everything, and its suites, told line by line.
#pragma once

#include <string>
#include <vector>

namespace rigor {

struct SuiteResult {
    enum Verdict { passed, failed, skipped };
    std::string name;
    Verdict verdict = passed;
};

/// Whether every source file is as clang-format would have it; skipped where that is not installed.
SuiteResult check_format();

/// Configures and builds a preset of CMakePresets.json and runs all its suites. A suite that fails is printed whole.
/// @throws InputError if there is no such preset
std::vector<SuiteResult> run_preset(const std::string& preset);

} // namespace rigor
