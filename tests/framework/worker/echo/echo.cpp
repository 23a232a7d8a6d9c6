// SPDX-License-Identifier: MIT
#include "echo.hpp"

#include "worker/protocol/define_formulas.hpp"

namespace rigor {

namespace {

template <FormulaIndex formula, class Formula, class... Argument>
typename Formula::Result answer(const Argument&... arguments)
{
    wire::Bytes bytes;
    (wire::encode(bytes, arguments), ...);
    return echo_of<typename Formula::Result>(static_cast<unsigned>(formula), bytes);
}

} // namespace

RIGOR_FORMULAS(RIGOR_DEFINE_FORMULA)

} // namespace rigor
