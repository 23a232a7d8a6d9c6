// SPDX-License-Identifier: MIT
#include "class/made_class.hpp"

#include "attacks/slips/slips.hpp"
#include "formulas/table.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <stdexcept>

namespace rigor::testing {

namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error(file.string() + ": expected a file");
    return {std::istreambuf_iterator<char>(in), {}};
}

// A source with the text of each header of the mistakes in place of its `#include`, since a
// submission cannot include such a header.
std::string in_one_file(const fs::path& source, const std::string& text)
{
    std::istringstream lines(text);
    std::string all;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("#include \"mistakes/"))
            all += in_one_file(source,
                               content_of(source / "tests" / line.substr(10, line.size() - 11)));
        else if (line != "#pragma once")
            all += line + '\n';
    return all;
}

// The sources below a folder, in the order of their names.
std::vector<fs::path> sources_in(const fs::path& folder)
{
    std::set<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::recursive_directory_iterator(folder, error))
        if (entry.path().extension() == ".cpp") files.insert(entry.path());
    return {files.begin(), files.end()};
}

// Whether a source defines a function: a line that is not indented has its name.
bool defines(const std::string& text, const std::string& name)
{
    for (std::size_t at = text.find(" " + name + "("); at != std::string::npos;
         at = text.find(" " + name + "(", at + 1)) {
        const std::size_t line = text.rfind('\n', at) + 1; // 0 in the first line
        if (std::isalpha(static_cast<unsigned char>(text[line])) != 0) return true;
    }
    return false;
}

// The formulas of a topic that a source defines.
std::vector<std::string> formulas_in(const std::string& text, const std::string& topic)
{
    std::vector<std::string> names;
    for (const Formula& formula : formulas)
        if (formula.topic == topic && defines(text, std::string(formula.name)))
            names.emplace_back(formula.name);
    return names;
}

// The texts of each kind that a class is drawn from.
class Pool {
public:
    Pool(const fs::path& source, const std::string& topic) : topic_(topic)
    {
        const std::string file = topic + ".cpp";
        reference_ = content_of(source / "reference" / file);
        stub_ = content_of(source / "student" / file);
        right_ = {reference_};
        for (const fs::path& path : sources_in(source / "tests/alternatives"))
            if (path.filename().string().starts_with(topic)) right_.push_back(instead(path));
        for (const fs::path& path : sources_in(source / "tests/mistakes" / topic))
            mistakes_.push_back(with_other_formulas(reference_, topic,
                                                    {path.parent_path().filename().string()},
                                                    in_one_file(source, content_of(path))));
        for (const fs::path& path : sources_in(source / "tests/attacks"))
            if (!formulas_in(content_of(path), topic).empty() &&
                path.parent_path().filename() != "slips")
                attacks_.push_back(instead(path));
        for (const slips::Place& place : slips::places_of_slips())
            if (place.topic == topic)
                for (const slips::Slip& slip : slips::all_slips())
                    slips_.push_back(slipped(slip, place));
    }

    ClassMember draw(std::mt19937& random) const
    {
        const std::uint_fast32_t per_cent = random() % 100;
        if (per_cent < 50) return {"", "mistake", one_of(mistakes_, random)};
        if (per_cent < 75) return {"", "right", one_of(right_, random)};
        if (per_cent < 85) return {"", "slip", one_of(slips_, random)};
        if (per_cent < 93) return {"", "stub", stub_};
        if (per_cent < 97) return {"", "attack", one_of(attacks_, random)};
        return {"", "nothing", ""};
    }

private:
    std::string instead(const fs::path& path) const
    {
        const std::string text = content_of(path);
        return with_other_formulas(reference_, topic_, formulas_in(text, topic_), text);
    }

    std::string slipped(const slips::Slip& slip, const slips::Place& place) const
    {
        if (slip.file) return slip.file(reference_);
        return "#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n#include <vector>\n" +
               with_other_formulas(reference_, topic_, {place.name}, slip.definition(place));
    }

    const std::string& one_of(const std::vector<std::string>& texts, std::mt19937& random) const
    {
        return texts.empty() ? stub_ : texts[random() % texts.size()];
    }

    std::string topic_, reference_, stub_;
    std::vector<std::string> right_, mistakes_, slips_, attacks_;
};

std::string name_of(int number)
{
    const std::string digits = std::to_string(number);
    return "s" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

} // namespace

std::string renamed(const std::string& text, const std::string& name, const std::string& to)
{
    const auto is_letter = [&](std::size_t i) {
        return i < text.size() &&
               (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
    };
    const auto is_member = [&](std::size_t at) {
        return (at > 0 && text[at - 1] == '.') || (at > 1 && text.compare(at - 2, 2, "->") == 0);
    };
    std::string result;
    std::size_t done = 0;
    for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
        if (is_letter(at - 1) || is_letter(at + name.size()) || is_member(at)) continue;
        result += text.substr(done, at - done) + to;
        done = at + name.size();
    }
    return result + text.substr(done);
}

std::string with_other_formulas(const std::string& text, const std::string& topic,
                                const std::vector<std::string>& names,
                                const std::string& definitions)
{
    std::string before = "#include \"formulas/" + topic + ".hpp\"\n", own = text;
    for (const std::string& name : names) {
        before += "namespace rigor {\ndecltype(" + name + ") right_" + name + ";\n}\n";
        own = renamed(own, name, "right_" + name);
    }
    return before + own + definitions;
}

std::vector<ClassMember> made_class(const fs::path& source, const std::string& topic, int count,
                                    unsigned seed)
{
    const Pool pool(source, topic);
    std::mt19937 random(seed);
    std::vector<ClassMember> members;
    for (int i = 0; i < count; ++i) {
        ClassMember member = pool.draw(random);
        member.name = name_of(i);
        if (member.kind != "nothing") member.text += "\n// " + member.name + "\n";
        members.push_back(std::move(member));
    }
    return members;
}

std::vector<ClassMember> empty_class(int count)
{
    std::vector<ClassMember> members;
    for (int i = 0; i < count; ++i)
        members.push_back({name_of(i), "nothing", ""});
    return members;
}

void write_class(const std::vector<ClassMember>& members, const std::string& topic,
                 const fs::path& folder)
{
    for (const ClassMember& member : members) {
        fs::create_directories(folder / member.name);
        const bool has_file = member.kind != "nothing";
        std::ofstream(folder / member.name / (has_file ? topic + ".cpp" : "letter.txt"),
                      std::ios::binary)
            << (has_file ? member.text : "I was ill. " + member.name + "\n");
    }
}

} // namespace rigor::testing
