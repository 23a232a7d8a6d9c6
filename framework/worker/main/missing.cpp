// SPDX-License-Identifier: MIT
// A weak definition of each formula. The linker takes it only if the implementation does not define
// the formula, and a call then reports that the formula is missing. So a function that is missing
// or renamed affects only its own calls, and the rest of the implementation can be linked and
// judged.
#include "worker/main/server.hpp"
#include "worker/protocol/define_formulas.hpp"

namespace rigor {

namespace {

template <FormulaIndex formula, class Formula, class... Argument>
typename Formula::Result answer(const Argument&...)
{
    throw MissingFormula{static_cast<unsigned>(formula)};
}

} // namespace

#define RIGOR_DECLARE_WEAK(tag, topic, f, ...) [[gnu::weak]] decltype(f) f;
RIGOR_FORMULAS(RIGOR_DECLARE_WEAK)
RIGOR_FORMULAS(RIGOR_DEFINE_FORMULA)

} // namespace rigor
