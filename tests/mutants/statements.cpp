// SPDX-License-Identifier: MIT
// Mutations of statements: what is left out, what is always or never done, and what a variable
// starts with.
#include "mutants/mutation.hpp"

#include <set>

namespace rigor::mutants {

namespace {

bool has_condition(const Token& token)
{
    return token.text == "if" || token.text == "for" || token.text == "while";
}

// The last token of the statement that begins at token i.
std::size_t statement_end(const std::vector<Token>& tokens, std::size_t i)
{
    if (tokens[i].text == "{") return closing(tokens, i);
    if (has_condition(tokens[i])) {
        const std::size_t end = statement_end(tokens, closing(tokens, i + 1) + 1);
        if (end + 1 < tokens.size() && tokens[end + 1].text == "else")
            return statement_end(tokens, end + 2);
        return end;
    }
    for (; tokens[i].text != ";"; ++i)
        if (tokens[i].text == "(" || tokens[i].text == "{" || tokens[i].text == "[")
            i = closing(tokens, i);
    return i;
}

// The first tokens of all statements.
std::vector<std::size_t> statements(const std::vector<Token>& tokens, Range range)
{
    std::vector<std::size_t> result;
    std::set<std::size_t> starts = {range.first}, blocks;
    for (std::size_t i = range.first; i < range.last; ++i) {
        const std::string_view text = tokens[i].text, before = tokens[i - 1].text;
        if (has_condition(tokens[i])) starts.insert(closing(tokens, i + 1) + 1);
        const bool is_block = text == "{" && (before == ")" || before == "else");
        if (is_block) blocks.insert(closing(tokens, i));
        if (is_block || text == "else" || blocks.contains(i)) starts.insert(i + 1);
        if (text == ";") starts.insert(i + 1);
        if (text == "for") { // the semicolons of its header end no statement
            const std::size_t header = closing(tokens, i + 1);
            for (++i; i < header; ++i)
                if (tokens[i].text == "{") i = closing(tokens, i);
            --i;
        }
    }
    for (const std::size_t start : starts) {
        const std::string_view text = tokens[start].text;
        if (start < range.last && text != "}" && text != "{" && text != ")" && text != ",")
            result.push_back(start);
    }
    return result;
}

// Where a declaration has its variables: `double a = 1, b = 2;`
struct Declared {
    std::size_t type, name;
    Range value; // its first and its last token
};

std::vector<Declared> declared(const std::vector<Token>& tokens, std::size_t start)
{
    std::vector<Declared> result;
    const std::size_t type = tokens[start].text == "const" ? start + 1 : start;
    std::size_t name = type + 1;
    if (tokens[name].text == "&") return result;
    while (tokens[name].kind == Token::Kind::word && tokens[name + 1].text == "=") {
        std::size_t end = name + 2;
        for (; tokens[end].text != "," && tokens[end].text != ";"; ++end)
            if (tokens[end].text == "(" || tokens[end].text == "{" || tokens[end].text == "[")
                end = closing(tokens, end);
        result.push_back({type, name, {name + 2, end - 1}});
        if (tokens[end].text == ";") break;
        name = end + 1;
    }
    return result;
}

// Whether the tokens only name something that exists: `mesh.tetrahedra[t]`.
bool names_something(const std::vector<Token>& tokens, Range value)
{
    for (std::size_t i = value.first; i <= value.last; ++i) {
        const Token& token = tokens[i];
        if (token.kind != Token::Kind::word && token.text != "." && token.text != "[" &&
            token.text != "]")
            return false;
    }
    return true;
}

void change_condition(const Source& source, std::size_t start, Mutations& result)
{
    const std::size_t close = closing(source.tokens, start + 1);
    const std::size_t begin = source.tokens[start + 1].end, end = source.tokens[close].begin;
    const std::string condition = source.text.substr(begin, end - begin);
    result.push_back({begin, end, "true"});
    result.push_back({begin, end, "false"});
    result.push_back({begin, end, "!(" + condition + ")"});
}

} // namespace

Mutations changed_statements(const Source& source, Range range)
{
    Mutations result;
    const std::vector<Token>& tokens = source.tokens;
    for (const std::size_t start : statements(tokens, range)) {
        const std::string_view text = tokens[start].text;
        const std::size_t end = statement_end(tokens, start);
        if (text == "const" || text == "constexpr" || text == "using" || text == "struct" ||
            text == "else")
            continue;
        if (text == "return")
            result.push_back({tokens[start].begin, tokens[end].end, "return {};"});
        else
            result.push_back({tokens[start].begin, tokens[end].end, ";"});
        if (text == "if") change_condition(source, start, result);
        if (text != "for") continue;
        const std::size_t body = closing(tokens, start + 1) + 1; // runs only once
        const std::size_t body_end = statement_end(tokens, body);
        result.push_back({tokens[body].begin, tokens[body_end].end,
                          "{ " + source.between(body, body_end) + " break; }"});
    }
    for (std::size_t i = range.first; i < range.last; ++i)
        if (tokens[i].text == "?")
            for (const char* other : {"&& false ?", "|| true ?"})
                result.push_back({tokens[i].begin, tokens[i].end, other});
    return result;
}

Mutations changed_starts(const Source& source, Range range)
{
    const std::vector<std::pair<std::string, std::string>> of_numbers = {
        {"std::abs(", ")"},           {"std::max(0.0, ", ")"}, {"std::min(1.0, ", ")"},
        {"static_cast<float>(", ")"}, {"1e-9 + (", ")"},
    };
    const std::vector<std::pair<std::string, std::string>> of_matrices = {
        {"(", ").cast<float>().cast<double>()"},
        {"(", ").cwiseAbs()"},
        {"(", ").transpose()"},
        {"(", ").normalized()"},
    };
    Mutations result;
    const std::vector<Token>& tokens = source.tokens;
    for (const std::size_t start : statements(tokens, range)) {
        const std::vector<Declared> variables = declared(tokens, start);
        if (variables.empty() || tokens[start].text == "return") continue;
        result.push_back({tokens[start].begin, tokens[start].begin, "static "});
        for (const Declared& variable : variables) {
            const std::string_view type = tokens[variable.type].text;
            const Range value = variable.value;
            const bool is_matrix = type == "Vector3d" || type == "Matrix3d";
            const bool is_zero = tokens[value.last - 2].text == "Zero";
            if (value.first == value.last || is_zero)
                continue; // nothing would change, or an argument, which is changed elsewhere
            if (type == "double" || is_matrix)
                for (const auto& [before, after] : is_matrix ? of_matrices : of_numbers) {
                    if (type == "Vector3d" && after == ").transpose()") continue; // is the same
                    result.push_back({tokens[value.first].begin, tokens[value.last].end,
                                      before + source.between(value.first, value.last) + after});
                }
            if (names_something(tokens, value))
                result.push_back({tokens[variable.name].begin, tokens[variable.name].begin, "&"});
        }
    }
    return result;
}

} // namespace rigor::mutants
