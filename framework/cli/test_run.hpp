// SPDX-License-Identifier: MIT
// Builds a preset, which is a way to build, runs its test suites, and prints a line for each.
#pragma once

#include <string>
#include <vector>

namespace rigor {

struct SuiteResult {
    enum Verdict { passed, failed, skipped };
    std::string name;
    Verdict verdict = passed;
};

/// Checks that every source file is formatted by clang-format; skipped if that is not installed.
SuiteResult check_format();

/// How much is built and run: `sample` takes minutes, `all` is what CI runs. tests/CMakeLists.txt
/// says which tests belong to which size.
enum class SuiteSize { sample, all };

/// Configures and builds a preset of CMakePresets.json and runs its suites. The whole output of a
/// failed suite is printed.
std::vector<SuiteResult> run_preset(const std::string& preset, SuiteSize size);

} // namespace rigor
