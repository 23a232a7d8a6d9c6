// SPDX-License-Identifier: MIT
// What `book` and `hint` do where a folder, a file or a program is not as it should be.
#include "framework/cli/command.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>

using namespace rigor;
using namespace rigor::testing;

namespace fs = std::filesystem;

namespace {

// Runs `rigor book --out OUT` where the only programs are those of one folder.
Run book(const fs::path& out, const fs::path& programs)
{
    Command command;
    command.environment = {"PATH=" + programs.string()};
    command.arguments = {std::string(RIGOR_BINARY_DIR) + "/bin/rigor", "book", "--out",
                         out.string()};
    return run_command(command);
}

// A folder with a program `chromium` that runs this shell script.
fs::path with_chromium(const fs::path& folder, const std::string& script)
{
    fs::create_directories(folder);
    const fs::path file = folder / "chromium";
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    fs::permissions(file, fs::perms::owner_all);
    return folder;
}

std::set<std::string> names_in(const fs::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

std::ptrdiff_t lines_in(const std::string& text)
{
    return std::count(text.begin(), text.end(), '\n');
}

using Names = std::set<std::string>;

// A script in place of Chromium, which writes the address of the page into the PDF.
const char* const prints = R"(for a; do case "$a" in --print-to-pdf=*) to="${a#*=}" ;; esac; done
echo "$a" > "$to")";

} // namespace

TEST_CASE("book: without a Chromium there is a page and no PDF", "[cli]")
{
    const TemporaryFolder folder;
    const fs::path out = folder.path() / "out", programs = folder.path() / "none";
    fs::create_directories(programs);
    const Run made = book(out, programs);
    CHECK(made.status == 0);
    CHECK(made.output.find("apt install chromium") != std::string::npos);
    CHECK(names_in(out) == Names{"book.html"});
}

TEST_CASE("book: a Chromium that fails leaves the page and nothing else", "[cli]")
{
    const TemporaryFolder folder;
    for (const char* script : {"echo first; echo no display; exit 1", "exit 0", "kill -9 $$"}) {
        CAPTURE(script);
        const fs::path out = folder.path() / "out";
        const Run made = book(out, with_chromium(folder.path() / "programs", script));
        CHECK(made.status == 2);
        CHECK(made.output.find("expected a PDF from chromium") != std::string::npos);
        CHECK(lines_in(made.output) == 2);                     // the page, and what is wrong
        CHECK(made.output.find("first") == std::string::npos); // only the last line is shown
        CHECK(names_in(out) == Names{"book.html"});
    }
}

TEST_CASE("book: a folder whose name has marks of an address gets the PDF", "[cli]")
{
    const TemporaryFolder folder;
    const fs::path out = folder.path() / "part #1 at 100%";
    const Run made = book(out, with_chromium(folder.path() / "programs", prints));
    CHECK(made.status == 0);
    CHECK(names_in(out) == Names{"book.html", "book.pdf"});
    std::ifstream pdf(out / "book.pdf");
    std::string address;
    std::getline(pdf, address);
    CHECK(address.ends_with("/part%20%231%20at%20100%25/book.pdf.html"));
}

TEST_CASE("book: what stands in its way is an error of one line", "[cli]")
{
    const TemporaryFolder folder;
    const fs::path programs = with_chromium(folder.path() / "programs", prints);
    for (const char* taken : {"book.html", "book.pdf"}) {
        CAPTURE(taken);
        const fs::path out = folder.path() / taken;
        fs::create_directories(out / taken); // a folder in the place of the file
        const Run made = book(out, programs);
        CHECK(made.status == 2);
        CHECK(made.output.find("cannot be written") != std::string::npos);
        CHECK(lines_in(made.output) <= 2);
        CHECK(names_in(out) == Names{"book.html", taken});
    }
    for (const std::string& out : {std::string("/proc/book"), std::string("/dev/null/book"),
                                   "/tmp/" + std::string(300, 'x')}) {
        CAPTURE(out);
        const Run made = book(out, programs);
        CHECK(made.status == 2);
        CHECK(lines_in(made.output) == 1);
        CHECK(made.output.find("--out: expected a folder") != std::string::npos);
    }
}

TEST_CASE("hint: whatever the file that counts them holds, a hint is given", "[cli]")
{
    const fs::path memory = fs::path(RIGOR_BINARY_DIR) / "hints" / "A2.17";
    fs::create_directories(memory.parent_path());
    for (const char* count : {"", "-1", "x", "7", "99999999999999999999999", "2"}) {
        CAPTURE(count);
        std::ofstream(memory) << count;
        const Run given = rigor::testing::rigor({"hint", "A2.17"});
        CHECK(given.status == 0);
        CHECK(given.output.find("A2.17 bounding_box_mass_properties: hint ") == 0);
    }
    // There is a folder in place of the file: the hint is given, and one line says that it is not
    // remembered.
    fs::remove(memory);
    fs::create_directory(memory);
    const Run given = rigor::testing::rigor({"hint", "A2.17"});
    CHECK(given.status == 0);
    CHECK(given.output.find("hint 1 of 3") != std::string::npos);
    CHECK(given.output.find("ask with --step for the next hint") != std::string::npos);
    fs::remove_all(memory);
}
