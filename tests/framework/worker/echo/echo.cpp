// SPDX-License-Identifier: MIT
#include "echo.hpp"

#include "worker/define_formulas.hpp"

namespace rigor {

namespace {

template <class Result, class... Argument>
Result answer(FormulaIndex formula, const Argument&... arguments)
{
    wire::Bytes bytes;
    (wire::encode(bytes, arguments), ...);
    return echo_of<Result>(static_cast<unsigned>(formula), bytes);
}

} // namespace

RIGOR_FORMULAS(RIGOR_DEFINE_FORMULA)

} // namespace rigor
