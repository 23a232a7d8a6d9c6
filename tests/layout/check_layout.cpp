// SPDX-License-Identifier: MIT
// Prints each place that breaks a rule of the tree. Argument: the top of the tree.
#include "layout/layout.hpp"

#include <cstdio>

int main(int count, char** values)
{
    using namespace rigor::layout;
    if (count != 2) {
        std::fprintf(stderr, "usage: check_layout TREE\n");
        return 2;
    }
    const Violations violations = check_tree(values[1]);
    for (const Violation& violation : violations)
        std::printf("%s: %s\n", violation.place.c_str(), violation.rule.c_str());
    return violations.empty() ? 0 : 1;
}
