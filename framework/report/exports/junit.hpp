// SPDX-License-Identifier: MIT
#pragma once

#include "grading/result.hpp"

#include <string>

namespace rigor {

/// A result as JUnit XML, as Jenkins, GitLab and others read it (junit-10.xsd of the xUnit plugin):
/// a test suite with the test cases of all tasks. A task that did not run is skipped. If the
/// submission could not be graded, each task is an error.
std::string junit_xml(const Result& result);

} // namespace rigor
