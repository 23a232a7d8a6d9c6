// SPDX-License-Identifier: MIT
#include "support/bench/reasons.hpp"

#include <fstream>
#include <stdexcept>

namespace rigor::testing {

std::map<std::string, std::string> reasons_in(const std::filesystem::path& file)
{
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file.string() + ": cannot be read");
    std::map<std::string, std::string> result;
    std::string reason;
    bool is_in_reason = false;
    for (std::string line; std::getline(in, line);) {
        if (line.empty()) continue;
        if (line.front() == '#') {
            reason = is_in_reason ? reason + line.substr(1) : line.substr(1);
            is_in_reason = true;
            continue;
        }
        is_in_reason = false;
        if (reason.empty())
            throw std::runtime_error(file.string() + ": expected a reason before: " + line);
        if (!result.emplace(line, reason).second)
            throw std::runtime_error(file.string() + ": twice: " + line);
    }
    return result;
}

} // namespace rigor::testing
