// SPDX-License-Identifier: MIT
// The form in which the system takes the arguments and the environment of a program.
#pragma once

#include <string>
#include <vector>

namespace rigor {

/// Pointers to the texts, with a null pointer at the end. They are valid as long as the texts are.
inline std::vector<char*> argument_pointers(const std::vector<std::string>& texts)
{
    std::vector<char*> result;
    result.reserve(texts.size() + 1);
    for (const std::string& text : texts)
        result.push_back(const_cast<char*>(text.c_str()));
    result.push_back(nullptr);
    return result;
}

} // namespace rigor
