// SPDX-License-Identifier: MIT
#include "worker/proxy/questions.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace rigor {

namespace {

constexpr std::size_t longest_question = std::size_t{1} << 20; // [bytes]

std::string fault_of_question(const Judgement& judgement, const Askable& askable)
{
    const std::vector<double>& numbers = judgement.question;
    const std::size_t size = numbers.size() * sizeof(double);
    if (size > longest_question)
        return fmt::format("it has {} bytes, and at most {} are allowed", size, longest_question);
    if (numbers.size() != askable.arguments)
        return fmt::format("it has {} numbers, and the formula takes {}", numbers.size(),
                           askable.arguments);
    if (judgement.calls_before < 0 ||
        static_cast<std::size_t>(judgement.calls_before) > askable.known)
        return fmt::format("it comes after {} calls, and {} are known", judgement.calls_before,
                           askable.known);
    for (const double number : numbers)
        if (!(std::abs(number) <= largest_question))
            return fmt::format("it has the number {:.3g}, and numbers are at most {:.0e}", number,
                               largest_question);
    return "";
}

} // namespace

void check_judgement(std::string_view test, const Judgement& judgement, const Askable& askable)
{
    if (judgement.question.empty()) {
        if (judgement.rejected_in < 0)
            throw std::out_of_range(fmt::format("{} rejected a formula in line {}, which is none",
                                                test, judgement.rejected_in));
        return;
    }
    const std::string fault = fault_of_question(judgement, askable);
    if (!fault.empty())
        throw std::out_of_range(fmt::format("{} sent a question that is none: {}", test, fault));
}

} // namespace rigor
