// SPDX-License-Identifier: MIT
// Splits the text of a mesh into tokens, one at a time, and counts the lines. Numbers are checked
// when they are read.
#include "geometry/mesh_files/tokenizer.hpp"

#include "geometry/mesh_files/mesh_text.hpp"
#include "geometry/meshes/mesh_checks.hpp"

#include <cmath>

namespace rigor {

namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

} // namespace

std::string_view Tokenizer::peek()
{
    while (!rest_.empty() && blanks.find(rest_.front()) != std::string_view::npos) {
        line_ += rest_.front() == '\n';
        rest_.remove_prefix(1);
    }
    return rest_.substr(0, rest_.find_first_of(blanks));
}

std::string_view Tokenizer::next()
{
    const std::string_view word = peek();
    rest_.remove_prefix(word.size());
    return word;
}

void Tokenizer::skip_line()
{
    const std::size_t end = rest_.find('\n');
    if (end != std::string_view::npos) ++line_;
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
}

double Tokenizer::coordinate()
{
    const std::string_view word = next();
    double x = 0;
    if (!parse(word, x) || !std::isfinite(x) || std::abs(x) > largest_coordinate)
        refuse("a coordinate of at most 1e12 in size", word);
    return x;
}

long long Tokenizer::integer(long long low, long long high, const char* what)
{
    const std::string_view word = next();
    long long number = 0;
    if (!parse(word, number) || number < low || number > high) refuse(what, word);
    return number;
}

std::size_t Tokenizer::count(std::size_t most, const char* what)
{
    const std::string_view word = next();
    unsigned long long number = 0;
    if (!parse(word, number)) refuse(std::string("a number of ") + what, word);
    if (number > most) refuse("at most " + std::to_string(most) + " " + what, word);
    return number;
}

void Tokenizer::expect(std::string_view expected)
{
    const std::string_view word = next();
    if (word != expected) refuse("\"" + std::string(expected) + "\"", word);
}

void Tokenizer::refuse(const std::string& expected, std::string_view found) const
{
    throw MeshError(line_,
                    "expected " + expected + ", found " + quoted(found, "the end of the text"));
}

} // namespace rigor
