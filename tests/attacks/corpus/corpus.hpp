// SPDX-License-Identifier: MIT
// The corpus of hostile submissions: what each of them is, and what it may get.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rigor::corpus {

/// What may come of a submission.
struct Expectation {
    double points = 0;
    /// The statuses that the submission may have, or its tasks if it was graded. If the last one is
    /// `passed`, the submission may also pass, and its points do not matter.
    std::vector<std::string> statuses;
    std::string text; // a part of the message, or of one task's; empty for any

    bool may_pass() const { return statuses.back() == "passed"; }
};

struct HostileSubmission {
    std::string name; // "kernel/socket"
    Expectation expected;
    /// Writes it below a folder. @return the folder or archive
    std::function<std::filesystem::path(const std::filesystem::path& folder)> write;
    std::string topic = "pipeline";      // whose file is handed in
    std::vector<std::string> tasks = {}; // tags of those that are graded; empty for all
};

/// Sources, from tests/attacks/submissions/<kind>/<name>.cpp. A line of each says what to expect:
///
///     // expect: POINTS STATUS[|STATUS...][: a part of the message]
///
/// and two others, where it does not attack A0, say what:
///
///     // topic: validation
///     // tasks: A8.1 A8.3
///
/// The headers beside a source go with it. A line `// beside: split_element` hands it in with a
/// whole solution, whose own formula of that name is `right_split_element`.
std::vector<HostileSubmission> hostile_sources(const std::filesystem::path& submissions);

/// The attacks on A0 in all other topics, `kernel/socket@rotation`: one formula of a solution
/// attacks first and then returns what is right. Such a submission may get its points; if its file
/// is refused, it gets none.
std::vector<HostileSubmission> in_other_topics(const std::filesystem::path& submissions);

/// One of them for each kind of attack, drawn by the seed.
std::vector<HostileSubmission> drawn_of_each_kind(const std::vector<HostileSubmission>& all,
                                                  unsigned seed);

/// Folders and archives that are hostile by their names or by what they hold.
/// @param solution  the text of a file that gets every point
std::vector<HostileSubmission> hostile_intakes(const std::string& solution);

} // namespace rigor::corpus
