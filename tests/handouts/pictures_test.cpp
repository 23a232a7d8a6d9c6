// SPDX-License-Identifier: MIT
// Each picture that a handout shows is there, and each figure is shown.
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <regex>
#include <set>

using namespace rigor::handouts;

namespace fs = std::filesystem;

namespace {

std::set<std::string> pictures_in(const std::string& text)
{
    std::set<std::string> pictures;
    static const std::regex picture(R"(!\[[^\]]+\]\(([^)]+)\))");
    for (std::sregex_iterator i(text.begin(), text.end(), picture), end; i != end; ++i)
        pictures.insert((*i)[1]);
    return pictures;
}

} // namespace

TEST_CASE("pictures: each one that a handout shows exists", "[pictures]")
{
    for (const Handout& handout : all_handouts())
        for (const std::string& picture : pictures_in(handout.text)) {
            CAPTURE(handout.name, picture);
            CHECK(fs::exists(assignments() / handout.name / picture));
        }
}

TEST_CASE("pictures: each figure is shown, and can be read on dark ground", "[pictures]")
{
    int figures = 0;
    for (const Handout& handout : all_handouts()) {
        const fs::path folder = assignments() / handout.name / "figures";
        if (!fs::exists(folder)) continue;
        const std::set<std::string> shown = pictures_in(handout.text);
        for (const auto& entry : fs::directory_iterator(folder)) {
            CAPTURE(entry.path());
            CHECK(shown.count("figures/" + entry.path().filename().string()) == 1);
            const std::string svg = content(entry.path());
            CHECK(svg.find("prefers-color-scheme: dark") != std::string::npos);
            CHECK(svg.find("<title>") != std::string::npos);
            ++figures;
        }
    }
    CHECK(figures >= 20);
}
