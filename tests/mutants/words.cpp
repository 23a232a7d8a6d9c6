// SPDX-License-Identifier: MIT
// Mutations of words: other functions, other components, other variables, other orders of
// arguments.
#include "mutants/mutation.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace rigor::mutants {

namespace {

using Texts = std::vector<std::string>;

// Words that take the place of each other.
const std::map<std::string_view, Texts> other_words = {
    {"x", {"y"}},
    {"y", {"z"}},
    {"z", {"x"}},
    {"norm", {"squaredNorm", "stableNorm", "maxCoeff"}},
    {"squaredNorm", {"norm", "stableNorm"}},
    {"stableNorm", {"norm"}},
    {"stableNormalized", {"normalized"}},
    {"normalized", {"stableNormalized"}},
    {"cwiseMin", {"cwiseMax"}},
    {"cwiseMax", {"cwiseMin"}},
    {"cwiseAbs2", {"cwiseAbs"}},
    {"maxCoeff", {"minCoeff", "sum"}},
    {"minCoeff", {"maxCoeff"}},
    {"min", {"max"}},
    {"max", {"min"}},
    {"sin", {"cos", ""}},
    {"cos", {"sin"}},
    {"abs", {""}},
    {"sqrt", {""}},
    {"hypot", {"std::max", "std::min"}},
    {"clamp", {"std::max", "std::min"}},
    {"trace", {"sum", "maxCoeff"}},
    {"sum", {"maxCoeff", "norm"}},
    {"determinant", {"trace", "sum"}},
    {"Zero", {"Ones", "Constant(1e-6)+0*Eigen::Vector3d::Zero"}},
    {"Ones", {"UnitX"}},
    {"Identity", {"Zero", "Ones"}},
    {"UnitX", {"UnitY", "Zero"}},
    {"UnitY", {"UnitZ", "Zero"}},
    {"UnitZ", {"UnitX", "Zero"}},
    {"front", {"back"}},
    {"back", {"front"}},
    {"head", {"tail"}},
    {"tail", {"head"}},
    {"first", {"second"}},
    {"second", {"first"}},
    {"t1", {"t2"}},
    {"t2", {"t1"}},
    {"body1", {"body2"}},
    {"body2", {"body1"}},
    {"above", {"below"}},
    {"below", {"above"}},
    {"normal", {"tangential", "point"}},
    {"tangential", {"normal"}},
    {"position", {"velocity"}},
    {"velocity", {"angular_velocity", "position", "angular_momentum"}},
    {"angular_velocity", {"velocity", "angular_momentum"}},
    {"angular_momentum", {"angular_velocity", "velocity"}},
    {"force", {"torque", "point"}},
    {"torque", {"force"}},
    {"rbegin", {"begin"}},
    {"rend", {"end"}},
    {"stable_sort", {"std::sort"}},
    {"true", {"false"}},
    {"false", {"true"}},
    {"continue", {"break"}},
    {"lerp", {"std::max", "std::fma"}},
    {"isfinite", {"std::isnan"}},
    {"unitOrthogonal", {"stableNormalized"}},
    {"ldlt", {"llt", "fullPivLu"}},
};

// Functions without arguments that are left out.
const std::set<std::string_view> left_out = {"transpose", "normalized", "stableNormalized",
                                             "cwiseAbs",  "cwiseAbs2",  "rbegin"};

// Functions whose arguments are not exchanged, because their order does not matter.
const std::set<std::string_view> symmetric = {"min", "max", "hypot"};

bool is_component(std::string_view word)
{
    return word == "x" || word == "y" || word == "z";
}

struct Variable {
    std::string type;
    std::string_view origin; // the variable that it is a second name of, or itself
};

using Variables = std::map<std::string_view, Variable>;

// The variable that token i declares, which has this type.
Variable declared(const std::vector<Token>& tokens, std::size_t i, const std::string& type)
{
    const bool is_second_name = tokens[i + 1].text == "=" &&
                                tokens[i + 2].kind == Token::Kind::word &&
                                (tokens[i + 3].text == ";" || tokens[i + 3].text == ",");
    return {type, tokens[is_second_name ? i + 2 : i].text};
}

// The variables of a function.
Variables variables_of(const Source& source, const Function& function)
{
    const std::vector<Token>& tokens = source.tokens;
    Variables result;
    std::string type;
    for (std::size_t i = function.name_token + 1; i < function.close; ++i) {
        if (tokens[i].kind != Token::Kind::word) continue;
        const std::string_view before = tokens[i - 1].text, after = tokens[i + 1].text;
        const bool is_declared = (after == "=" || after == ";" || after == "," || after == ")");
        std::size_t word = i - 1; // the type's last word
        while (tokens[word].text == "&" || tokens[word].text == ">")
            --word;
        const bool has_type = tokens[word].kind == Token::Kind::word && before != "return" &&
                              (tokens[word].end < tokens[i].begin) && before != "(";
        if (is_declared && has_type) {
            type = tokens[word].text;
            if (tokens[i - 1].text == ">") type += ">"; // a list
            result.emplace(tokens[i].text, declared(tokens, i, type));
        } else if (before == "," && after == "=") { // one more of the same declaration
            result.emplace(tokens[i].text, declared(tokens, i, type));
        }
    }
    return result;
}

// The variables of the same type that come next in the order of their names.
Texts next_of_type(const Variables& variables, std::string_view name)
{
    constexpr std::size_t most = 3; // more would take long to compile and tell little
    Texts result;
    const auto self = variables.find(name);
    if (self == variables.end()) return result;
    auto other = self;
    for (std::size_t i = 1; i < variables.size() && result.size() < most; ++i) {
        if (++other == variables.end()) other = variables.begin();
        if (other->second.type == self->second.type && other->second.origin != self->second.origin)
            result.emplace_back(other->first);
    }
    return result;
}

// The places where the arguments of a call begin and end.
std::vector<Range> arguments_of(const std::vector<Token>& tokens, std::size_t open)
{
    std::vector<Range> result;
    const std::size_t close = closing(tokens, open);
    std::size_t begin = open + 1;
    for (std::size_t i = open + 1; i <= close; ++i) {
        const std::string_view text = tokens[i].text;
        if ((text == "(" || text == "[" || text == "{")) {
            i = closing(tokens, i);
        } else if (text == "," || i == close) {
            if (i > begin) result.push_back({begin, i - 1});
            begin = i + 1;
        }
    }
    return result;
}

} // namespace

Mutations changed_words(const Source& source, Range range)
{
    Mutations result;
    const std::vector<Token>& tokens = source.tokens;
    for (std::size_t i = range.first; i < range.last; ++i) {
        const Token& token = tokens[i];
        const std::string_view before = tokens[i - 1].text;
        if (left_out.contains(token.text) && before == "." && tokens[i + 1].text == "(")
            result.push_back({tokens[i - 1].begin, tokens[i + 2].end, ""});
        const auto found = other_words.find(token.text);
        if (found == other_words.end()) continue;
        if (is_component(token.text) && before != ".") continue;
        const bool is_in_std = before == "::" && tokens[i - 2].text == "std";
        for (const std::string& other : found->second) {
            const bool takes_all = is_in_std && (other.empty() || other.starts_with("std::"));
            result.push_back({takes_all ? tokens[i - 2].begin : token.begin, token.end, other});
        }
    }
    return result;
}

Mutations changed_variables(const Source& source, const Function& function)
{
    Mutations result;
    const std::vector<Token>& tokens = source.tokens;
    const Variables variables = variables_of(source, function);
    std::string_view without_value; // the variable that is being declared
    for (std::size_t i = function.open; i < function.close; ++i) {
        const Token& token = tokens[i];
        const std::string_view before = tokens[i - 1].text;
        const bool has_type = tokens[i - 1].kind == Token::Kind::word || before == "," ||
                              before == "&" || before == ">";
        if (has_type && tokens[i + 1].text == "=" && variables.contains(token.text))
            without_value = token.text;
        if (token.text == ";") without_value = {};
        if (token.kind == Token::Kind::word && before != "." && before != "::" && before != "->")
            for (const std::string& other : next_of_type(variables, token.text))
                if (other != without_value) result.push_back({token.begin, token.end, other});

        const bool is_call = (token.text == "(" || token.text == "{") &&
                             (tokens[i - 1].kind == Token::Kind::word || before == ">") &&
                             before != "for" && before != "if" && before != "while" &&
                             !symmetric.contains(before);
        const bool is_list = token.text == "{" && (before == "return" || before == "(");
        if (!is_call && !is_list) continue;
        const std::vector<Range> arguments = arguments_of(tokens, i);
        for (std::size_t a = 0; a + 1 < arguments.size(); ++a) {
            const std::string one = source.between(arguments[a].first, arguments[a].last),
                              two = source.between(arguments[a + 1].first, arguments[a + 1].last);
            if (one != two)
                result.push_back({tokens[arguments[a].first].begin,
                                  tokens[arguments[a + 1].last].end, two + ", " + one});
        }
    }
    return result;
}

} // namespace rigor::mutants
