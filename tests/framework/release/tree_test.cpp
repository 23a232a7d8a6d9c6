// SPDX-License-Identifier: MIT
// What is in the students' tree and what is not. Three lines of code in a row that a left-out file
// has too count as a leak. Single lines do not: a loop over bodies, for example, is in many files.
#include "release/tree.hpp"

#include "errors/input_error.hpp"
#include "grading/process.hpp"
#include "release/withheld.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

namespace rigor::testing {

namespace {

namespace fs = std::filesystem;

const ReleasedTree& students()
{
    static const ReleasedTree tree = students_tree(RIGOR_SOURCE_DIR);
    return tree;
}

bool has(const ReleasedTree& tree, const std::string& path)
{
    return std::any_of(tree.begin(), tree.end(),
                       [&](const ReleasedFile& file) { return file.path == path; });
}

std::string content_of(const fs::path& file)
{
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// The lines of code without spaces, comments and what every file has.
std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        line = line.substr(0, line.find("//"));
        std::erase_if(line, [](unsigned char c) { return std::isspace(c); });
        const bool is_common = line.size() < 3 || line.starts_with("#") ||
                               line.starts_with("namespace") || line.starts_with("using");
        if (!is_common) lines.push_back(line);
    }
    return lines;
}

// A passage has this many lines and at least this many characters; shorter ones are in many files.
constexpr std::size_t in_a_row = 3, least_length = 60;

std::set<std::string> passages_of(const std::string& text)
{
    const std::vector<std::string> lines = lines_of(text);
    std::set<std::string> passages;
    for (std::size_t i = 0; i + in_a_row <= lines.size(); ++i) {
        std::string passage;
        for (std::size_t k = i; k < i + in_a_row; ++k)
            passage += lines[k];
        if (passage.size() >= least_length) passages.insert(passage);
    }
    return passages;
}

// The passages of all files that must not be handed out, each with a file that has it.
std::map<std::string, std::string> secret_passages()
{
    std::map<std::string, std::string> secrets;
    const auto add = [&](const fs::path& file) {
        const std::string path = file.lexically_relative(RIGOR_SOURCE_DIR).string();
        for (const std::string& passage : passages_of(content_of(file)))
            secrets.try_emplace(passage, path);
    };
    // Attacks quote the framework, so their passages are no secret. None of them is handed out.
    for (const char* folder : {"reference", "tests/graded/hidden", "tests/alternatives",
                               "tests/mistakes", "tests/samples"})
        for (const auto& entry :
             fs::recursive_directory_iterator(fs::path(RIGOR_SOURCE_DIR) / folder))
            if (const auto ending = entry.path().extension(); ending == ".cpp" || ending == ".hpp")
                add(entry.path());
    for (const JudgedFile& file : judged_files())
        if (!file.replacement.empty()) add(fs::path(RIGOR_SOURCE_DIR) / file.path);
    // Stubs and headers are public, so what a solution has from them is no secret.
    for (const ReleasedFile& file : students())
        if (file.path.starts_with("student/") || file.path.starts_with("framework/formulas/") ||
            !replacement_of(file.path).empty())
            for (const std::string& passage : passages_of(file.content))
                secrets.erase(passage);
    return secrets;
}

bool tells_on_purpose(const std::string& path)
{
    return std::any_of(telling_tests().begin(), telling_tests().end(),
                       [&](const JudgedFile& file) { return file.path == path; });
}

} // namespace

TEST_CASE("release: the students' tree has what students need and nothing else", "[release]")
{
    for (const char* path :
         {"README.md", "rigor", "student/collision.cpp", "framework/formulas/collision.hpp",
          "assignments/a4-collision/README.md", "assignments/a4-collision/hints.md",
          "tests/graded/collision/collision_test.cpp", "tests/support/close.cpp"})
        CHECK(has(students(), path));
    for (const ReleasedFile& file : students()) {
        CAPTURE(file.path);
        for (const char* folder :
             {"reference/", "tests/graded/hidden/", "tests/mistakes/", "tests/alternatives/",
              "tests/attacks/", "tests/samples/", "tests/framework/", "tests/handouts/", ".git/"})
            CHECK(!file.path.starts_with(folder));
        for (const char* page : {"instructor.md", "grading.md", "course.md"})
            CHECK(file.path != std::string("assignments/") + page);
        CHECK(file.is_executable == (file.path == "rigor"));
    }
    CHECK(std::is_sorted(students().begin(), students().end(),
                         [](const auto& a, const auto& b) { return a.path < b.path; }));
}

TEST_CASE("release: no passage of what is left out is in the students' tree", "[release]")
{
    const std::map<std::string, std::string> secrets = secret_passages();
    REQUIRE(secrets.size() > 3000); // without passages, the search would find nothing
    for (const ReleasedFile& file : students()) {
        if (tells_on_purpose(file.path)) continue;
        for (const std::string& passage : passages_of(file.content)) {
            const auto secret = secrets.find(passage);
            if (secret == secrets.end()) continue;
            FAIL_CHECK(file.path << " and " << secret->second << " have: " << passage);
        }
    }
}

TEST_CASE("release: no name of a hidden test is in the students' tree but for parts of points",
          "[release]")
{
    std::set<std::string> names;
    for (const auto& entry :
         fs::directory_iterator(fs::path(RIGOR_SOURCE_DIR) / "tests/graded/hidden")) {
        const std::string text = content_of(entry.path()), head = "TEST_CASE(\"";
        for (std::size_t at = 0; (at = text.find(head, at)) != std::string::npos;) {
            at += head.size();
            names.insert(text.substr(at, text.find('"', at) - at));
        }
    }
    REQUIRE(names.size() > 20);
    for (const ReleasedFile& file : students()) {
        // Where a law of a hidden task earns a part of the points, assignment.json names this law.
        if (file.path.ends_with("/assignment.json")) continue;
        for (const std::string& name : names) {
            CAPTURE(file.path, name);
            REQUIRE(file.content.find(name) == std::string::npos);
        }
    }
}

TEST_CASE("release: every judged file is there and has a reason", "[release]")
{
    for (const JudgedFile& file : judged_files()) {
        CAPTURE(file.path);
        CHECK(fs::exists(fs::path(RIGOR_SOURCE_DIR) / file.path));
        CHECK(file.why.starts_with(file.replacement.empty() ? "kept: " : "replaced: "));
    }
    for (const JudgedFile& file : telling_tests()) {
        CAPTURE(file.path);
        CHECK(has(students(), std::string(file.path)));
    }
}

TEST_CASE("release: links in the pages of the students' tree lead somewhere", "[release]")
{
    int links = 0;
    for (const ReleasedFile& file : students()) {
        if (!file.path.ends_with(".md")) continue;
        for (std::size_t at = 0; (at = file.content.find("](", at)) != std::string::npos;) {
            at += 2;
            std::string target = file.content.substr(at, file.content.find(')', at) - at);
            target = target.substr(0, target.find('#'));
            if (target.empty() || target.find(':') != std::string::npos) continue;
            const fs::path path = fs::path(file.path).parent_path() / target;
            CAPTURE(file.path, target);
            CHECK(has(students(), path.lexically_normal().generic_string()));
            ++links;
        }
    }
    CHECK(links > 10);
}

TEST_CASE("release: a solved formula in student/ is not handed out", "[release]")
{
    const TemporaryFolder tree;
    for (const ReleasedFile& file : students())
        tree.write(file.path, file.content);
    for (const JudgedFile& file : judged_files())
        if (!file.replacement.empty()) tree.write(std::string(file.replacement), "// replaced\n");
    CHECK(students_tree(tree.path()).size() + 1 == students().size()); // all but README.md
    tree.write("student/pipeline.cpp",
               content_of(fs::path(RIGOR_SOURCE_DIR) / "reference/pipeline.cpp"));
    std::string message;
    try {
        students_tree(tree.path());
    } catch (const InputError& error) {
        message = error.what();
    }
    CHECK(message.find("student/pipeline.cpp: expected the untouched stub of A0.1") == 0);
}

// A folder of tests that the build needs and the tree lacks is found here within seconds, and not
// only when somebody releases.
TEST_CASE("release: both trees have all that their build needs", "[release]")
{
    for (const ReleasedTree& tree : {students(), grading_tree(RIGOR_SOURCE_DIR)}) {
        const TemporaryFolder folder;
        write_tree(tree, folder.path());
        Command command;
        command.arguments = {"cmake", "--preset", "release"};
        command.folder = folder.path();
        std::string output;
        const Ended ended =
            run(command, [&](std::string_view line) { output += std::string(line) + "\n"; });
        CAPTURE(output);
        CHECK(ended.ok());
    }
}

} // namespace rigor::testing
