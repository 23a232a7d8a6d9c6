// SPDX-License-Identifier: MIT
// Compiles all mutants of a source into one object. Mutants that do not compile are left out: the
// compiler is asked again until it finds no error.
//
//     make_mutants SOURCE OUTPUT COMPILER OPTION...
//
// writes OUTPUT.cpp, OUTPUT.o, and OUTPUT.mutants with the number, the function and the name of
// each mutant, separated by tabs. The stem of OUTPUT names the mutants.
#include "grading/process.hpp"
#include "mutants/generate.hpp"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <stdexcept>

namespace {

using namespace rigor;
using namespace rigor::mutants;
namespace fs = std::filesystem;

struct Request {
    fs::path source, output;
    std::vector<std::string> compiler; // with its options

    fs::path with(const std::string& extension) const { return output.string() + extension; }
};

void write(const fs::path& file, const std::string& text)
{
    std::ofstream out(file);
    out << text;
    if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

// The lines of the generated source that the compiler complains about, also from inside of a
// template of a library.
std::set<std::size_t> wrong_lines(const std::vector<std::string>& output, const std::string& file)
{
    std::set<std::size_t> lines;
    for (const std::string& line : output) {
        const bool is_cause = line.find("error:") != std::string::npos ||
                              line.find("required from") != std::string::npos ||
                              line.find("requested here") != std::string::npos;
        const std::size_t at = line.find(file + ":");
        if (is_cause && at != std::string::npos)
            lines.insert(std::stoul(line.substr(at + file.size() + 1)));
    }
    return lines;
}

// Compiles once. @return whether there were no errors; otherwise the wrong mutants are added to
// `without`
bool compile(const Request& request, const Generated& generated,
             const std::vector<std::string>& options, std::set<int>& without)
{
    const std::string file = request.with(".cpp").string();
    Command command;
    command.arguments = request.compiler;
    command.arguments.insert(command.arguments.end(), options.begin(), options.end());
    command.arguments.push_back(file);
    std::vector<std::string> output;
    const Ended ended = run(command, [&](std::string_view line) { output.emplace_back(line); });
    if (ended.ok()) return true;

    const std::size_t before = without.size();
    for (const std::size_t line : wrong_lines(output, file))
        for (const Mutant& mutant : generated.mutants)
            if (line >= mutant.first && line <= mutant.last) without.insert(mutant.number);
    if (without.size() == before) {
        for (const std::string& line : output)
            std::fprintf(stderr, "%s\n", line.c_str());
        throw std::runtime_error(file + ": an error that is not in a mutant");
    }
    return false;
}

// Finds the mutants that do not compile. They are looked for in groups, because the compiler
// reports an error inside of a template only at its first use: a group with errors is compiled
// again without the mutants that had them, and the others are not.
std::set<int> not_compiling(const Request& request, const Source& source)
{
    constexpr std::size_t group = 400; // smaller ones would read the headers more often
    const std::string stem = request.output.filename();
    const std::vector<Mutant> all = generate(source, stem, {}).mutants;
    std::set<int> wrong;
    for (std::size_t first = 0; first < all.size(); first += group) {
        std::set<int> without = wrong;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (i < first || i >= first + group) without.insert(all[i].number);
        const std::set<int> others = without;
        Generated generated;
        do {
            generated = generate(source, stem, without);
            write(request.with(".cpp"), generated.text);
        } while (!compile(request, generated, {"-fsyntax-only"}, without));
        for (const int number : without)
            if (!others.contains(number)) wrong.insert(number);
    }
    return wrong;
}

void make(const Request& request)
{
    Source source;
    read_source(source, request.source);
    fs::create_directories(request.output.parent_path());
    std::set<int> without = not_compiling(request, source);
    Generated generated;
    do {
        generated = generate(source, request.output.filename(), without);
        write(request.with(".cpp"), generated.text);
    } while (!compile(request, generated, {"-c", "-o", request.with(".o").string()}, without));
    std::string list;
    for (const Mutant& mutant : generated.mutants)
        list += fmt::format("{}\t{}\t{}\n", mutant.number, mutant.function, mutant.name);
    write(request.with(".mutants"), list);
    fmt::print("{}: {} mutants, {} more do not compile\n", request.output.filename().string(),
               generated.mutants.size(), without.size());
}

} // namespace

int main(int count, char** arguments)
{
    try {
        if (count < 4) throw std::invalid_argument("expected SOURCE OUTPUT COMPILER OPTION...");
        make({arguments[1], arguments[2], {arguments + 3, arguments + count}});
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_mutants: %s\n", error.what());
        return 1;
    }
}
