// SPDX-License-Identifier: MIT
// The stress suite: `rigor test --stress`.
#include "stress/stress.hpp"
#include "support/bench/bench.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <stdexcept>

using namespace rigor;
using namespace rigor::stress;

namespace {

using Json = nlohmann::ordered_json;

struct Options {
    bool quick = false, json = false;
    std::string out, only;
};

Options options_of(int argc, char** argv)
{
    Options options;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const bool has_value = i + 1 < argc;
        if (argument == "--quick")
            options.quick = true;
        else if (argument == "--json")
            options.json = true;
        else if (argument == "--out" && has_value)
            options.out = argv[++i];
        else if (argument == "--only" && has_value)
            options.only = argv[++i];
        else
            throw std::invalid_argument(
                "expected --quick, --json, --out FILE or --only WORDS, found '" + argument + "'");
    }
    return options;
}

Suite chosen_cases(const Options& options)
{
    Suite suite;
    for (void (*add)(Suite&) : {add_spinning, add_resting, add_seesaw, add_overlap, add_fast,
                                add_touching, add_material, add_scale, add_weightless})
        add(suite);
    std::erase_if(suite, [&](const Case& c) {
        return (options.quick && !c.is_quick) ||
               (c.line + ": " + c.name).find(options.only) == std::string::npos;
    });
    if (suite.empty())
        throw std::invalid_argument("--only: expected words of a case's name, found '" +
                                    options.only + "'");
    return suite;
}

double steps_per_second(const Record& record)
{
    return record.seconds > 0 ? static_cast<double>(record.steps) / record.seconds : 0;
}

// Prints a cell that is at least `width` characters wide on a terminal.
void print_cell(const std::string& text, int width)
{
    const auto shown =
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
    std::printf("%s%*s", text.c_str(), std::max(0, width - static_cast<int>(shown)), "");
}

void print(const Case& test, const Record& r)
{
    std::printf("  ");
    print_cell(test.name, 54);
    std::printf("%-12.2g%-12.2g%-12.2g%-5d%-9lld%-10.3g%s\n", r.penetration, r.energy_gain, r.drift,
                r.not_finite, static_cast<long long>(r.steps), steps_per_second(r),
                r.met() ? "met" : "MISSED");
    if (r.not_finite > 0) std::printf("      MISSED  a state was not a number\n");
    if (r.checks.empty()) std::printf("      MISSED  nothing was checked\n");
    for (const Check& c : r.checks)
        if (!c.met())
            std::printf("      MISSED  %s: %.4g (at most %.4g, class %c)\n", c.what.c_str(),
                        c.figure, c.limit, c.tolerance_class);
    std::fflush(stdout);
}

Json json_of(const Case& test, const Record& r)
{
    Json checks = Json::array();
    for (const Check& c : r.checks)
        checks.push_back({{"what", c.what},
                          {"figure", c.figure},
                          {"limit", c.limit},
                          {"class", std::string(1, c.tolerance_class)},
                          {"met", c.met()}});
    return {{"line", test.line},
            {"case", test.name},
            {"penetration", r.penetration},
            {"energy_gain", r.energy_gain},
            {"drift", r.drift},
            {"not_finite", r.not_finite},
            {"steps", r.steps},
            {"steps_per_second", steps_per_second(r)},
            {"checks", std::move(checks)},
            {"met", r.met()}};
}

// Runs a case. A case that throws has not met its limits.
Record record_of(const Case& test)
{
    Record record;
    try {
        test.run(record);
    } catch (const std::exception& error) {
        record.limit(error.what(), 1, 0, 'I');
    }
    return record;
}

int run(const Options& options)
{
    const Suite suite = chosen_cases(options);
    std::ofstream file;
    if (!options.out.empty()) {
        file.open(options.out);
        if (!file) throw std::invalid_argument("cannot write " + options.out);
    }
    Json result = {{"stress", options.quick ? "quick" : "all"}, {"machine", machine_name()}};
    result["cases"] = Json::array();
    int missed = 0;
    std::string line;
    for (const Case& test : suite) {
        if (!options.json && line != test.line) {
            std::printf("\n");
            print_cell(test.line, 56);
            std::printf("%-12s%-12s%-12s%-5s%-9s%-10s\n", "depth [m]", "energy gain", "drift",
                        "NaN", "steps", "steps/s");
        }
        line = test.line;
        const Record record = record_of(test);
        missed += !record.met();
        if (!options.json) print(test, record);
        result["cases"].push_back(json_of(test, record));
    }
    result["missed"] = missed;
    if (options.json) std::printf("%s\n", result.dump(2).c_str());
    if (!options.json) std::printf("\n%zu cases, %d missed a limit\n", suite.size(), missed);
    if (file.is_open()) file << result.dump(2) << "\n";
    return missed == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(options_of(argc, argv));
    } catch (const std::invalid_argument& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
