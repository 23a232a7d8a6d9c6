// SPDX-License-Identifier: MIT
#include "worker/main/dispatch.hpp"

#include "formulas/table.hpp"
#include "worker/engine/scenes.hpp"

#include <tuple>

namespace rigor {

namespace {

template <class Result, class... Argument>
wire::Bytes answer(Result (*function)(Argument...), std::span<const std::byte> encoded)
{
    wire::Reader reader(encoded);
    std::tuple<std::remove_cvref_t<Argument>...> arguments;
    std::apply([&](auto&... argument) { (wire::decode(reader, argument), ...); }, arguments);
    reader.end();
    wire::Bytes result;
    wire::encode(result, std::apply(function, arguments));
    return result;
}

using Call = wire::Bytes (*)(std::span<const std::byte>);

#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    [](std::span<const std::byte> arguments) { return answer(&rigor::function, arguments); },
constexpr Call calls[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

} // namespace

#define RIGOR_ROW(tag, topic, function, ...) reinterpret_cast<AnyFormula>(&rigor::function),
const AnyFormula rigor_formulas[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

wire::Bytes call_formula(unsigned index, std::span<const std::byte> arguments)
{
    if (index >= formula_count) throw wire::Malformed("there is no such formula");
    return calls[index](arguments);
}

} // namespace rigor
