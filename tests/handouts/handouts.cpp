// SPDX-License-Identifier: MIT
// Reads handouts. A formula is scanned letter by letter: a command that is a Greek letter is a
// symbol, other commands are structure; an index belongs to the symbol before it.
#include "handouts/handouts.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace rigor::handouts {

namespace fs = std::filesystem;

namespace {

constexpr std::array greek = {"alpha",  "beta", "gamma", "delta", "epsilon", "varepsilon", "theta",
                              "lambda", "mu",   "nu",    "rho",   "sigma",   "tau",        "phi",
                              "varphi", "psi",  "omega", "Omega", "nabla",   "pi"};
constexpr std::array names = {"mathrm", "text", "begin", "end"}; // their argument is not a formula

template <class List> bool contains(const List& list, const std::string& word)
{
    return std::find(list.begin(), list.end(), word) != list.end();
}

bool is_letter(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

// Reads the parts of a formula from left to right.
class Scanner {
public:
    explicit Scanner(const std::string& formula) : text_(formula) {}

    std::vector<std::string> symbols()
    {
        while (at_ < text_.size())
            next();
        return found_;
    }

private:
    void next()
    {
        const char c = text_[at_];
        if (c == '\\')
            command();
        else if (is_letter(c))
            symbol(text_.substr(at_++, 1));
        else if (c == '^')
            exponent();
        else if (c == '_')
            skip_argument();
        else
            ++at_;
    }

    void command()
    {
        std::size_t end = ++at_;
        while (end < text_.size() && is_letter(text_[end]))
            ++end;
        const std::string name = text_.substr(at_, end - at_);
        at_ = std::max(end, at_ + 1);
        if (contains(names, name))
            argument();
        else if (name == "bar")
            accent_ = "\\bar ";
        else if (name == "Delta")
            symbol("\\Delta " + argument());
        else if (contains(greek, name))
            symbol("\\" + name);
    }

    void symbol(const std::string& letter)
    {
        std::string whole = accent_ + letter;
        accent_.clear();
        if (at_ < text_.size() && text_[at_] == '_') {
            ++at_;
            whole += "_" + argument();
        }
        found_.push_back(whole);
    }

    void exponent()
    {
        ++at_;
        const std::string power = argument();
        static const std::regex no_symbol(R"((T|\\ast|-T|-?\d+|\s)*)");
        if (std::regex_match(power, no_symbol)) return;
        const std::vector<std::string> inner = Scanner(power).symbols();
        found_.insert(found_.end(), inner.begin(), inner.end());
    }

    void skip_argument()
    {
        ++at_;
        argument();
    }

    // What stands in braces, or else one letter or one command.
    std::string argument()
    {
        while (at_ < text_.size() && text_[at_] == ' ')
            ++at_;
        if (at_ >= text_.size()) return "";
        const std::size_t start = at_;
        if (text_[at_] == '\\') {
            ++at_;
            while (at_ < text_.size() && is_letter(text_[at_]))
                ++at_;
            return text_.substr(start, at_ - start);
        }
        if (text_[at_] != '{') return text_.substr(at_++, 1);
        int depth = 0;
        do {
            depth += text_[at_] == '{' ? 1 : text_[at_] == '}' ? -1 : 0;
            ++at_;
        } while (depth > 0 && at_ < text_.size());
        return text_.substr(start + 1, at_ - start - 2);
    }

    const std::string& text_;
    std::size_t at_ = 0;
    std::string accent_;
    std::vector<std::string> found_;
};

} // namespace

fs::path assignments()
{
    return fs::path(RIGOR_SOURCE_DIR) / "assignments";
}

std::string content(const fs::path& file)
{
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("no file " + file.string());
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

bool has_scenes(const Handout& handout)
{
    return fs::exists(assignments() / handout.name / "scenes");
}

std::vector<Handout> all_handouts()
{
    std::vector<Handout> handouts;
    for (const auto& entry : fs::directory_iterator(assignments())) {
        const fs::path file = entry.path() / "README.md";
        const std::string name = entry.path().filename().string();
        if (!fs::exists(file) || name.front() != 'a') continue;
        handouts.push_back({"A" + name.substr(1, name.find('-') - 1), name, content(file)});
    }
    if (handouts.empty()) throw std::runtime_error("no handouts");
    std::sort(handouts.begin(), handouts.end(),
              [](const Handout& a, const Handout& b) { return a.label < b.label; });
    return handouts;
}

std::vector<std::vector<std::string>> table_rows(const std::string& text)
{
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() != '|') continue;
        if (line.find_first_not_of("|-: ") == std::string::npos) continue;
        std::vector<std::string> cells;
        std::istringstream row(line.substr(1));
        for (std::string cell; std::getline(row, cell, '|');) {
            const std::size_t first = cell.find_first_not_of(' ');
            const std::size_t last = cell.find_last_not_of(' ');
            cells.push_back(first == std::string::npos ? "" : cell.substr(first, last + 1 - first));
        }
        rows.push_back(cells);
    }
    return rows;
}

std::vector<std::string> formulas_of(const std::string& text)
{
    std::vector<std::string> formulas;
    std::string block, prose;
    bool in_block = false, is_math = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("```")) {
            if (in_block && is_math) formulas.push_back(block);
            in_block = !in_block;
            is_math = line == "```math";
            block.clear();
        } else {
            (in_block ? block : prose) += line + "\n";
        }
    }
    prose = std::regex_replace(prose, std::regex("`[^`]*`"), "");
    static const std::regex inline_formula(R"(\$([^$]+)\$)");
    for (std::sregex_iterator i(prose.begin(), prose.end(), inline_formula), end; i != end; ++i)
        formulas.push_back((*i)[1]);
    return formulas;
}

std::vector<std::string> symbols_of(const std::string& formula)
{
    return Scanner(formula).symbols();
}

std::string without_index(const std::string& symbol)
{
    return symbol.substr(0, symbol.find('_'));
}

} // namespace rigor::handouts
