// SPDX-License-Identifier: MIT
#include "scene/language/expression.hpp"

#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace expression_test {

using namespace rigor;

namespace {

Value text(const std::string& expression)
{
    Value value;
    value.kind = Value::Kind::string;
    value.text = expression;
    value.line = 3;
    return value;
}

double at(double t, const std::string& words)
{
    return expression(text(words))(t);
}

std::string refusal(const std::string& words)
{
    try {
        expression(text(words));
    } catch (const Mistake& mistake) {
        return std::to_string(mistake.line) + ": " + mistake.message;
    }
    return "accepted";
}

} // namespace

TEST_CASE("expression: it has the value of the formula")
{
    const double t = 1.7;
    CHECK(at(t, "t") == t);
    CHECK(at(t, " 2 + 3*t ") == 2 + 3 * t);
    CHECK(at(t, "7 - 4 - 2") == 1);
    CHECK(at(t, "12 / 3 / 2 * 5") == 10);
    CHECK(at(t, "2^3^2") == 512);
    CHECK(at(t, "-2^2") == -4);
    CHECK(at(t, "2^-1") == 0.5);
    CHECK(at(t, "--3 + -(-2)") == 5);
    CHECK(at(t, "(1 + t) * (1 - t)") == (1 + t) * (1 - t));
    CHECK(at(t, "1.5e1*.5") == 7.5);
    CHECK(at(t, "sin(2*pi*t)") == std::sin(2 * std::numbers::pi * t));
    CHECK(at(t, "exp(-t/2) * cos(t)") == std::exp(-t / 2) * std::cos(t));
    CHECK(at(t, "step(t - 1) + step(t - 2)") == 1);
    CHECK(at(t, "min(t, 1) + max(t, 3) - abs(-sqrt(4)) + log(1) + tan(0)") == 2);
    CHECK(std::isinf(at(0, "1/t")));
    const std::string deep = std::string(45, '(') + "1+1*2^t" + std::string(45, ')');
    CHECK(at(1, deep) == 3);
}

TEST_CASE("expression: what is wrong is told with its place")
{
    CHECK(refusal("") == "3: expected an expression of t in quotes, found \"\"");
    CHECK(refusal("2 +") == "3: expected a number, \"t\", \"pi\", a function or \"(\" at character "
                            "4 of \"2 +\", found the end");
    CHECK(refusal("2 t") ==
          "3: expected an operator or the end at character 3 of \"2 t\", found \"t\"");
    CHECK(refusal("(t") == "3: expected \")\" at character 3 of \"(t\", found the end");
    CHECK(refusal("sin t") ==
          "3: expected \"(\" after \"sin\" at character 5 of \"sin t\", found \"t\"");
    CHECK(refusal("min(t)").find("\",\" and a second value of \"min\"") != std::string::npos);
    CHECK(refusal("2*sine(t)")
              .find("at character 3 of \"2*sine(t)\", found \"sine\"; did you "
                    "mean \"sin\"?") != std::string::npos);
    CHECK(refusal("system(1)").find("found \"system\"") != std::string::npos);
    CHECK(refusal(std::string(60, '(') + "1" + std::string(60, ')'))
              .find("at most 50 parentheses in each other") != std::string::npos);
    std::string tower = "1";
    for (int i = 0; i < 80; ++i)
        tower += "^1";
    CHECK(refusal(tower).find("at most 50 powers in a row") != std::string::npos);
    CHECK(refusal(std::string(500, '+') + std::string(600, '1')).find("1000 characters") !=
          std::string::npos);
    CHECK(refusal("1e999") != "accepted");
}

} // namespace expression_test
