// SPDX-License-Identifier: MIT
#include "grading/topics.hpp"

#include "formulas/table.hpp"

namespace rigor {

std::vector<std::string> topics()
{
    std::vector<std::string> result;
    for (const Formula& row : formulas)
        if (result.empty() || result.back() != row.topic) result.emplace_back(row.topic);
    return result;
}

} // namespace rigor
