// SPDX-License-Identifier: MIT
#include "cli/commands/figures.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "errors/input_error.hpp"
#include "grading/places.hpp"

#include <filesystem>

namespace rigor {

namespace {

int draw_figures(const std::string& out)
{
    if (!places().has_reference())
        throw InputError("figures are drawn by the reference's formulas, and this tree has no "
                         "reference; see assignments/*/figures/ for the figures");
    require_folder(out, "the figures");
    prepare_targets({"rigor_figures"});
    return run_program({places().program("rigor_figures").string(), "--out", out}) == 0
               ? exit_done
               : exit_wrong;
}

} // namespace

Action declare_figures(Options& options)
{
    const auto out = std::make_shared<std::string>();
    options.option("--out", "DIR", *out, "Folder for the figures, DIR/<handout>/figures/*.svg");
    options.examples({"figures --out assignments   makes those of the handouts anew"});
    return [out] { return draw_figures(*out); };
}

} // namespace rigor
