// SPDX-License-Identifier: MIT
// Each task of a formula has a checkpoint: an example with numbers, which a test of this folder
// computes.
#include "formulas/table.hpp"
#include "handouts/handouts.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <regex>

using namespace rigor::handouts;

namespace {

// The text of a task's section after the word "Checkpoint:", in one line; empty if it has none.
std::string checkpoint_of(const std::string& handout, std::string_view tag)
{
    const std::size_t start = handout.find("\n### " + std::string(tag) + " ");
    if (start == std::string::npos) return {};
    const std::size_t end = handout.find("\n##", start + 1);
    const std::string section = handout.substr(start, end - start);
    const std::size_t word = section.find("\nCheckpoint:");
    return word == std::string::npos ? "" : in_one_line(section.substr(word));
}

// The texts in quotes of a source, where those that follow each other are one.
std::string texts_of(const std::string& source)
{
    static const std::regex seam("\"\\s+\"");
    return in_one_line(std::regex_replace(source, seam, ""));
}

// What the calls `check_shown("A4", quote, …)` of the tests quote of a handout.
std::vector<std::string> quotes_of(const std::string& label)
{
    std::vector<std::string> quotes;
    const auto folder = assignments().parent_path() / "tests" / "handouts";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (!entry.path().filename().string().starts_with("numbers_")) continue;
        const std::string text = texts_of(content(entry.path()));
        const std::regex call("check_shown\\( ?\"" + label +
                              R"re(", (R"\((.*?)\)"|"((?:[^"\\]|\\.)*)"))re");
        for (std::sregex_iterator i(text.begin(), text.end(), call), end; i != end; ++i)
            quotes.push_back((*i)[2].matched ? (*i)[2] : (*i)[3]);
    }
    return quotes;
}

} // namespace

TEST_CASE("checkpoints: each formula has one whose numbers a test computes", "[checkpoints]")
{
    for (const Handout& handout : all_handouts()) {
        const std::vector<std::string> quotes = quotes_of(handout.label);
        for (const rigor::Formula& formula : rigor::formulas) {
            const std::string tag(formula.tag);
            if (tag.substr(0, tag.find('.')) != handout.label) continue;
            if (formula.topic == "validation") continue; // a test to write, which has no number
            const std::string checkpoint = checkpoint_of(handout.text, tag);
            INFO(tag << " has the checkpoint: " << checkpoint);
            CHECK(checkpoint.find_first_of("0123456789") != std::string::npos);
            CHECK(std::any_of(quotes.begin(), quotes.end(), [&](const std::string& quote) {
                return checkpoint.find(quote) != std::string::npos;
            }));
        }
    }
}
