// SPDX-License-Identifier: MIT
// Writes the figures of all handouts, or of one handout: DIR/<handout>/figures/<name>.svg. No file
// is replaced before all figures have been written to temporary files. With --check the program
// writes nothing and names each file that differs from what it would write.
#include "figures/figures.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using rigor::figures::Figure;

struct Drawn {
    fs::path file;
    std::string text;
    fs::path draft() const { return file.string() + ".new"; }
};

std::vector<Drawn> drawn(const fs::path& folder, const std::string& handout)
{
    std::vector<Drawn> all;
    for (const Figure& figure : rigor::figures::all_figures())
        if (handout.empty() || figure.handout == handout)
            all.push_back({folder / figure.handout / "figures" / fmt::format("{}.svg", figure.name),
                           figure.draw().svg()});
    return all;
}

std::string content(const fs::path& file)
{
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// The folders that have to be made for a file, the outermost first.
std::vector<fs::path> missing_folders(const fs::path& file)
{
    std::vector<fs::path> missing;
    for (fs::path folder = file.parent_path(); !folder.empty() && !fs::exists(folder);
         folder = folder.parent_path())
        missing.insert(missing.begin(), folder);
    return missing;
}

// Writes each figure to a draft, a temporary file. When all drafts are on the disk, they are
// renamed.
// @return whether all figures were written; if not, no draft is left behind, and a line says why
bool write(const std::vector<Drawn>& figures)
{
    std::vector<fs::path> made;
    const auto fail = [&](const fs::path& file, const std::string& reason) {
        for (const Drawn& figure : figures)
            std::remove(figure.draft().c_str());
        for (auto folder = made.rbegin(); folder != made.rend(); ++folder)
            std::remove(folder->c_str()); // a folder that is not empty stays
        fmt::print(stderr, "rigor: --out: cannot write {}: {}\n", file.string(), reason);
        return false;
    };
    for (const Drawn& figure : figures) {
        std::error_code error;
        for (const fs::path& folder : missing_folders(figure.file)) {
            if (!fs::create_directory(folder, error)) return fail(folder, error.message());
            made.push_back(folder);
        }
        if (fs::is_directory(figure.file)) return fail(figure.file, "it is a folder");
        std::ofstream stream(figure.draft());
        stream << figure.text;
        stream.close();
        if (!stream) return fail(figure.file, std::strerror(errno));
    }
    for (const Drawn& figure : figures) {
        std::error_code error;
        fs::rename(figure.draft(), figure.file, error);
        if (error) return fail(figure.file, error.message());
    }
    return true;
}

int count_differing(const std::vector<Drawn>& figures)
{
    int differing = 0;
    for (const Drawn& figure : figures) {
        if (content(figure.file) == figure.text) continue;
        fmt::print("{}: differs; ./rigor figures --out assignments makes it anew\n",
                   figure.file.string());
        ++differing;
    }
    return differing;
}

} // namespace

int main(int count, char** values)
{
    const std::string option = count == 3 || count == 4 ? values[1] : "";
    if (option != "--out" && option != "--check") {
        fmt::print(stderr, "usage: rigor_figures --out DIR [HANDOUT], or --check DIR [HANDOUT]\n");
        return 2;
    }
    const std::string handout = count == 4 ? values[3] : "";
    const std::vector<Drawn> figures = drawn(values[2], handout);
    if (figures.empty()) {
        fmt::print(stderr, "rigor: expected a handout with figures, found '{}'\n", handout);
        return 2;
    }
    if (option == "--out" && !write(figures)) return 2;
    const int differing = option == "--check" ? count_differing(figures) : 0;
    fmt::print("{} figures\n", figures.size());
    return differing == 0 ? 0 : 1;
}
