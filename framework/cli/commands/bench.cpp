// SPDX-License-Identifier: MIT
#include "cli/commands/bench.hpp"

#include "cli/options.hpp"
#include "cli/prepare.hpp"
#include "errors/input_error.hpp"
#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "grading/build/ninja.hpp"
#include "grading/places.hpp"
#include "grading/process.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fmt/format.h>

namespace rigor {

namespace {

struct BenchOptions {
    std::vector<std::string> names;
    std::string out;
    bool json = false, list = false;
};

const std::string& known_name(const std::string& name, const std::vector<std::string>& known)
{
    const auto found = std::find(known.begin(), known.end(), name);
    if (found != known.end()) return *found;
    const std::string all = fmt::format("there are {}", fmt::join(known, ", "));
    throw InputError("no benchmark " + in_quotes(name) + suggestion(name, known, all));
}

// The benchmarks that write plots.
constexpr std::array<std::string_view, 3> with_plots = {"accuracy", "deformable", "plasticity"};

bool draws(const std::string& name)
{
    return std::find(with_plots.begin(), with_plots.end(), name) != with_plots.end();
}

// The folder for the plots of a benchmark. If several benchmarks run, each of them gets its own
// folder inside --out.
std::string plots_of(const std::string& name, const BenchOptions& options)
{
    if (options.out.empty()) return (places().build / "bench" / name).string();
    if (options.names.size() == 1) return options.out;
    return (std::filesystem::path(options.out) / name).string();
}

void check_out(const std::string& out, const std::vector<std::string>& names)
{
    if (out.empty()) return;
    if (std::none_of(names.begin(), names.end(), draws))
        throw InputError(fmt::format("--out: expected a benchmark that draws ({}), found {}",
                                     fmt::join(with_plots, ", "), fmt::join(names, ", ")));
    std::error_code error;
    std::filesystem::create_directories(out, error);
    if (!std::filesystem::is_directory(out))
        throw InputError("--out: expected a folder for plots, found " + out);
}

void run_benchmark(const std::string& name, const BenchOptions& options)
{
    std::vector<std::string> arguments = {places().program(("bench_" + name).c_str()).string()};
    if (draws(name)) arguments.insert(arguments.end(), {"--out", plots_of(name, options)});
    if (options.json) arguments.emplace_back("--json");
    const int status = run_program(arguments);
    if (status != 0) throw std::runtime_error(program_failed("bench_" + name, status));
}

int bench(const BenchOptions& options)
{
    const std::vector<std::string> known = ninja_programs("bench_");
    if (known.empty())
        throw InputError(fmt::format(
            "the build {} has no benchmarks: they need the whole tree, not the students', "
            "and a build without sanitizers, such as RIGOR_PRESET=release",
            places().build.filename().string()));
    if (options.list) {
        fmt::print("{}\n", fmt::join(known, "\n"));
        return exit_done;
    }
    std::vector<std::string> names, targets;
    for (const std::string& name : options.names.empty() ? known : options.names) {
        names.push_back(known_name(name, known));
        targets.push_back("bench_" + name);
    }
    check_out(options.out, names);
    prepare_targets(targets);
    if (options.json && names.size() > 1) fmt::print("[\n");
    for (const std::string& name : names) {
        if (&name != names.data()) fmt::print("{}\n", options.json ? "," : "");
        run_benchmark(name, options);
    }
    if (options.json && names.size() > 1) fmt::print("]\n");
    return exit_done;
}

} // namespace

Action declare_bench(Options& options)
{
    const auto chosen = std::make_shared<BenchOptions>();
    options.words("NAME", chosen->names, "Benchmarks; without one, all");
    options.flag("--list", chosen->list, "Name them");
    options.flag("--json", chosen->json, "Print JSON: one object, or a list of them");
    options.option("--out", "DIR", chosen->out,
                   "Folder for plots; without it build/<preset>/bench/NAME");
    options.examples({"bench --list",
                      "bench spin            run time against error of the integrators",
                      "bench accuracy --out plots", "bench worker --json"});
    return [chosen] { return bench(*chosen); };
}

} // namespace rigor
