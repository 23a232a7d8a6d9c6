// SPDX-License-Identifier: MIT
// Each picture that a handout shows is there, each figure is shown, and each picture of a wrong run
// can be drawn again.
#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <regex>
#include <set>
#include <sstream>

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

fs::path source(const std::string& path)
{
    return fs::path(RIGOR_SOURCE_DIR) / path;
}

// A row of the table in wrong_pictures.sh.
struct WrongRun {
    std::string handout, picture, mistake, scene, end, size, position, target, field_of_view, drawn;
};

std::vector<WrongRun> wrong_runs()
{
    std::vector<WrongRun> runs;
    std::istringstream lines(content(source("tests/handouts/wrong_pictures.sh")));
    for (std::string line; std::getline(lines, line);) {
        static const std::regex row(R"(a\d-[a-z]+ .+)");
        if (!std::regex_match(line, row)) continue;
        WrongRun run;
        std::istringstream(line) >> run.handout >> run.picture >> run.mistake >> run.scene >>
            run.end >> run.size >> run.position >> run.target >> run.field_of_view >> run.drawn;
        runs.push_back(run);
    }
    return runs;
}

// Where a text of a figure lies, if its letters are as wide as those of a usual font.
struct Label {
    std::string text;
    double left, right, top, bottom; // [px]
};

std::vector<Label> labels_in(const std::string& svg)
{
    constexpr double letter = 7.5, above = 11, below = 4; // sizes in a font of 15 px
    std::vector<Label> labels;
    static const std::regex label(
        R"re(<text class="[^"]*" x="([^"]+)" y="([^"]+)" text-anchor="(\w+)">(.*?)</text>)re");
    for (std::sregex_iterator i(svg.begin(), svg.end(), label), end; i != end; ++i) {
        static const std::regex one_letter("&\\w+;|[\\x00-\\x7f]|[\\xc0-\\xff][\\x80-\\xbf]+");
        static const std::regex tag("<[^>]*>"); // around a subscript
        const std::string text = std::regex_replace((*i)[4].str(), tag, ""), anchor = (*i)[3];
        const double x = std::stod((*i)[1]), y = std::stod((*i)[2]);
        const double width =
            letter * static_cast<double>(
                         std::distance(std::sregex_iterator(text.begin(), text.end(), one_letter),
                                       std::sregex_iterator()));
        const double left = anchor == "start" ? x : anchor == "end" ? x - width : x - width / 2;
        labels.push_back({text, left, left + width, y - above, y + below});
    }
    return labels;
}

bool overlap(const Label& a, const Label& b)
{
    return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

} // namespace

TEST_CASE("pictures: the labels of a figure lie inside it and apart", "[pictures]")
{
    int figures = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(assignments())) {
        if (entry.path().parent_path().filename() != "figures") continue;
        ++figures;
        const std::string svg = content(entry.path());
        std::smatch size;
        REQUIRE(std::regex_search(svg, size, std::regex(R"re(viewBox="0 0 ([\d.]+) ([\d.]+)")re")));
        const std::vector<Label> labels = labels_in(svg);
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const Label& label = labels[i];
            CAPTURE(entry.path().filename(), label.text, label.left, label.right);
            CHECK(label.left >= 0);
            CHECK(label.right <= std::stod(size[1]));
            CHECK(label.top >= 0);
            CHECK(label.bottom <= std::stod(size[2]));
            for (std::size_t k = 0; k < i; ++k) {
                CAPTURE(labels[k].text);
                CHECK_FALSE(overlap(label, labels[k]));
            }
        }
    }
    REQUIRE(figures >= 20);
}

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

TEST_CASE("pictures: each of a wrong run names the mistake and the scene that make it",
          "[pictures]")
{
    std::set<std::string> drawn, shown;
    for (const WrongRun& run : wrong_runs()) {
        CAPTURE(run.handout, run.picture);
        CHECK((run.mistake == "-" || fs::exists(source("tests/mistakes/" + run.mistake + ".cpp"))));
        CHECK(fs::exists(assignments() / run.handout / "scenes" / (run.scene + ".json")));
        CHECK(std::regex_match(run.end, std::regex(R"(\d+(\.\d+)?)")));
        CHECK(std::regex_match(run.size, std::regex(R"(\d+x\d+)")));
        static const std::regex number(R"(-?\d+(\.\d+)?)"), place(R"((-?\d+(\.\d+)?,?){3})");
        CHECK(std::regex_match(run.position, place));
        CHECK(std::regex_match(run.target, place));
        CHECK(std::regex_match(run.field_of_view, number));
        // the time is printed where something is drawn beside the bodies
        CHECK(std::regex_search(run.drawn, std::regex("\"(axes|contacts|labels)\":true")));
        drawn.insert(run.handout + "/" + run.picture);
    }
    for (const Handout& handout : all_handouts())
        for (const std::string& picture : pictures_in(handout.text))
            if (picture.starts_with("wrong")) shown.insert(handout.name + "/" + picture);
    CHECK(!drawn.empty());
    CHECK(drawn == shown);
}

TEST_CASE("pictures: each handout shows a wrong run where it says what to look for", "[pictures]")
{
    for (const Handout& handout : all_handouts()) {
        if (!has_scenes(handout)) continue;
        CAPTURE(handout.label);
        const std::size_t section = handout.text.find("\n## If you see this\n");
        REQUIRE(section != std::string::npos);
        const std::size_t end = handout.text.find("\n## ", section + 1);
        int wrong = 0;
        for (const std::string& picture : pictures_in(handout.text.substr(section, end - section)))
            wrong += fs::path(picture).filename().string().starts_with("wrong") ? 1 : 0;
        CHECK(wrong >= 1);
    }
}
