// SPDX-License-Identifier: MIT
// The only code of the diagnosis that is compiled for each formula.
#include "diagnosis/formula_types.hpp"

#include "graded/laws/change.hpp"
#include "graded/laws/inputs.hpp"
#include "worker/protocol/wire.hpp"

#include <memory>

namespace rigor::diagnosis {

namespace {

template <class Result> Value unique_in(std::span<const std::byte> bytes)
{
    const auto numbers = testing::comparable(wire::decode_all<Result>(bytes));
    Value value;
    value.numbers = numbers;
    value.sizes = {numbers.size()};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        value.leaves.push_back({0, i});
    return value;
}

// The names between commas in "a, b, c".
std::vector<std::string> separate(std::string_view names)
{
    std::vector<std::string> result;
    for (std::size_t at = 0; at <= names.size();) {
        const std::size_t end = std::min(names.find(", ", at), names.size());
        result.emplace_back(names.substr(at, end - at));
        at = end + 2;
    }
    return result;
}

template <class... Argument>
Encoding arguments_type(const FormulaQuantities& of, std::string_view names,
                        std::type_identity<std::tuple<Argument...>>)
{
    Encoding result;
    result.names = separate(names);
    std::size_t i = 0;
    (result.parts.push_back(encoding_of<Argument>(of.arguments[i++])), ...);
    return result;
}

template <FormulaIndex f, auto& formula> Bytes drawn(unsigned seed)
{
    Bytes bytes;
    std::apply([&](const auto&... argument) { (wire::encode(bytes, argument), ...); },
               testing::random_arguments<f, formula>(seed));
    return bytes;
}

template <class Result, class... Argument> Result result_of(Result (*)(Argument...));

template <FormulaIndex f, auto& formula> FormulaType described()
{
    using Result = decltype(result_of(&formula));
    const auto index = static_cast<unsigned>(f);
    const FormulaQuantities& of = formula_quantities[index];
    const std::type_identity<testing::Arguments<formula>> arguments;
    constexpr bool is_mesh =
        std::is_same_v<Result, SplitMesh> || std::is_same_v<Result, EmbeddedMesh>;
    FormulaType type = {Layout(arguments_type(of, formulas[index].arguments, arguments)),
                        Layout(is_mesh ? encoding_of<std::vector<double>>(of.result)
                                       : encoding_of<Result>(of.result)),
                        wire::encoded_size<Result>().most, &drawn<f, formula>, nullptr};
    if constexpr (is_mesh) type.unique = &unique_in<Result>;
    return type;
}

using Describe = FormulaType (*)();
#define RIGOR_ROW(tag, topic, function, ...) &described<FormulaIndex::function, rigor::function>,
constexpr Describe descriptions[] = {RIGOR_FORMULAS(RIGOR_ROW)};
#undef RIGOR_ROW

} // namespace

const FormulaType& type_of(FormulaIndex formula)
{
    static std::unique_ptr<const FormulaType> known[formula_count];
    const auto index = static_cast<unsigned>(formula);
    if (!known[index]) known[index] = std::make_unique<const FormulaType>(descriptions[index]());
    return *known[index];
}

std::optional<FormulaIndex> formula_with(std::string_view tag)
{
    for (unsigned i = 0; i < formula_count; ++i)
        if (formulas[i].tag == tag) return FormulaIndex{i};
    return {};
}

} // namespace rigor::diagnosis
