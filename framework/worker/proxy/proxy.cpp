// SPDX-License-Identifier: MIT
// Every function of the contract, generated from the table: encode, ask, decode, look for NaN.
#include "worker/proxy.hpp"

#include "worker/finite.hpp"

#include <memory>
#include <tuple>

namespace rigor {

namespace {

std::unique_ptr<Worker> under_test, reference;
Worker* asked = nullptr;

/// A rotation may be as slow as it likes: its longest step is then infinite.
constexpr bool may_be_infinite(FormulaIndex formula)
{
    return formula == FormulaIndex::max_time_step;
}

void refuse_non_finite(FormulaIndex formula, const std::string& which)
{
    if (which.empty() || (may_be_infinite(formula) && which == "it is +infinity")) return;
    throw NotFinite(subject_of(formula), which);
}

template <class Result> Result result_of(FormulaIndex formula, const wire::Bytes& arguments)
{
    static const std::size_t largest = wire::encoded_size<Result>().most;
    if (!asked) throw std::logic_error("a formula was called before use_worker said whom to ask");
    const wire::Bytes bytes = asked->call(formula, arguments, largest);
    try {
        Result result = wire::decode_all<Result>(bytes);
        refuse_non_finite(formula, find_non_finite(result));
        return result;
    } catch (const wire::Malformed& malformed) {
        asked->renew();
        throw WorkerFailure(WorkerFailure::malformed, subject_of(formula),
                            std::string("sent no answer: ") + malformed.what());
    }
}

template <class Result, class... Argument>
Result ask(FormulaIndex formula, const Argument&... arguments)
{
    wire::Bytes bytes;
    (wire::encode(bytes, arguments), ...);
    return result_of<Result>(formula, bytes);
}

/// The types of a formula, from its declaration.
template <class Function> struct Signature;
template <class R, class... Argument> struct Signature<R (*)(Argument...)> {
    using Result = R;
    template <int i> using Parameter = std::tuple_element_t<i, std::tuple<Argument...>>;
};

} // namespace

// One definition a row: `RIGOR_ROW(A2.14, inertia, combine, a, b)` is
// `MassProperties combine(const MassProperties& a, const MassProperties& b) { return ask<…>(…, a, b); }`
#define RIGOR_SIGNATURE(function) Signature<decltype(&rigor::function)>
#define RIGOR_PARAMETER(function, i, name) RIGOR_SIGNATURE(function)::Parameter<i> name
#define RIGOR_DEFINE(function, names, ...)                                                         \
    RIGOR_SIGNATURE(function)::Result function(__VA_ARGS__)                                        \
    {                                                                                              \
        return ask<RIGOR_SIGNATURE(function)::Result>(FormulaIndex::function, RIGOR_LIST names);   \
    }
#define RIGOR_LIST(...) __VA_ARGS__
#define RIGOR_DEFINE_1(f, a) RIGOR_DEFINE(f, (a), RIGOR_PARAMETER(f, 0, a))
#define RIGOR_DEFINE_2(f, a, b)                                                                    \
    RIGOR_DEFINE(f, (a, b), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b))
#define RIGOR_DEFINE_3(f, a, b, c)                                                                 \
    RIGOR_DEFINE(f, (a, b, c), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b),                 \
                 RIGOR_PARAMETER(f, 2, c))
#define RIGOR_DEFINE_4(f, a, b, c, d)                                                              \
    RIGOR_DEFINE(f, (a, b, c, d), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b),              \
                 RIGOR_PARAMETER(f, 2, c), RIGOR_PARAMETER(f, 3, d))
#define RIGOR_DEFINE_5(f, a, b, c, d, e)                                                           \
    RIGOR_DEFINE(f, (a, b, c, d, e), RIGOR_PARAMETER(f, 0, a), RIGOR_PARAMETER(f, 1, b),           \
                 RIGOR_PARAMETER(f, 2, c), RIGOR_PARAMETER(f, 3, d), RIGOR_PARAMETER(f, 4, e))
#define RIGOR_SELECT(_1, _2, _3, _4, _5, define, ...) define
#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    RIGOR_SELECT(__VA_ARGS__, RIGOR_DEFINE_5, RIGOR_DEFINE_4, RIGOR_DEFINE_3, RIGOR_DEFINE_2,      \
                 RIGOR_DEFINE_1, )                                                                 \
    (function, __VA_ARGS__)
RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW

void use_worker(const std::filesystem::path& executable,
                const std::optional<std::filesystem::path>& oracle_executable, const Limits& limits)
{
    asked = nullptr;
    under_test.reset();
    reference = oracle_executable ? std::make_unique<Worker>(*oracle_executable, limits) : nullptr;
    under_test = std::make_unique<Worker>(executable, limits, reference.get());
    asked = under_test.get();
}

Worker& worker()
{
    if (!under_test) throw std::logic_error("use_worker has not been called");
    return *under_test;
}

Worker* oracle()
{
    return reference.get();
}

void renew_worker()
{
    worker().renew();
}

AskOracle::AskOracle()
{
    if (!reference) throw std::logic_error("there is no reference to ask");
    asked = reference.get();
}
AskOracle::~AskOracle()
{
    asked = under_test.get();
}

} // namespace rigor
