// SPDX-License-Identifier: MIT
// Defines each formula for the engine alone. The build makes these names local to the part of a
// worker that has the engine.
#include "worker/engine/answers.hpp"

#include "worker/protocol/define_formulas.hpp"
#include "worker/protocol/streamed_answer.hpp"
#include "worker/protocol/wire.hpp"

namespace rigor {

namespace {

const Stream* listener = nullptr;
const TakeAnswer* giver = nullptr;
FormulaSet are_given;
wire::Bytes encoded; // global, so that millions of calls in a scene use the same memory

template <class Result> void stream_answer(FormulaIndex formula, const Result& result)
{
    encoded.resize(sizeof(StreamedAnswer));
    wire::encode(encoded, result);
    const StreamedAnswer header{
        static_cast<std::uint32_t>(formula),
        static_cast<std::uint32_t>(encoded.size() - sizeof(StreamedAnswer))};
    std::memcpy(encoded.data(), &header, sizeof header);
    (*listener)(encoded);
}

template <FormulaIndex formula, class Formula, class... Argument>
typename Formula::Result answer(const Argument&... arguments)
{
    if (are_given[static_cast<unsigned>(formula)]) {
        (*giver)(formula, encoded);
        return wire::decode_all<typename Formula::Result>(encoded);
    }
    const auto implementation =
        reinterpret_cast<typename Formula::Pointer>(rigor_formulas[static_cast<unsigned>(formula)]);
    auto result = implementation(arguments...);
    if (listener) stream_answer(formula, result);
    return result;
}

} // namespace

RIGOR_FORMULAS(RIGOR_DEFINE_FORMULA)

StreamAnswers::StreamAnswers(const Stream& stream, const FormulaSet& given, const TakeAnswer& take)
{
    listener = &stream;
    giver = &take;
    are_given = given;
}
StreamAnswers::~StreamAnswers()
{
    listener = nullptr;
    giver = nullptr;
    are_given.reset();
}

} // namespace rigor
