// SPDX-License-Identifier: MIT
// Mutations of operators and their operands. Operators of two operands are recognized by the spaces
// around them. An operand ends where an operator of the same or a lower rank follows.
#include "mutants/mutation.hpp"

#include <algorithm>
#include <map>

namespace rigor::mutants {

namespace {

using Texts = std::vector<std::string>;

const std::map<std::string_view, Texts> others = {
    {"+", {"-"}},        {"-", {"+"}},        {"*", {"/"}},        {"/", {"*"}},
    {"+=", {"-=", "="}}, {"-=", {"+=", "="}}, {"*=", {"/=", "="}}, {"/=", {"*=", "="}},
    {"|=", {"="}},       {"<", {"<=", ">"}},  {">", {">=", "<"}},  {"<=", {"<", ">"}},
    {">=", {">", "<"}},  {"==", {"!="}},      {"!=", {"=="}},      {"&&", {"||"}},
    {"||", {"&&"}},
};

// The rank of an operator of two operands: a higher one binds its operands more closely. 0 for
// all other tokens.
int rank(const Token& token)
{
    static const std::map<std::string_view, int> ranks = {
        {"||", 1}, {"&&", 2}, {"==", 3}, {"!=", 3}, {"<", 4}, {">", 4},
        {"<=", 4}, {">=", 4}, {"+", 5},  {"-", 5},  {"*", 6}, {"/", 6}};
    const auto found = ranks.find(token.text);
    return token.is_spaced && found != ranks.end() ? found->second : 0;
}

bool ends_every_operand(const Token& token)
{
    static const Texts ends = {";", ",", ")", "}",      "]",  "?",  ":",  "=",  "<<",
                               "(", "{", "[", "return", "+=", "-=", "*=", "/=", "|="};
    return std::find(ends.begin(), ends.end(), token.text) != ends.end();
}

bool is_negation(const std::vector<Token>& tokens, std::size_t i)
{
    if (tokens[i].is_spaced) return false;
    if (tokens[i].text == "!") return true;
    if (tokens[i].text != "-") return false;
    const Token& before = tokens[i - 1];
    return before.text == "return" ||
           (before.kind == Token::Kind::sign && before.text != ")" && before.text != "]");
}

// The last token of the operand that begins at token i.
std::size_t operand_end(const std::vector<Token>& tokens, std::size_t i, int its_rank)
{
    for (; i + 1 < tokens.size(); ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "(" || text == "[" || text == "{") i = closing(tokens, i);
        const Token& next = tokens[i + 1];
        const bool opens = next.text == "(" || next.text == "[" || next.text == "{";
        if (!opens && ends_every_operand(next)) return i;
        if (rank(next) != 0 && rank(next) <= its_rank) return i;
    }
    return i;
}

// The first token of the operand that ends at token i.
std::size_t operand_begin(const std::vector<Token>& tokens, std::size_t i, int its_rank)
{
    int depth = 0;
    for (;; --i) {
        const std::string_view text = tokens[i].text;
        if (text == ")" || text == "]" || text == "}") ++depth;
        if (text == "(" || text == "[" || text == "{") --depth;
        if (depth > 0) continue;
        const Token& before = tokens[i - 1];
        const bool closes = before.text == ")" || before.text == "]" || before.text == "}";
        if (!closes && ends_every_operand(before)) return i;
        if (rank(before) != 0 && rank(before) <= its_rank) return i;
    }
}

// Numbers that may take the place of a number: its neighbors, and other thresholds for one such as
// 1e-12.
Texts other_numbers(const std::string& number)
{
    if (number.find('e') != std::string::npos) return {"0.0", "1e-9", "1e-6", "1e-3"};
    if (number.find('.') != std::string::npos)
        return {"(" + number + " + 1)", "(" + number + " - 1)", "(" + number + " * 1.000001)"};
    const long n = std::stol(number);
    return {std::to_string(n + 1), std::to_string(n - 1)};
}

} // namespace

Mutations changed_operators(const Source& source, Range range)
{
    Mutations result;
    for (std::size_t i = range.first; i < range.last; ++i) {
        const Token& token = source.tokens[i];
        if (is_negation(source.tokens, i)) result.push_back({token.begin, token.end, ""});
        if (token.text == "++") result.push_back({token.begin, token.end, "--"});
        const auto found = others.find(token.text);
        if (!token.is_spaced || found == others.end()) continue;
        for (const std::string& other : found->second)
            result.push_back({token.begin, token.end, other});
    }
    return result;
}

Mutations dropped_operands(const Source& source, Range range)
{
    Mutations result;
    const std::vector<Token>& tokens = source.tokens;
    for (std::size_t i = range.first; i < range.last; ++i) {
        const int its_rank = rank(tokens[i]);
        if (its_rank == 0 || its_rank == 3 || its_rank == 4) continue;
        const std::size_t end = operand_end(tokens, i + 1, its_rank);
        result.push_back({tokens[i - 1].end, tokens[end].end, ""});
        const std::size_t begin = operand_begin(tokens, i - 1, its_rank);
        if (tokens[i].text != "-" && tokens[i].text != "/")
            result.push_back({tokens[begin].begin, tokens[i + 1].begin, ""});
    }
    return result;
}

Mutations changed_numbers(const Source& source, Range range)
{
    Mutations result;
    for (std::size_t i = range.first; i < range.last; ++i) {
        const Token& token = source.tokens[i];
        if (token.text == "pi") result.push_back({token.begin, token.end, "3.14159"});
        if (token.kind != Token::Kind::number) continue;
        for (const std::string& other : other_numbers(std::string(token.text)))
            result.push_back({token.begin, token.end, other});
        if (token.text != "0") continue;
        const std::string_view before = source.tokens[i - 1].text;
        if (before == "==")
            for (const char* other : {"<= 1e-9", "<= 1e-6", "<= 1e-3"})
                result.push_back({source.tokens[i - 1].begin, token.end, other});
        if (before == "<=" || before == "<" || before == ">" || before == ">=")
            for (const char* other : {"1e-9", "1e-6", "1e-3", "-1e-9", "-1e-6", "-1e-3"})
                result.push_back({token.begin, token.end, other});
        if (before == "(" && source.tokens[i - 2].text == "isZero")
            for (const char* other : {"1e-12", "1e-9", "1e-6", "1e-3"})
                result.push_back({token.begin, token.end, other});
    }
    return result;
}

} // namespace rigor::mutants
