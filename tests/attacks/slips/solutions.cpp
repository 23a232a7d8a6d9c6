// SPDX-License-Identifier: MIT
#include "solutions.hpp"

#include <fstream>

namespace rigor::slips {

namespace fs = std::filesystem;

std::string solution(const std::string& topic)
{
    std::ifstream file(fs::path(RIGOR_SOURCE_DIR) / "reference" / (topic + ".cpp"));
    return {std::istreambuf_iterator<char>(file), {}};
}

void copy_headers(const fs::path& folder)
{
    for (const auto& entry : fs::directory_iterator(fs::path(RIGOR_SOURCE_DIR) / "reference"))
        if (entry.path().extension() == ".hpp")
            fs::copy_file(entry.path(), folder / entry.path().filename(),
                          fs::copy_options::overwrite_existing);
}

std::string whole_solution_beside(const std::string& topic, const std::string& formula,
                                  const std::string& definition)
{
    std::string all;
    for (const auto& entry : fs::directory_iterator(fs::path(RIGOR_SOURCE_DIR) / "reference")) {
        const std::string name = entry.path().filename();
        if (!name.starts_with(topic) || !name.ends_with(".cpp")) continue;
        std::ifstream file(entry.path());
        all.append(std::istreambuf_iterator<char>(file), {});
    }
    const std::string right = "right_" + formula;
    return "#include \"formulas/" + topic + ".hpp\"\nnamespace rigor {\ndecltype(" + formula +
           ") " + right + ";\n}\n#define " + formula + " " + right + "\n" + all + "#undef " +
           formula + "\n" + definition;
}

std::string solution_beside(const Place& place, const std::string& definition)
{
    const std::string right = "right_" + place.name;
    return "#include \"formulas/" + place.topic +
           ".hpp\"\n#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n#include <vector>\n"
           "namespace rigor {\n" +
           place.result + " " + right + "(" + place.parameters + ");\n}\n#define " + place.name +
           " " + right + "\n" + solution(place.topic) + "#undef " + place.name + "\n" + definition;
}

} // namespace rigor::slips
