// SPDX-License-Identifier: MIT
// The verdicts that the test program streams: one JSON line before each test case, one after it,
// and one at the end.
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
    /// Whether the program said last that all its test cases have run.
    bool is_complete() const { return is_complete_; }
    /// The first error: a line that could not be parsed or a test case that checked nothing. Empty
    /// if there is none.
    const std::string& fault() const { return fault_; }
    /// What failed through no fault of the submission: for each test case the tag of its task, and
    /// a sentence. Such a test case counts as failed.
    const std::vector<std::pair<std::string, std::string>>& own_failures() const
    {
        return own_failures_;
    }
    /// What the run has cost, for a later run of the same worker.
    const std::string& spent() const { return spent_; }
    /// The cost in words; empty while all is within the free time.
    const std::string& cost() const { return cost_; }
    /// The test cases at which the program ended itself, because it computed without end with the
    /// answers. What comes after them has not run.
    const std::vector<std::string>& stalled() const { return stalled_; }
    /// Whether the formula with this tag is not asked any more, because it did not return.
    bool is_given_up(std::string_view tag) const;

private:
    void add(const std::string& status, TestCase&& test);
    void add_stalled(const std::string& name);

    std::map<std::string, std::vector<TestCase>> tests_;
    std::string tag_, open_, fault_, spent_, cost_;
    std::vector<std::string> stalled_;
    std::vector<std::pair<std::string, std::string>> own_failures_;
    bool is_complete_ = false;
};

} // namespace rigor
