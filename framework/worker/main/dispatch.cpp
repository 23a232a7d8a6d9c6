// SPDX-License-Identifier: MIT
#include "worker/main/dispatch.hpp"

#include "formulas/table.hpp"
#include "worker/engine/scenes.hpp"

#include <tuple>

namespace rigor {

namespace {

// What a test says of its formula, or the question that it is left with.
template <class Test> Judgement judgement(const Test& test)
{
    try {
        return test();
    } catch (const UnknownCall& call) {
        return {0, call.calls_before, call.arguments};
    }
}

template <class Result, class... Argument>
wire::Bytes answer(Result (*function)(Argument...), std::span<const std::byte> encoded)
{
    wire::Reader reader(encoded);
    std::tuple<std::remove_cvref_t<Argument>...> arguments;
    std::apply([&](auto&... argument) { (wire::decode(reader, argument), ...); }, arguments);
    reader.end();
    wire::Bytes result;
    const auto call = [&] { return std::apply(function, arguments); };
    if constexpr (std::is_same_v<Result, Judgement>)
        wire::encode(result, judgement(call));
    else
        wire::encode(result, call());
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
