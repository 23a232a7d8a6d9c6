// SPDX-License-Identifier: MIT
// Each bug to find is a mistake of its topic that the graded tests catch.
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

using namespace rigor::handouts;

namespace {

namespace fs = std::filesystem;

// The code in the section "Find the bug".
std::string bug_of(const Handout& handout)
{
    const std::size_t section = handout.text.find("\n## Find the bug\n");
    if (section == std::string::npos) return "";
    const std::string open = "```cpp\n";
    const std::size_t start = handout.text.find(open, section) + open.size();
    return handout.text.substr(start, handout.text.find("```", start) - start);
}

int mistakes_with(const std::string& code, const fs::path& folder)
{
    int found = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".cpp" &&
            content(entry.path()).find(code) != std::string::npos)
            ++found;
    return found;
}

} // namespace

TEST_CASE("bugs: each one in a handout is a mistake of its topic", "[bugs]")
{
    int bugs = 0;
    for (const Handout& handout : all_handouts()) {
        if (handout.label == "A0") continue; // the warm-up has its bug in the loop
        const std::string topic = handout.name.substr(handout.name.find('-') + 1);
        CAPTURE(handout.label);
        REQUIRE(bug_of(handout).size() > 50);
        CHECK(mistakes_with(bug_of(handout),
                            fs::path(RIGOR_SOURCE_DIR) / "tests/mistakes" / topic) == 1);
        ++bugs;
    }
    CHECK(bugs == 8);
}
