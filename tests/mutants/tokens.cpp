// SPDX-License-Identifier: MIT
// Splits a source into tokens. It needs no more of C++ than the formatted sources of this tree
// have: no raw strings, no comments between slashes and stars, no shifts.
#include "mutants/tokens.hpp"

#include <array>
#include <cctype>
#include <stdexcept>

namespace rigor::mutants {

namespace {

bool is_space(char c)
{
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

bool is_word(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// The end of the line that contains `at`.
std::size_t line_end(std::string_view text, std::size_t at)
{
    return std::min(text.find('\n', at), text.size());
}

// The end of a number: `1e-12` is one.
std::size_t number_end(std::string_view text, std::size_t at)
{
    while (at < text.size() && (is_word(text[at]) || text[at] == '.' ||
                                ((text[at] == '-' || text[at] == '+') && (text[at - 1] == 'e'))))
        ++at;
    return at;
}

std::size_t literal_end(std::string_view text, std::size_t at)
{
    const char quote = text[at];
    for (++at; text[at] != quote; ++at)
        if (text[at] == '\\') ++at;
    return at + 1;
}

// Signs of two characters. `>>` closes two templates, so it is not one of them.
constexpr std::array<std::string_view, 16> signs_of_two = {
    "->", "++", "--", "+=", "-=", "*=", "/=", "|=", "&&", "||", "==", "!=", "<=", ">=", "::", "<<"};

std::size_t sign_end(std::string_view text, std::size_t at)
{
    for (const std::string_view sign : signs_of_two)
        if (text.substr(at, 2) == sign) return at + 2;
    return at + 1;
}

} // namespace

std::vector<Token> tokens(std::string_view text)
{
    std::vector<Token> result;
    bool is_line_start = true;
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        if (is_space(c)) {
            is_line_start |= c == '\n';
            ++at;
            continue;
        }
        if ((c == '#' && is_line_start) || text.substr(at, 2) == "//") {
            at = line_end(text, at);
            continue;
        }
        is_line_start = false;
        Token token = {Token::Kind::sign, at, 0, {}, false};
        if (std::isdigit(static_cast<unsigned char>(c))) {
            token.kind = Token::Kind::number;
            token.end = number_end(text, at);
        } else if (is_word(c)) {
            token.kind = Token::Kind::word;
            for (token.end = at; token.end < text.size() && is_word(text[token.end]);)
                ++token.end;
        } else if (c == '"' || c == '\'') {
            token.kind = Token::Kind::literal;
            token.end = literal_end(text, at);
        } else {
            token.end = sign_end(text, at);
        }
        token.text = text.substr(at, token.end - at);
        token.is_spaced = at > 0 && is_space(text[at - 1]) && token.end < text.size() &&
                          is_space(text[token.end]);
        result.push_back(token);
        at = token.end;
    }
    return result;
}

std::size_t closing(const std::vector<Token>& tokens, std::size_t open)
{
    int depth = 0;
    for (std::size_t i = open; i < tokens.size(); ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "(" || text == "{" || text == "[") ++depth;
        if (text == ")" || text == "}" || text == "]") --depth;
        if (depth == 0) return i;
    }
    throw std::runtime_error("a bracket is not closed");
}

} // namespace rigor::mutants
