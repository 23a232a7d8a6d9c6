// SPDX-License-Identifier: MIT
#include "worker/main/dispatch.hpp"

#include "formulas/table.hpp"
#include "worker/engine/scenes.hpp"

#include <limits>
#include <tuple>
#include <vector>

namespace rigor {

namespace {

// Runs a test that a student wrote. Returns its judgement about the formula under test. If the test
// stopped at a call whose result is not known yet, returns this call.
template <class Test> Judgement judgement(const Test& test)
{
    try {
        return test();
    } catch (const UnknownCall& call) {
        return {0, call.calls_before, call.arguments};
    }
}

// Fills the memory behind the list of a level set with NaN. So a formula that reads a node beyond
// the last one, even with the weight 0, gets no finite result. Other values might hide the mistake.
template <class T> void guard_end(T& argument)
{
    if constexpr (std::is_same_v<T, LevelSet>) {
        std::vector<double>& list = argument.distances;
        const std::size_t size = list.size();
        list.resize(2 * size + 1, std::numeric_limits<double>::quiet_NaN());
        list.resize(size); // the memory behind the list keeps the NaN
    }
}

template <class Result, class... Argument>
void answer(Result (*function)(Argument...), std::span<const std::byte> encoded,
            wire::Bytes& result)
{
    wire::Reader reader(encoded);
    std::tuple<std::remove_cvref_t<Argument>...> arguments;
    std::apply([&](auto&... argument) { (wire::decode(reader, argument), ...); }, arguments);
    reader.end();
    std::apply([](auto&... argument) { (guard_end(argument), ...); }, arguments);
    const auto call = [&] { return std::apply(function, arguments); };
    if constexpr (std::is_same_v<Result, Judgement>)
        wire::encode_all(result, judgement(call));
    else
        wire::encode_all(result, call());
}

using Call = void (*)(std::span<const std::byte>, wire::Bytes&);

#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    [](std::span<const std::byte> arguments, wire::Bytes& result) {                                \
        answer(&rigor::function, arguments, result);                                               \
    },
constexpr Call calls[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

} // namespace

#define RIGOR_ROW(tag, topic, function, ...) reinterpret_cast<AnyFormula>(&rigor::function),
const AnyFormula rigor_formulas[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

void call_formula(unsigned index, std::span<const std::byte> arguments, wire::Bytes& result)
{
    if (index >= formula_count) throw wire::Malformed("there is no such formula");
    calls[index](arguments, result);
}

} // namespace rigor
