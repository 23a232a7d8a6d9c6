// SPDX-License-Identifier: MIT
// Reads a formula from left to right. An atom is a letter, a number, a command or a group; indices
// and exponents that follow are attached to it. Matrices and fractions read their parts in the same
// way.
#include "book/mathml.hpp"

#include "errors/input_error.hpp"
#include "errors/markup.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <map>
#include <string_view>
#include <vector>

namespace rigor::book {

namespace {

using Words = std::map<std::string, std::string_view, std::less<>>;

const Words letters = {{"alpha", "α"},   {"beta", "β"},       {"gamma", "γ"},  {"delta", "δ"},
                       {"epsilon", "ϵ"}, {"varepsilon", "ε"}, {"theta", "θ"},  {"lambda", "λ"},
                       {"mu", "μ"},      {"nu", "ν"},         {"rho", "ρ"},    {"sigma", "σ"},
                       {"tau", "τ"},     {"phi", "ϕ"},        {"varphi", "φ"}, {"psi", "ψ"},
                       {"omega", "ω"},   {"pi", "π"},         {"Delta", "Δ"},  {"Omega", "Ω"}};
constexpr std::string_view not_stretched = " stretchy=\"false\"";

const Words operators = {{"cdot", "·"},  {"times", "×"}, {"ast", "∗"},       {"le", "≤"},
                         {"ge", "≥"},    {"pm", "±"},    {"sum", "∑"},       {"int", "∫"},
                         {"nabla", "∇"}, {"to", "→"},    {"leftarrow", "←"}, {"partial", "∂"},
                         {"dots", "…"}};
struct Bar {
    std::string_view text, form; // form: "prefix" is an opening bar, "postfix" a closing bar
};
const std::map<std::string, Bar, std::less<>> bars = {{"lvert", {"|", "prefix"}},
                                                      {"rvert", {"|", "postfix"}},
                                                      {"lVert", {"‖", "prefix"}},
                                                      {"rVert", {"‖", "postfix"}}};
const Words functions = {{"cos", "cos"}, {"sin", "sin"}, {"tan", "tan"}, {"arctan", "arctan"},
                         {"exp", "exp"}, {"det", "det"}, {"max", "max"}};
const Words spaces = {
    {"qquad", "2em"}, {"quad", "1em"}, {",", "0.17em"}, {";", "0.28em"}, {" ", "0.25em"}};
constexpr std::string_view thin_space = "<mspace width=\"0.17em\"/>";
const Words accents = {{"dot", "˙"}, {"ddot", "¨"}, {"bar", "¯"}};

std::string element(std::string_view name, const std::string& content)
{
    return fmt::format("<{0}>{1}</{0}>", name, content);
}

class Formula {
public:
    explicit Formula(const std::string& latex) : text_(latex) {}

    /// Reads atoms up to `end`, and skips `end`. If `end` is empty, reads the whole formula.
    std::string row(std::string_view end = "")
    {
        std::string result;
        skip_space();
        while (at_ < text_.size()) {
            if (!end.empty() && starts_with(end)) {
                at_ += end.size();
                return element("mrow", result);
            }
            result += next_after(result);
            skip_space();
        }
        if (!end.empty()) fail("expected " + std::string(end));
        return element("mrow", result);
    }

private:
    [[noreturn]] void fail(const std::string& what) const
    {
        throw InputError(fmt::format("formula {}: {}", text_, what));
    }
    bool starts_with(std::string_view word) const
    {
        return text_.compare(at_, word.size(), word) == 0;
    }
    void skip_space()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0)
            ++at_;
    }

    // Whether `row` does not end with an operand: then a plus or minus that follows is a sign, as
    // in "= −1" and "(−1".
    static bool is_open(const std::string& row)
    {
        return row.empty() || row.ends_with("/>") || (row.ends_with("</mo>") && !is_closed(row));
    }
    static bool is_closed(const std::string& row)
    {
        return row.ends_with(")</mo>") || row.ends_with("]</mo>") || row.ends_with("′</mo>") ||
               row.ends_with("\"postfix\">|</mo>") || row.ends_with("\"postfix\">‖</mo>");
    }

    // Whether the name of a function comes next, such as \cos.
    bool is_function_next() const
    {
        std::size_t end = at_ + 1;
        while (end < text_.size() && std::isalpha(static_cast<unsigned char>(text_[end])) != 0)
            ++end;
        return at_ < text_.size() && text_[at_] == '\\' &&
               functions.contains(text_.substr(at_ + 1, end - at_ - 1));
    }

    // Whether an operand comes next, which is neither an operator nor a bracket.
    bool is_operand_next() const
    {
        if (at_ >= text_.size()) return false;
        const char c = text_[at_];
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || is_function_next()) return true;
        if (c != '\\') return c == '{';
        const auto is_next = [&](const auto& words) {
            return std::any_of(words.begin(), words.end(), [&](const auto& word) {
                return text_.compare(at_ + 1, word.first.size(), word.first) == 0;
            });
        };
        return is_next(letters) || starts_with("\\frac") || starts_with("\\tfrac");
    }

    // The next atom with its indices and exponents, to be appended to `row`. The name of a function
    // has a thin space between itself and an operand before or after it.
    std::string next_after(const std::string& row)
    {
        if ((text_[at_] == '-' || text_[at_] == '+') && is_open(row))
            return fmt::format("<mo form=\"prefix\">{}</mo>", text_[at_++] == '-' ? "−" : "+");
        if (!is_function_next()) return with_scripts();
        std::string result(is_open(row) ? "" : thin_space);
        result += with_scripts();
        skip_space();
        if (is_operand_next()) result += thin_space;
        return result;
    }

    std::string with_scripts()
    {
        const std::string base = atom();
        std::string below, above;
        skip_space();
        while (at_ < text_.size() && (text_[at_] == '_' || text_[at_] == '^')) {
            std::string& script = text_[at_++] == '_' ? below : above;
            script = argument();
            skip_space();
        }
        if (below.empty() && above.empty()) return base;
        if (base.starts_with("<munder>") && above.empty()) return element("munder", base + below);
        if (above.empty()) return element("msub", base + below);
        if (below.empty()) return element("msup", base + above);
        return element("msubsup", base + below + above);
    }

    // The argument of a command, an index or an exponent: one digit, or one atom without the
    // indices and exponents that follow it.
    std::string argument()
    {
        skip_space();
        if (at_ >= text_.size()) fail("expected an argument at the end");
        if (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0)
            return element("mn", std::string(1, text_[at_++]));
        return atom();
    }

    std::string atom()
    {
        const char c = text_[at_];
        if (c == '{') {
            ++at_;
            return row("}");
        }
        if (c == '\\') return command();
        if (std::isdigit(static_cast<unsigned char>(c)) != 0) return number();
        ++at_;
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            return element("mi", std::string(1, c));
        if (c == '-') return element("mo", "−");
        std::string whole(1, c); // becomes all bytes of a character that is not ASCII
        while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) & 0xC0) == 0x80)
            whole += text_[at_++];
        return sign(c == '\'' ? "′" : escaped_markup(whole));
    }

    // An operator or a bracket. A bracket is as high as a letter, unless `\left` or `\right` stands
    // before it.
    static std::string sign(const std::string& text)
    {
        const bool is_bracket =
            text == "(" || text == ")" || text == "[" || text == "]" || text == "|";
        if (text == "/") return "<mo lspace=\"0\" rspace=\"0\">/</mo>";
        return fmt::format("<mo{}>{}</mo>", is_bracket ? not_stretched : "", text);
    }

    std::string number()
    {
        const std::size_t start = at_;
        while (at_ < text_.size() &&
               (std::isdigit(static_cast<unsigned char>(text_[at_])) != 0 ||
                (text_[at_] == '.' && at_ + 1 < text_.size() &&
                 std::isdigit(static_cast<unsigned char>(text_[at_ + 1])) != 0)))
            ++at_;
        return element("mn", text_.substr(start, at_ - start));
    }

    std::string name()
    {
        std::size_t end = at_;
        while (end < text_.size() && std::isalpha(static_cast<unsigned char>(text_[end])) != 0)
            ++end;
        if (end == at_) ++end; // a command of one sign, such as \,
        const std::string found = text_.substr(at_, end - at_);
        at_ = end;
        return found;
    }

    // The text in braces, unchanged.
    std::string plain()
    {
        skip_space();
        const std::size_t end = text_.find('}', at_);
        if (at_ >= text_.size() || text_[at_] != '{' || end == std::string::npos)
            fail("expected a text in braces");
        const std::string found = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return found;
    }

    std::string command()
    {
        ++at_;
        const std::string word = name();
        if (const auto i = letters.find(word); i != letters.end())
            return element("mi", std::string(i->second));
        if (const auto i = operators.find(word); i != operators.end())
            return sign(std::string(i->second));
        if (const auto i = bars.find(word); i != bars.end())
            return fmt::format("<mo{} form=\"{}\">{}</mo>", not_stretched, i->second.form,
                               i->second.text);
        if (const auto i = functions.find(word); i != functions.end())
            return element("mi", std::string(i->second));
        if (const auto i = spaces.find(word); i != spaces.end())
            return fmt::format("<mspace width=\"{}\"/>", i->second);
        if (const auto i = accents.find(word); i != accents.end())
            return fmt::format("<mover accent=\"true\">{}<mo>{}</mo></mover>", argument(),
                               i->second);
        return structure(word);
    }

    std::string structure(const std::string& word)
    {
        if (word == "frac" || word == "tfrac" || word == "dfrac") {
            const std::string above = argument();
            return element("mfrac", above + argument());
        }
        if (word == "sqrt") return element("msqrt", argument());
        if (word == "mathrm") {
            const std::string upright = plain();
            if (upright.find_first_of("^_") != std::string::npos)
                fail("expected no index and no exponent in \\mathrm");
            return fmt::format("<mi mathvariant=\"normal\">{}</mi>", escaped_markup(upright));
        }
        if (word == "text") return element("mtext", with_ends(escaped_markup(plain())));
        if (word == "mathrel") return assignment();
        if (word == "left" || word == "right") {
            skip_space();
            std::string bracket = atom(); // is made as high as the formula beside it
            if (const std::size_t found = bracket.find(not_stretched); found != std::string::npos)
                bracket.erase(found, not_stretched.size());
            return bracket;
        }
        if (word == "underbrace") return element("munder", argument() + "<mo>⏟</mo>");
        if (word == "begin") return matrix(plain());
        fail("unknown command \\" + word);
    }

    // A text whose first and last blanks are replaced by spaces that browsers keep.
    static std::string with_ends(std::string text)
    {
        const std::string blank = "\u00A0"; // the no-break space
        if (text.ends_with(' ')) text.replace(text.size() - 1, 1, blank);
        if (text.starts_with(' ')) text.replace(0, 1, blank);
        return text;
    }

    // An operator of two signs, such as +=.
    std::string assignment()
    {
        const std::string first = plain();
        skip_space();
        if (at_ >= text_.size() || text_[at_] != '=') fail("expected = after \\mathrel");
        ++at_;
        return element("mo", first + "=");
    }

    std::string matrix(const std::string& kind)
    {
        if (kind != "pmatrix") fail("unknown environment " + kind);
        const std::string end = "\\end{" + kind + "}";
        const std::size_t stop = text_.find(end, at_);
        if (stop == std::string::npos) fail("expected " + end);
        std::string rows, cells, cell;
        const auto end_cell = [&] {
            cells += element("mtd", Formula(cell).row());
            cell.clear();
        };
        for (; at_ < stop; ++at_) {
            if (text_[at_] == '&') {
                end_cell();
            } else if (starts_with("\\\\")) {
                end_cell();
                rows += element("mtr", cells);
                cells.clear();
                ++at_;
            } else {
                cell += text_[at_];
            }
        }
        end_cell();
        rows += element("mtr", cells);
        at_ = stop + end.size();
        return element("mrow", "<mo>(</mo>" + element("mtable", rows) + "<mo>)</mo>");
    }

    const std::string text_;
    std::size_t at_ = 0;
};

} // namespace

std::string mathml(const std::string& latex, bool is_block)
{
    return fmt::format("<math{}>{}</math>", is_block ? " display=\"block\"" : "",
                       Formula(latex).row());
}

} // namespace rigor::book
