// SPDX-License-Identifier: MIT
// Finds the functions and constants of a source. A declaration ends at a semicolon, or it is a
// function and has a body; declarations in namespaces and structs are visited, those in functions
// are not.
#include "mutants/source.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace rigor::mutants {

namespace {

class Finder {
public:
    explicit Finder(Source& source) : source_(source), tokens_(source.tokens) {}

    // Visits the declarations from token i to token `end`.
    void visit(std::size_t i, std::size_t end, bool is_struct)
    {
        while (i < end) {
            const std::string_view text = tokens_[i].text;
            if (text == "public" || text == "private" || text == "protected")
                i += 2;
            else if (text == ";")
                ++i;
            else
                i = visit_declaration(i, is_struct);
        }
    }

private:
    // Visits the declaration that begins at token `first`. @return the first token after it
    std::size_t visit_declaration(std::size_t first, bool is_struct)
    {
        const std::string_view word = tokens_[first].text;
        const bool is_scope = word == "namespace" || word == "struct" || word == "class";
        std::size_t parameters = 0;
        for (std::size_t i = first; i < tokens_.size(); ++i) {
            const std::string_view text = tokens_[i].text;
            if (text == ";") {
                note_constant(first, i);
                return i + 1;
            }
            if (text == "(" && parameters == 0) parameters = i;
            if (text == "{" && is_scope) {
                const std::size_t close = closing(tokens_, i);
                visit(i + 1, close, word != "namespace");
                return close + 1;
            }
            if (text == "{" && parameters != 0) {
                const std::size_t close = closing(tokens_, i);
                note_function(first, parameters, i, close, is_struct);
                return close + 1;
            }
            if (text == "(" || text == "{") i = closing(tokens_, i);
        }
        throw std::runtime_error("a declaration does not end");
    }

    void note_function(std::size_t first, std::size_t parameters, std::size_t open,
                       std::size_t close, bool is_struct)
    {
        if (tokens_[first].text == "explicit") return; // a constructor
        Function function;
        function.name = tokens_[parameters - 1].text;
        function.declaration = first;
        function.name_token = parameters - 1;
        function.open = open;
        function.close = close;
        function.is_member = is_struct;
        const std::size_t end = closing(tokens_, parameters);
        int templates = 0; // the depth in brackets of templates
        std::size_t begin = parameters + 1;
        for (std::size_t i = parameters + 1; i <= end; ++i) {
            const std::string_view text = tokens_[i].text;
            if (text == "<") ++templates;
            if (text == ">") --templates;
            const bool ends = (text == "," && templates == 0) || i == end;
            if (!ends || i == parameters + 1) continue;
            function.arguments.emplace_back(tokens_[i - 1].text);
            function.types.push_back(source_.between(begin, i - 2));
            begin = i + 1;
        }
        source_.functions.push_back(function);
    }

    void note_constant(std::size_t first, std::size_t end)
    {
        const std::string_view word = tokens_[first].text;
        if ((word != "constexpr" && word != "const") || tokens_[first + 1].text != "double" ||
            tokens_[first + 3].text != "=")
            return;
        source_.constants.push_back({std::string(tokens_[first + 2].text), first, first + 4, end});
    }

    Source& source_;
    const std::vector<Token>& tokens_;
};

} // namespace

void read_source(Source& source, const std::filesystem::path& file)
{
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file.string() + ": cannot be read");
    std::ostringstream text;
    text << in.rdbuf();
    source.text = text.str();
    source.tokens = tokens(source.text);
    Finder(source).visit(0, source.tokens.size(), false);
    if (source.functions.empty()) throw std::runtime_error(file.string() + ": has no function");
}

} // namespace rigor::mutants
