// SPDX-License-Identifier: MIT
// The verdicts that the test program streams: one JSON line before each test case, one after it,
// and one at the end.
#pragma once

#include "grading/result.hpp"

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

/// Parses the lines of the test program as they come, and keeps the verdicts.
class Verdicts {
public:
    /// Parses one line. An error is kept in `fault`, and further lines are then ignored.
    void take(std::string_view line);

    const std::vector<TestCase>& of(const std::string& tag) const;
    /// Tag of the last test case that began.
    const std::string& current_tag() const { return tag_; }
    /// Name of the test case that began and has not ended; empty if there is none.
    const std::string& open() const { return open_; }
    /// Whether the last line was the one that the test program prints after all test cases.
    bool is_complete() const { return is_complete_; }
    /// The first error: a line that could not be parsed, or a test case that stalled twice (see
    /// `stalled`). It is empty if there is none.
    const std::string& fault() const { return fault_; }
    /// The test cases in which the framework or the reference failed, not the submission: pairs of
    /// the tag of the task and a sentence. Such a test case counts as failed.
    const std::vector<std::pair<std::string, std::string>>& own_failures() const
    {
        return own_failures_;
    }
    /// Whether the reference failed in a test of this task because the time for it was over. This
    /// is one of the failures in `own_failures`.
    bool was_reference_late(const std::string& tag) const { return late_.count(tag) > 0; }
    /// The time budget that the run has used, and the tags of the formulas that are not called any
    /// more. A later run with the same worker gets this text as its `--spent`.
    const std::string& spent() const { return spent_; }
    /// The formulas that are not called any more and the time budgets that are used up, in words.
    /// It is empty if there are none (worker/time_budget.hpp).
    const std::string& cost() const { return cost_; }
    /// The test cases after which the test program ended itself, because the submission's answers
    /// made it compute without end. The test cases that follow have to run in a new test program.
    const std::vector<std::string>& stalled() const { return stalled_; }
    /// Whether the formula with this tag is not called any more, because it took too long.
    bool is_given_up(std::string_view tag) const;

private:
    void add(const std::string& status, TestCase&& test);
    void add_stalled(const std::string& name);

    std::map<std::string, std::vector<TestCase>> tests_;
    std::string tag_, open_, fault_, spent_, cost_;
    std::vector<std::string> stalled_;
    std::vector<std::pair<std::string, std::string>> own_failures_;
    std::set<std::string> late_;
    bool is_complete_ = false;
};

} // namespace rigor
