// SPDX-License-Identifier: MIT
#include "diagnosis/matches.hpp"

#include <algorithm>

namespace rigor::diagnosis {

const std::optional<Value>& ChangedAnswers::right_for(std::size_t transform, const Case& c)
{
    const auto [place, is_new] = known_.try_emplace({transform, &c});
    if (is_new) {
        Value arguments = c.arguments;
        if (transforms_[transform].apply(arguments)) place->second = evidence_.reference(arguments);
    }
    return place->second;
}

bool ChangedAnswers::is_right(const std::optional<Value>& right, const Case& c,
                              const std::vector<int>& roles)
{
    return right && right->sizes == c.answer.sizes &&
           std::all_of(roles.begin(), roles.end(), [&](int role) {
               return compare(evidence_.answer, role, *right, c.answer, c.noise) !=
                      Agreement::different;
           });
}

bool ChangedAnswers::explains(std::size_t transform, const Cases& cases,
                              const std::vector<int>& roles)
{
    return std::all_of(cases.begin(), cases.end(), [&](const Case* c) {
        return is_right(right_for(transform, *c), *c, roles);
    });
}

bool ChangedAnswers::explains(std::size_t first, std::size_t second, const Cases& cases,
                              const std::vector<int>& roles)
{
    return std::all_of(cases.begin(), cases.end(), [&](const Case* c) {
        Value arguments = c->arguments;
        return transforms_[first].apply(arguments) && transforms_[second].apply(arguments) &&
               is_right(evidence_.reference(arguments), *c, roles);
    });
}

std::string ChangedAnswers::related(std::size_t transform, const Cases& cases,
                                    const std::vector<int>& roles)
{
    constexpr std::size_t first_look = 4; // most changes are refused by a few cases
    for (const std::size_t n : {std::min(first_look, cases.size()), cases.size()}) {
        std::vector<Case> changed;
        for (std::size_t i = 0; i < n; ++i) {
            const auto& right = right_for(transform, *cases[i]);
            if (!right || right->sizes != cases[i]->answer.sizes) return "";
            Case c = *cases[i];
            c.right = *right;
            changed.push_back(std::move(c));
        }
        Cases pointers;
        for (const Case& c : changed)
            pointers.push_back(&c);
        std::string words;
        for (const int role : roles) {
            const Pairs pairs = pairs_of(evidence_.answer, role, pointers);
            const bool is_right = std::all_of(changed.begin(), changed.end(), [&](const Case& c) {
                return compare(evidence_.answer, role, c.right, c.answer, c.noise) ==
                       Agreement::same;
            });
            if (is_right) continue;
            const std::string relation = plain_relation(pairs);
            // An answer that does not depend on the right one says nothing about the change.
            if (!relation.starts_with("the right one") &&
                relation.find("times") == std::string::npos)
                return "";
            if (!words.empty() && words != relation) return "";
            words = relation;
        }
        if (words.empty() || n == cases.size()) return words;
    }
    return "";
}

} // namespace rigor::diagnosis
