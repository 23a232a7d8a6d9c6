// SPDX-License-Identifier: MIT
// The verdicts that the test program streams: one JSON line before each test case and one after it.
#pragma once

#include "grading/result.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Parses the lines as they come and keeps the verdicts.
class Verdicts {
public:
    /// Parses one line. An error is kept in `fault`.
    void take(std::string_view line);

    const std::vector<TestCase>& of(const std::string& tag) const;
    /// Tag of the last test case that began.
    const std::string& current_tag() const { return tag_; }
    /// Name of the test case that began and has not ended; empty if there is none.
    const std::string& open() const { return open_; }
    /// The first error: a line that could not be parsed or a test case that checked nothing. Empty
    /// if there is none.
    const std::string& fault() const { return fault_; }

private:
    std::map<std::string, std::vector<TestCase>> tests_;
    std::string tag_, open_, fault_;
};

} // namespace rigor
