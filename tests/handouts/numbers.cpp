// SPDX-License-Identifier: MIT
#include "handouts/numbers.hpp"

#include "handouts/handouts.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <regex>

namespace rigor::handouts {

std::string in_one_line(const std::string& text)
{
    return std::regex_replace(text, std::regex(R"(\s+)"), " ");
}

namespace {

struct Number {
    double value = 0, last_digit = 1; // a unit of its last digit
};

// The numbers of a quote. An index and an exponent are none.
std::vector<Number> numbers_in(const std::string& quote)
{
    const std::string text = std::regex_replace(quote, std::regex("−"), "-");
    std::vector<Number> numbers;
    static const std::regex number(R"((-?\d+)(\.\d+)?(/\d+)?)");
    for (std::sregex_iterator i(text.begin(), text.end(), number), end; i != end; ++i) {
        const std::string decimals = (*i)[2], over = (*i)[3];
        Number found;
        found.value = std::stod((*i)[1].str() + decimals);
        if (!over.empty()) found.value /= std::stod(over.substr(1));
        const auto digits = decimals.empty() ? 0 : static_cast<int>(decimals.size()) - 1;
        found.last_digit = over.empty() ? std::pow(10.0, -digits) : 1e-12;
        numbers.push_back(found);
    }
    return numbers;
}

} // namespace

void check_shown(const std::string& label, const std::string& quote,
                 const std::vector<double>& values)
{
    for (const Handout& handout : all_handouts()) {
        if (handout.label != label) continue;
        CAPTURE(label, quote);
        CHECK(in_one_line(handout.text).find(in_one_line(quote)) != std::string::npos);
        const std::vector<Number> shown = numbers_in(quote);
        REQUIRE(shown.size() == values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            CAPTURE(i, shown[i].value, values[i]);
            CHECK(std::abs(shown[i].value - values[i]) <= 0.5000001 * shown[i].last_digit);
        }
        return;
    }
    FAIL("no handout " + label);
}

std::vector<double> listed(const Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}

std::vector<double> rows_of(const Matrix3d& A)
{
    std::vector<double> entries;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            entries.push_back(A(i, j));
    return entries;
}

} // namespace rigor::handouts
