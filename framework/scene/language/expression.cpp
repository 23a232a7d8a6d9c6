// SPDX-License-Identifier: MIT
// Reads an expression by recursive descent, with a function for each level of precedence, and
// writes it as a program for a stack machine, that is, in postfix order.
#include "scene/language/expression.hpp"

#include "errors/nearest.hpp"
#include "errors/quotes.hpp"
#include "scene/language/keys.hpp"
#include "scene/language/values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

namespace rigor {

namespace {

using Instruction = Expression::Instruction;

// Longer and deeper expressions are refused: the limits bound the stack and the time of a step.
constexpr std::size_t most_characters = 1000;
constexpr int most_depth = 50;

struct Function {
    std::string_view name;
    int arguments;
    double (*function)(double a, double b);
};

constexpr Function functions[] = {
    {"sin", 1, [](double a, double) { return std::sin(a); }},
    {"cos", 1, [](double a, double) { return std::cos(a); }},
    {"tan", 1, [](double a, double) { return std::tan(a); }},
    {"exp", 1, [](double a, double) { return std::exp(a); }},
    {"log", 1, [](double a, double) { return std::log(a); }},
    {"sqrt", 1, [](double a, double) { return std::sqrt(a); }},
    {"abs", 1, [](double a, double) { return std::abs(a); }},
    {"step", 1, [](double a, double) { return a < 0 ? 0.0 : 1.0; }},
    {"min", 2, [](double a, double b) { return std::min(a, b); }},
    {"max", 2, [](double a, double b) { return std::max(a, b); }},
};

double negative(double a, double)
{
    return -a;
}
double sum(double a, double b)
{
    return a + b;
}
double difference(double a, double b)
{
    return a - b;
}
double product(double a, double b)
{
    return a * b;
}
double quotient(double a, double b)
{
    return a / b;
}
double power(double a, double b)
{
    return std::pow(a, b);
}

bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

class Parser {
public:
    explicit Parser(const Value& value) : value_(value), text_(value.text) {}

    std::vector<Instruction> read()
    {
        read_sum();
        if (peek() != '\0') refuse("an operator or the end");
        return std::move(program_);
    }

private:
    // The next character that is no blank, or 0 at the end.
    char peek()
    {
        while (at_ < text_.size() && text_[at_] == ' ')
            ++at_;
        return at_ < text_.size() ? text_[at_] : '\0';
    }

    bool take(char c)
    {
        if (peek() != c) return false;
        ++at_;
        return true;
    }

    [[noreturn]] void refuse(const std::string& wanted)
    {
        const char c = peek();
        throw Mistake{value_.line,
                      fmt::format("expected {} at character {} of {}, found {}", wanted, at_ + 1,
                                  in_quotes(text_),
                                  c == '\0' ? "the end" : in_quotes(text_.substr(at_, 1)))};
    }

    void apply(int arguments, double (*function)(double, double))
    {
        program_.push_back({arguments, function, 0, false});
    }

    void read_sum()
    {
        if (++depth_ > most_depth)
            refuse(fmt::format("at most {} parentheses in each other", most_depth));
        read_product();
        for (;;)
            if (take('+')) {
                read_product();
                apply(2, sum);
            } else if (take('-')) {
                read_product();
                apply(2, difference);
            } else {
                --depth_;
                return;
            }
    }

    void read_product()
    {
        read_signed();
        for (;;)
            if (take('*')) {
                read_signed();
                apply(2, product);
            } else if (take('/')) {
                read_signed();
                apply(2, quotient);
            } else {
                return;
            }
    }

    void read_signed()
    {
        bool is_negative = false;
        while (peek() == '-' || peek() == '+')
            is_negative ^= text_[at_++] == '-';
        read_power();
        if (is_negative) apply(1, negative);
    }

    void read_power()
    {
        read_atom();
        if (!take('^')) return;
        if (++depth_ > most_depth) refuse(fmt::format("at most {} powers in a row", most_depth));
        read_signed(); // from the right: 2^3^2 is 2^9
        --depth_;
        apply(2, power);
    }

    void read_atom()
    {
        const char c = peek();
        if (take('(')) {
            read_sum();
            if (!take(')')) refuse("\")\"");
        } else if ((c >= '0' && c <= '9') || c == '.') {
            read_number();
        } else if (is_letter(c)) {
            read_name();
        } else {
            refuse("a number, \"t\", \"pi\", a function or \"(\"");
        }
    }

    void read_number()
    {
        double x = 0;
        const char* const start = text_.data() + at_;
        const auto [end, error] = std::from_chars(start, text_.data() + text_.size(), x);
        if (error != std::errc()) refuse("a number");
        at_ += static_cast<std::size_t>(end - start);
        program_.push_back({0, nullptr, x, false});
    }

    void read_name()
    {
        const std::size_t start = at_;
        std::size_t end = at_;
        while (end < text_.size() && is_letter(text_[end]))
            ++end;
        const std::string_view name = text_.substr(start, end - start);
        if (name == "t" || name == "pi") {
            program_.push_back({0, nullptr, std::numbers::pi, name == "t"});
            at_ = end;
            return;
        }
        const auto found = std::find_if(std::begin(functions), std::end(functions),
                                        [&](const Function& f) { return f.name == name; });
        if (found == std::end(functions)) refuse_name(name);
        at_ = end;
        if (!take('(')) refuse(fmt::format("\"(\" after \"{}\"", name));
        for (int i = 0; i < found->arguments; ++i) {
            if (i > 0 && !take(','))
                refuse(fmt::format("\",\" and a second value of \"{}\"", name));
            read_sum();
        }
        if (!take(')')) refuse("\")\"");
        apply(found->arguments, found->function);
    }

    [[noreturn]] void refuse_name(std::string_view name)
    {
        std::vector<std::string_view> names = {"t", "pi"};
        for (const Function& f : functions)
            names.push_back(f.name);
        throw Mistake{value_.line, fmt::format("expected {} at character {} of {}, found {}{}",
                                               list_of(names), at_ + 1, in_quotes(text_),
                                               in_quotes(name), suggestion(name, names))};
    }

    const Value& value_;
    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::vector<Instruction> program_;
};

} // namespace

double Expression::operator()(double t) const
{
    double stack[4 * most_depth + 8]; // each level of depth holds at most 4 values
    int top = -1;
    for (const Instruction& i : program_)
        if (!i.function) {
            stack[++top] = i.is_time ? t : i.number;
        } else if (i.arguments == 1) {
            stack[top] = i.function(stack[top], 0);
        } else {
            --top;
            stack[top] = i.function(stack[top], stack[top + 1]);
        }
    return stack[0];
}

Expression expression(const Value& value)
{
    const std::string text = line_of_text(value, "an expression of t in quotes");
    if (text.size() > most_characters)
        expected(fmt::format("an expression of at most {} characters", most_characters), value);
    return Expression(Parser(value).read());
}

} // namespace rigor
