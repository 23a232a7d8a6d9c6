// SPDX-License-Identifier: MIT
// Writes the figures of the handouts: DIR/<handout>/figures/<name>.svg. With --check it writes
// nothing and names each file that differs from what it would write.
#include "figures/figures.hpp"

#include <cstdio>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using rigor::figures::Figure;

fs::path file_of(const fs::path& folder, const Figure& figure)
{
    return folder / figure.handout / "figures" / fmt::format("{}.svg", figure.name);
}

std::string content(const fs::path& file)
{
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// @return whether the file was written
bool write(const fs::path& file, const std::string& text)
{
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    std::ofstream stream(file);
    stream << text;
    stream.close();
    if (!stream) fmt::print(stderr, "--out: cannot write {}\n", file.string());
    return !stream.fail();
}

} // namespace

int main(int count, char** values)
{
    const std::string option = count == 3 ? values[1] : "";
    if (option != "--out" && option != "--check") {
        fmt::print(stderr, "usage: rigor_figures --out DIR, or --check DIR\n");
        return 2;
    }
    int differing = 0, drawn = 0;
    for (const Figure& figure : rigor::figures::all_figures()) {
        const fs::path file = file_of(values[2], figure);
        const std::string text = figure.draw().svg();
        ++drawn;
        if (option == "--out") {
            if (!write(file, text)) return 2;
        } else if (content(file) != text) {
            fmt::print("{}: differs; ./rigor figures --out assignments makes it anew\n",
                       file.string());
            ++differing;
        }
    }
    fmt::print("{} figures\n", drawn);
    return differing == 0 && drawn > 0 ? 0 : 1;
}
