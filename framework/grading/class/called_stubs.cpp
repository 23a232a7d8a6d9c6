// SPDX-License-Identifier: MIT
#include "grading/class/called_stubs.hpp"

#include "grading/topics.hpp"

#include <algorithm>
#include <fstream>
#include <set>

namespace rigor {

namespace fs = std::filesystem;

namespace {

std::string source_text(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The text of all files of a topic in reference/, such as `fracture.cpp` and `fracture_mesh.hpp`.
std::string reference_text(const fs::path& source, const std::string& topic)
{
    std::string text;
    std::error_code error;
    for (fs::directory_iterator entry(source / "reference", error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.substr(0, name.find_first_of("_.")) == topic) text += source_text(entry->path());
    }
    return text;
}

// Adds to `called` the topics that a topic calls, and in turn those that these topics call.
void add_called(const fs::path& source, const std::string& topic, std::set<std::string>& called)
{
    const std::string text = reference_text(source, topic);
    for (const std::string& other : topics())
        if (text.find("#include \"formulas/" + other + ".hpp\"") != std::string::npos &&
            called.insert(other).second)
            add_called(source, other, called);
}

bool is_stub(const fs::path& source, const std::string& topic)
{
    return source_text(source / "student" / (topic + ".cpp"))
               .find("throw NotImplemented(\"" + topic + "::") != std::string::npos;
}

} // namespace

std::vector<std::string> called_stubs(const fs::path& source, const std::string& topic)
{
    std::set<std::string> called = {topic};
    add_called(source, topic, called);
    std::vector<std::string> found;
    for (const std::string& other : topics())
        if (other != topic && called.count(other) > 0 && is_stub(source, other))
            found.push_back(other);
    return found;
}

} // namespace rigor
