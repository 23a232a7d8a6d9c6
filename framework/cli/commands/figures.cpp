// SPDX-License-Identifier: MIT
#include "cli/commands/figures.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "errors/input_error.hpp"
#include "grading/places.hpp"
#include "grading/selection.hpp"

#include <filesystem>

namespace rigor {

namespace {

// The name of the handout that a word means, such as "a4-collision" for "A4"; empty if `word` is
// empty.
std::string handout_of(const std::string& word)
{
    if (word.empty()) return {};
    const auto selections = select_tasks(load_assignments(places().assignments()), {word});
    const Assignment& assignment = selections[0].assignment;
    if (!std::filesystem::exists(places().assignments() / assignment.name / "figures"))
        throw InputError("expected a handout with figures, found " + assignment.name);
    return assignment.name;
}

int draw_figures(const std::string& topic, const std::string& out)
{
    if (!places().has_reference())
        throw InputError("figures are drawn by the reference's formulas, and this tree has no "
                         "reference; see assignments/*/figures/ for the figures");
    const std::string handout = handout_of(topic);
    require_folder(out, "the figures");
    prepare_targets({"rigor_figures"});
    std::vector<std::string> arguments = {places().program("rigor_figures").string(), "--out", out};
    if (!handout.empty()) arguments.push_back(handout);
    return run_program(arguments); // if this is not 0, the program has printed why
}

} // namespace

Action declare_figures(Options& options)
{
    const auto topic = std::make_shared<std::string>(), out = std::make_shared<std::string>();
    options.word_or_none("TOPIC", *topic, "Only the figures of this assignment; default: all");
    options.option("--out", "DIR", *out, "Folder for the figures, DIR/<handout>/figures/*.svg");
    options.examples({"figures --out assignments   makes those of the handouts anew",
                      "figures A4 --out drawings    those of A4, in another folder"});
    return [topic, out] { return draw_figures(*topic, *out); };
}

} // namespace rigor
