// SPDX-License-Identifier: MIT
// Adds the tests of a universal law, one for each formula of the contract that it holds for.
#pragma once

#include "formulas/quantities.hpp"
#include "support/catch.hpp"

#include <string>
#include <string_view>

namespace rigor::testing {

constexpr std::string_view name_of(FormulaIndex f)
{
    return formulas[static_cast<unsigned>(f)].name;
}

/// Adds the tests of the law that the type `Law` describes. This type has `words`, which follow the
/// name of the formula in the name of the test, a constexpr `holds_for(f)`, and
/// `check<f, formula>()`.
template <class Law> bool add_law()
{
    const auto add = [](void (*check)(), const std::string& name, const char* tags) {
        Catch::AutoReg(Catch::makeTestInvoker(check), CATCH_INTERNAL_LINEINFO, Catch::StringRef(),
                       Catch::NameAndTags{name, tags});
    };
#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    if constexpr (Law::holds_for(FormulaIndex::function))                                          \
        add(&Law::template check<FormulaIndex::function, rigor::function>,                         \
            std::string(#topic ": " #function " ") + Law::words,                                   \
            "[" #tag "][" #topic "][universal]");
    RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW
    return true;
}

} // namespace rigor::testing
