// SPDX-License-Identifier: MIT
#include "benchmarks/validator/mutant_lists.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rigor::mutants {

std::vector<Mutant> mutants_of(const std::filesystem::path& folder, const std::string& stem)
{
    const std::filesystem::path file = folder / (stem + ".mutants");
    std::ifstream in(file);
    std::vector<Mutant> result;
    for (std::string line; std::getline(in, line);) {
        std::istringstream fields(line);
        Mutant mutant;
        std::string number;
        std::getline(fields, number, '\t');
        std::getline(fields, mutant.function, '\t');
        std::getline(fields, mutant.name);
        mutant.stem = stem;
        mutant.number = std::stoi(number);
        const auto formula =
            std::find_if(std::begin(formulas), std::end(formulas), [&](const Formula& f) {
                return f.topic == mutant.topic() && f.name == mutant.function;
            });
        if (formula != std::end(formulas)) mutant.formula = formula;
        result.push_back(mutant);
    }
    if (result.empty()) throw std::runtime_error(file.string() + ": expected mutants, found none");
    return result;
}

} // namespace rigor::mutants
