// SPDX-License-Identifier: MIT
// A build and its suites, told line by line.
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

/// What is built and run: `sample` takes minutes, `all` is what CI runs. tests/CMakeLists.txt says
/// what belongs to which.
enum class SuiteSize { sample, all };

/// Configures and builds a preset of CMakePresets.json and runs its suites. A suite that fails is
/// printed whole.
std::vector<SuiteResult> run_preset(const std::string& preset, SuiteSize size);

} // namespace rigor
