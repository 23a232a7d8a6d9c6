// SPDX-License-Identifier: MIT
// The stream of verdicts of the test program: one JSON line before each test case and one after it.
#pragma once

#include "grading/result.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Takes the lines as they come and keeps what they say.
class Verdicts {
public:
    /// What goes wrong is kept in `fault`.
    void take(std::string_view line);

    const std::vector<TestCase>& of(const std::string& tag) const;
    /// Tag of the last test case that began.
    const std::string& current_tag() const { return tag_; }
    /// Name of the test case that began and has not ended; empty if there is none.
    const std::string& open() const { return open_; }
    /// The first line that could not be understood, or checked nothing; empty if all is well.
    const std::string& fault() const { return fault_; }

private:
    std::map<std::string, std::vector<TestCase>> tests_;
    std::string tag_, open_, fault_;
};

} // namespace rigor
