// SPDX-License-Identifier: MIT
// Builds this project with a preset of CMake, runs the test suites of that build, and prints a line
// for each suite.
#pragma once

#include <string>
#include <vector>

namespace rigor {

struct SuiteResult {
    enum Verdict { passed, failed, skipped };
    std::string name;
    Verdict verdict = passed;
};

/// Checks that every source file is formatted by clang-format. If clang-format is not installed,
/// the verdict is `skipped`.
SuiteResult check_format();

/// How much is built and run: `sample` takes minutes, `all` is what CI runs. tests/CMakeLists.txt
/// says which tests belong to which size.
enum class SuiteSize { sample, all };

/// Configures and builds a preset of CMakePresets.json, such as "release", and runs its test
/// suites. If a suite fails, its whole output is printed; if the build fails, the end of its
/// output.
std::vector<SuiteResult> run_preset(const std::string& preset, SuiteSize size);

} // namespace rigor
