// SPDX-License-Identifier: MIT
// What a header says of special input, the section of its task in the handout says too.
#include "formulas/table.hpp"
#include "handouts/handouts.hpp"
#include "handouts/numbers.hpp"
#include "support/catch.hpp"

#include <regex>
#include <set>

using namespace rigor::handouts;

namespace {

// Two regular expressions: if the first matches a header, the handout has to match the second.
struct SpecialCase {
    const char *header, *handout;
};

constexpr SpecialCase special_cases[] = {
    {"[Ss]tatic bod", "static bod"},
    {"[Bb]oth bodies static|two static bodies", "two static bodies"},
    {"No particle", "Without particles"},
    {"No force", "Without forces"},
    {"[Nn]o mass|zero mass", "[Ww]ithout mass|no mass"},
    {"No sample", "Without samples"},
    {"No vertex", "Without vertices"},
    {"No volume", "Without volume"},
    {"≥ 0 \\[m\\]", "may be 0"},
    {"Open mesh", "open mesh"},
    {"inside out", "inside out"},
    {"[Zz]ero quaternion", "zero quaternion"},
    {"column is zero", "column is zero"},
    {"gimbal lock", "[Gg]imbal lock"},
    {"infinity", "infinite"},
    {"negative Δt", R"(negative \$\\Delta t\$)"},
    {"Outside the grid", "Outside the grid"},
    {"Zero gradient", "gradient is zero"},
    {"No tangential velocity", "Without tangential velocity"},
    {"jams", "jammed"},
    {"separate", "separate"},
    {"[Ee]qual (depths|faces)", "equal"},
    {"moments are repeated", "moments are equal"},
    {"all moments are zero", "all moments are 0"},
    {"No contact whose bodies approach", "there is none"},
    {"k < 0", "below 0"},
    {"n < 1", "N < 1"},
    {"sweeps < 1", "Without a sweep"},
    {"rests on nothing", "rests on nothing"},
    {"that of the body itself", "that of the body itself"},
    {"G = 0", "G = 0"},
    {"rounding errors and may be negative", "rounding makes the difference negative"},
    {"all averaged volumes are 0", "all the volumes in the average are 0"},
    {"several eigenvalues are equal", "several eigenvalues are equal"},
    {"Compression alone", "pure pressure"},
    {"without area", "without area"},
    {"face on the surface", "face on the surface"},
    {"possibly repeated", "more than once"},
    {"unchanged if no vertex", "returned as it is"},
    {"one on the plane", "lies on the plane"},
    {"any number of cracks for each", "Several cracks in one tetrahedron"},
};

// The comment of a formula in its header, without the marks of a comment, in one line.
std::string comment_of(const rigor::Formula& formula)
{
    const std::string topic(formula.topic);
    const auto headers = assignments().parent_path() / "framework" / "formulas";
    const std::string text = content(headers / (topic + ".hpp"));
    const std::size_t start = text.find("/// " + std::string(formula.tag) + " ");
    if (start == std::string::npos) return {};
    std::size_t end = start; // where the comment ends
    while (text.compare(end, 3, "///") == 0)
        end = text.find('\n', end) + 1;
    const std::string block = text.substr(start, end - start);
    return in_one_line(std::regex_replace(block, std::regex("\n?///"), " "));
}

// The section of a task, in one line.
std::string section_of(const Handout& handout, const std::string& tag)
{
    const std::size_t start = handout.text.find("\n### " + tag + " ");
    if (start == std::string::npos) return {};
    return in_one_line(handout.text.substr(start, handout.text.find("\n##", start + 1) - start));
}

} // namespace

TEST_CASE("special cases: what the header says of them stands in the task", "[special]")
{
    std::set<std::string> met;
    for (const Handout& handout : all_handouts())
        for (const rigor::Formula& formula : rigor::formulas) {
            const std::string tag(formula.tag);
            if (tag.substr(0, tag.find('.')) != handout.label) continue;
            const std::string comment = comment_of(formula), section = section_of(handout, tag);
            INFO(tag << " in the header: " << comment << "\nin the handout: " << section);
            CHECK((!comment.empty() && !section.empty()));
            for (const SpecialCase& special : special_cases) {
                if (!std::regex_search(comment, std::regex(special.header))) continue;
                met.insert(special.header);
                CAPTURE(special.handout);
                CHECK(std::regex_search(section, std::regex(special.handout)));
            }
        }
    for (const SpecialCase& special : special_cases) {
        CAPTURE(special.header);
        CHECK(met.count(special.header) == 1); // words that no header has check nothing
    }
}
