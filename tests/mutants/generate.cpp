// SPDX-License-Identifier: MIT
// Writes each function of a source once for each of its mutants, once unchanged, and once as a
// switch between them, which has the function's name. Other functions and the mutants themselves
// call the switch, so that a mutant is wrong wherever it is called.
#include "mutants/generate.hpp"

#include "formulas/table.hpp"
#include "mutants/mutation.hpp"
#include "mutants/wrappers.hpp"

#include <algorithm>
#include <map>

namespace rigor::mutants {

namespace {

// The text in one line, with single spaces and without comments.
std::string in_one_line(std::string_view text)
{
    constexpr std::size_t longest = 200;
    std::string result;
    bool is_comment = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool is_space = c == ' ' || c == '\n';
        is_comment = c != '\n' && (is_comment || text.substr(i, 2) == "//");
        if (is_comment) continue;
        if (!is_space)
            result += c;
        else if (!result.empty() && result.back() != ' ')
            result += ' ';
    }
    if (!result.empty() && result.back() == ' ') result.pop_back();
    if (result.size() > longest) result.replace(longest / 2, result.size() - longest, " ... ");
    return result;
}

class Generator {
public:
    Generator(const Source& source, const std::string& stem, const std::set<int>& without)
        : source_(source), topic_(stem.substr(0, stem.find('_'))), without_(without)
    {
        append("#include \"mutants/wrapped.hpp\"\n");
        append("static const int chosen_mutant = rigor::mutants::chosen_of(\"" + stem + "\");\n");
    }

    Generated run()
    {
        std::size_t at = 0;
        auto function = source_.functions.begin();
        auto constant = source_.constants.begin();
        while (function != source_.functions.end() || constant != source_.constants.end()) {
            const bool is_function = constant == source_.constants.end() ||
                                     (function != source_.functions.end() &&
                                      function->declaration < constant->declaration);
            const std::size_t declaration =
                is_function ? function->declaration : constant->declaration;
            append(source_.text.substr(at, source_.tokens[declaration].begin - at));
            at = source_.tokens[is_function ? function->close : constant->end].end;
            if (is_function)
                write_function(*function++);
            else
                write_constant(*constant++);
        }
        append(source_.text.substr(at));
        return std::move(generated_);
    }

private:
    void append(const std::string& text)
    {
        generated_.text += text;
        line_ += static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    }

    // Notes a mutant, if it is wanted, and appends its text. @return its number, or 0
    int add(const std::string& function, std::string name, const std::string& text)
    {
        const int number = ++last_;
        const int times = ++names_[function + ": " + name];
        if (times > 1) name += " (" + std::to_string(times) + ")";
        if (without_.contains(number)) return 0;
        const std::size_t first = line_;
        append(text);
        generated_.mutants.push_back({number, function, name, first, line_});
        append("\n");
        return number;
    }

    Mutations all_mutations(const Function& function) const
    {
        const Range body = {function.open + 1, function.close};
        Mutations all = changed_variables(source_, function), result;
        for (const auto mutate : {changed_operators, dropped_operands, changed_numbers,
                                  changed_words, changed_statements, changed_starts}) {
            const Mutations some = mutate(source_, body);
            all.insert(all.end(), some.begin(), some.end());
        }
        std::set<std::string> seen;
        const std::string unchanged = source_.between(function.open, function.close);
        for (const Mutation& mutation : all) {
            const std::string text = mutated(mutation, function.open, function.close);
            if (text != unchanged && seen.insert(text).second) result.push_back(mutation);
        }
        return result;
    }

    // The text of the tokens from `first` to `last` with the mutation.
    std::string mutated(const Mutation& mutation, std::size_t first, std::size_t last) const
    {
        const std::size_t begin = source_.tokens[first].begin, end = source_.tokens[last].end;
        return source_.text.substr(begin, mutation.begin - begin) + mutation.replacement +
               source_.text.substr(mutation.end, end - mutation.end);
    }

    std::string name_of(const Mutation& mutation) const
    {
        const std::string& text = source_.text;
        const std::size_t begin = text.rfind('\n', mutation.begin) + 1;
        const std::size_t end = text.find('\n', mutation.end);
        return in_one_line(text.substr(begin, end - begin)) + " => " +
               in_one_line(text.substr(begin, mutation.begin - begin) + mutation.replacement +
                           text.substr(mutation.end, end - mutation.end));
    }

    bool is_formula(const std::string& name) const
    {
        return std::any_of(std::begin(formulas), std::end(formulas), [&](const Formula& formula) {
            return formula.name == name && formula.topic == topic_;
        });
    }

    // The declaration of a function with this name in its place.
    std::string declaration(const Function& function, const std::string& name) const
    {
        return source_.between(function.declaration, function.name_token - 1) + " " + name +
               source_.between(function.name_token + 1, function.open - 1);
    }

    void write_function(const Function& function)
    {
        const bool is_one = is_formula(function.name);
        if (!function.is_member && !is_one) append(declaration(function, function.name) + ";\n");
        const std::string cases = write_mutants(function), original = function.name + "_original";
        append(declaration(function, original) + "\n" +
               source_.between(function.open, function.close) + "\n");
        append(declaration(function, function.name) + "\n{\n    switch (chosen_mutant) {\n" +
               cases);
        if (is_one)
            for (const Wrapper& wrapper : wrappers(source_, function, original))
                add(function.name, wrapper.name, next_case(wrapper.call));
        append("    default: return " + call(function, original) + ";\n    }\n}\n");
    }

    // Writes the function with each of its mutations. @return the cases of the switch
    std::string write_mutants(const Function& function)
    {
        std::string cases;
        for (const Mutation& mutation : all_mutations(function)) {
            const std::string name = function.name + "_mutant_" + std::to_string(last_ + 1);
            const std::string its_case = next_case(call(function, name)) + "\n";
            const int number = add(function.name, name_of(mutation),
                                   declaration(function, name) + "\n" +
                                       mutated(mutation, function.open, function.close));
            if (number != 0) cases += its_case;
        }
        return cases;
    }

    static std::string call(const Function& function, const std::string& name)
    {
        std::string arguments;
        for (const std::string& argument : function.arguments)
            arguments += (arguments.empty() ? "" : ", ") + argument;
        return name + "(" + arguments + ")";
    }

    // The case of the switch for the next mutant.
    std::string next_case(const std::string& result) const
    {
        return "    case " + std::to_string(last_ + 1) + ": return " + result + ";";
    }

    void write_constant(const Constant& constant)
    {
        append("static double " + constant.name +
               "_of_mutant()\n{\n    switch (chosen_mutant) {\n");
        for (const auto mutate : {changed_operators, changed_numbers, changed_words})
            for (const Mutation& mutation : mutate(source_, {constant.value, constant.end}))
                add(constant.name, name_of(mutation),
                    next_case(mutated(mutation, constant.value, constant.end - 1)));
        append("    default: return " + source_.between(constant.value, constant.end - 1) +
               ";\n    }\n}\n#define " + constant.name + " " + constant.name + "_of_mutant()\n");
    }

    const Source& source_;
    const std::string topic_;
    const std::set<int>& without_;
    Generated generated_;
    std::map<std::string, int> names_; // how often a name was given
    std::size_t line_ = 1;             // the line that is written next
    int last_ = 0;                     // the last number given
};

} // namespace

Generated generate(const Source& source, const std::string& stem, const std::set<int>& without)
{
    return Generator(source, stem, without).run();
}

} // namespace rigor::mutants
