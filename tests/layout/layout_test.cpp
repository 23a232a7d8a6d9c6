// SPDX-License-Identifier: MIT
// Each rule finds a violation in a small tree and names its place.
#include "support/catch.hpp"

#include "layout/comments.hpp"
#include "layout/layout.hpp"

#include <cstdlib>
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;

using namespace rigor::layout;

const std::string licence = "// SPDX-License-Identifier: MIT\n";
const std::string header = licence + "#pragma once\n";

// A tree in a temporary folder, without a violation until a test writes one.
class Tree {
public:
    Tree()
    {
        std::string name = (fs::temp_directory_path() / "layout_XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        top_ = name;
        write("README.md", "A tree.\n");
        write("framework/room/body.hpp", header);
        write("framework/room/body.cpp", licence + "#include \"room/body.hpp\"\n");
    }
    Tree(const Tree&) = delete;
    Tree& operator=(const Tree&) = delete;
    ~Tree() { fs::remove_all(top_); }

    void write(const fs::path& path, const std::string& text) const
    {
        fs::create_directories((top_ / path).parent_path());
        std::ofstream(top_ / path) << text;
    }

    const fs::path& top() const { return top_; }

    /// `place: rule` for each violation, one on each line.
    std::string violations() const
    {
        std::string text;
        for (const Violation& violation : check_tree(top_))
            text += violation.place + ": " + violation.rule + "\n";
        return text;
    }

private:
    fs::path top_;
};

std::string columns(std::size_t count)
{
    std::string text;
    while (text.size() < count)
        text += "word ";
    return text.substr(0, count - 1) + "x";
}

const std::string wide = ": a comment or text of 101 columns; the limit is 100\n";

} // namespace

TEST_CASE("layout: a graded test says in words what it expects", "[layout]")
{
    const Tree tree;
    const std::string bare = licence + "void f()\n{\n    REQUIRE(x == 8);\n}\n";
    tree.write("tests/graded/inertia/inertia_test.cpp", bare);
    CHECK(tree.violations().starts_with("tests/graded/inertia/inertia_test.cpp:4: a failure shows "
                                        "a student the code of the test"));
    tree.write("tests/graded/inertia/inertia_test.cpp",
               licence + "    REQUIRE_THAT(x, IsExactly(8));\n");
    tree.write("tests/framework/rigid/step_test.cpp", bare); // no student reads its failures
    CHECK(tree.violations().empty());
}

TEST_CASE("layout: a tree that keeps the rules has no violation", "[layout]")
{
    const Tree tree;
    CHECK(tree.violations().empty());
}

TEST_CASE("layout: a tree without sources or without texts is refused", "[layout]")
{
    const Tree tree;
    fs::remove_all(tree.top() / "framework");
    CHECK(tree.violations() == tree.top().string() + ": no sources found\n");
    fs::remove(tree.top() / "README.md");
    CHECK(tree.violations() == tree.top().string() + ": no sources found\n" + tree.top().string() +
                                   ": no Markdown found\n");
}

TEST_CASE("layout: a folder holds 25 files and not 26", "[layout]")
{
    const Tree tree;
    for (int i = 0; i < 25; ++i)
        tree.write("tests/mistakes/m" + std::to_string(i) + ".cpp", licence);
    CHECK(tree.violations().empty());
    tree.write("tests/mistakes/one_more.hpp", header);
    CHECK(tree.violations() ==
          "tests/mistakes/: 26 sources and headers in one folder; the limit is 25\n");
}

TEST_CASE("layout: two modules that include each other are refused also through a source",
          "[layout]")
{
    const Tree tree;
    tree.write("framework/room/world.hpp", header + "#include \"room/body.hpp\"\n");
    CHECK(tree.violations().empty());
    tree.write("framework/room/body.cpp", licence + "#include \"room/world.hpp\"\n");
    CHECK(tree.violations() == "framework/room/body: includes itself through "
                               "framework/room/world\n");
}

TEST_CASE("layout: a cycle of three modules is refused once", "[layout]")
{
    const Tree tree;
    tree.write("tests/a.hpp", header + "#include \"support/b.hpp\"\n");
    tree.write("tests/support/b.hpp", header + "#include \"c.hpp\"\n");
    tree.write("tests/support/c.hpp", header + "  #  include \"a.hpp\" // from the top\n");
    CHECK(tree.violations() == "tests/a: includes itself through tests/support/b, "
                               "tests/support/c\n");
}

TEST_CASE("layout: a source of the framework needs a header of its name or a main", "[layout]")
{
    const Tree tree;
    tree.write("tests/room/body_test.cpp", licence);
    tree.write("framework/room/run.cpp", licence + "int main()\n{\n}\n");
    tree.write("framework/room/main/module.cpp", licence);
    CHECK(tree.violations().empty());
    tree.write("framework/room/mass.cpp", licence);
    tree.write("framework/other/mass.hpp", header);
    CHECK(tree.violations() ==
          "framework/room/mass.cpp: a source of the framework without a header of its name\n");
}

TEST_CASE("layout: a test lies in the folder that mirrors the source of its name", "[layout]")
{
    const Tree tree;
    tree.write("framework/other/body.hpp", header);
    tree.write("framework/other/mass.hpp", header);
    tree.write("tests/framework/room/body_test.cpp", licence);
    tree.write("tests/framework/room/several_sources_test.cpp", licence);
    tree.write("tests/framework/room/mass.hpp", header); // no test
    tree.write("tests/graded/room/mass_test.cpp", licence);
    CHECK(tree.violations().empty());
    tree.write("tests/framework/room/mass_test.cpp", licence);
    tree.write("tests/framework/mass_test.cpp", licence);
    const std::string rule = ": a test with the name of framework/other/mass belongs in "
                             "tests/framework/other/\n";
    CHECK(tree.violations() ==
          "tests/framework/mass_test.cpp" + rule + "tests/framework/room/mass_test.cpp" + rule);
}

TEST_CASE("layout: a comment has 100 characters and not 101", "[layout]")
{
    const Tree tree;
    const std::string omegas = "// ωωωωω";
    tree.write("student/a.cpp", licence + omegas + columns(92) + "\n");
    CHECK(tree.violations().empty());
    tree.write("student/a.cpp", licence + omegas + columns(93) + "\nint b; // " + columns(91));
    CHECK(tree.violations() == "student/a.cpp:2" + wide + "student/a.cpp:3" + wide);
}

TEST_CASE("layout: two slashes in a string begin no comment", "[layout]")
{
    const std::vector<std::string> lines = {R"(f("http://a", '"', '\'', "\"//"); // one)",
                                            R"(int n = 1'000; // two)",
                                            "text = R\"x( // no",
                                            ")\" // no",
                                            ")x\"; // three",
                                            "/// four"};
    const std::vector<Comment> found = comments(lines);
    REQUIRE(found.size() == 4);
    CHECK(found[0].text == "one");
    CHECK(found[1].text == "two");
    CHECK(found[2].line == 5);
    CHECK(found[2].is_trailing);
    CHECK(found[3].text == "four");
    CHECK_FALSE(found[3].is_trailing);
}

TEST_CASE("layout: a comment of a script is as wide as that of a source", "[layout]")
{
    const Tree tree;
    for (const char* file : {"rigor", "tests/CMakeLists.txt", "tests/a.sh"})
        tree.write(file, "# " + columns(98) + "\n" + columns(120) + "\n");
    CHECK(tree.violations().empty());
    for (const char* file : {"rigor", "tests/CMakeLists.txt", "tests/a.sh"})
        tree.write(file, "  # " + columns(97) + "\n");
    CHECK(tree.violations() ==
          "rigor:1" + wide + "tests/CMakeLists.txt:1" + wide + "tests/a.sh:1" + wide);
}

TEST_CASE("layout: prose is wrapped but tables and code and unbroken links are not", "[layout]")
{
    const Tree tree;
    const std::string link = "- [" + columns(90) + "](https://example.org/page).\n";
    tree.write("guide/a.md", "| " + columns(120) + " |\n```\n" + columns(120) + "\n```\n" + link +
                                 std::string(120, 'x') + "\n");
    CHECK(tree.violations().empty());
    tree.write("guide/a.md", "```\n```\n" + columns(101) + "\n");
    CHECK(tree.violations() == "guide/a.md:3" + wide);
}

TEST_CASE("layout: builds and hidden folders are no part of the tree", "[layout]")
{
    const Tree tree;
    for (const char* folder : {"build", "out", ".git"})
        tree.write(fs::path(folder) / "a.md", columns(101) + "\n");
    CHECK(tree.violations().empty());
}

TEST_CASE("layout: no line of a comment begins with of", "[layout]")
{
    const Tree tree;
    tree.write("reference/a.cpp", licence + "// offsets of a\nint offset; // offset\n");
    CHECK(tree.violations().empty());
    tree.write("reference/a.cpp", licence + "int a; // of a thing\nint b; ///< of another\n"
                                            "// The length\n// of a line.\n");
    const std::string rule = ": a comment line that begins with \"of\": say what it is, or break "
                             "the line elsewhere\n";
    CHECK(tree.violations() ==
          "reference/a.cpp:2" + rule + "reference/a.cpp:3" + rule + "reference/a.cpp:5" + rule);
}

TEST_CASE("layout: the licence line and pragma once are needed", "[layout]")
{
    const Tree tree;
    tree.write("student/a.cpp", "int a;\n");
    tree.write("framework/room/mass.hpp", licence);
    CHECK(tree.violations() ==
          "framework/room/mass.hpp: a header without #pragma once\n"
          "student/a.cpp: the first line is not \"// SPDX-License-Identifier: MIT\"\n");
}

namespace {

struct Ended {
    int status;
    std::string output;
};

// Runs a shell command.
Ended run(const std::string& line)
{
    FILE* pipe = popen(("{ " + line + "; } 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("no shell");
    Ended ended;
    char text[1000];
    while (fgets(text, sizeof text, pipe))
        ended.output += text;
    ended.status = WEXITSTATUS(pclose(pipe));
    return ended;
}

// A tree with its own git history and a copy of the rule about commits. Settings of the surrounding
// repository do not affect it.
class History {
public:
    History()
    {
        tree_.write("tests/layout/note", "");
        fs::copy_file(fs::path(RIGOR_SOURCE_DIR) / rule, tree_.top() / rule);
    }

    Ended git(const std::string& arguments) const
    {
        return run("cd '" + tree_.top().string() +
                   "' && env -u GIT_DIR -u GIT_INDEX_FILE -u GIT_WORK_TREE "
                   "git -c user.name=a -c user.email=a@b -c core.hooksPath=/dev/null " +
                   arguments);
    }

    void commit(const std::string& subject) const
    {
        const Ended ended = git("commit -q --allow-empty -m '" + subject + "'");
        INFO(ended.output);
        REQUIRE(ended.status == 0);
    }

    Ended check(const fs::path& top) const
    {
        return run("env -u GIT_DIR -u GIT_INDEX_FILE -u GIT_WORK_TREE '" +
                   (fs::path(RIGOR_SOURCE_DIR) / rule).string() + "' '" + top.string() + "'");
    }
    Ended check() const { return check(tree_.top()); }

    fs::path top() const { return tree_.top(); }

private:
    static constexpr const char* rule = "tests/layout/commit_subjects.sh";
    Tree tree_;
};

} // namespace

TEST_CASE("layout: a subject has 72 characters and not 73 from the rule's commit on", "[layout]")
{
    if (run("command -v git").status != 0) {
        WARN("git is not installed");
        SUCCEED();
        return;
    }
    const History history;
    REQUIRE(history.git("init -q").status == 0);
    history.commit(columns(90)); // before the rule
    CHECK(history.check().status == 77);
    REQUIRE(history.git("add tests").status == 0);
    history.commit("tests: the rule");
    history.commit("ωωω" + columns(69));
    CHECK(history.check().status == 0);
    history.commit("ωωω" + columns(70));
    const Ended ended = history.check();
    CHECK(ended.status == 1);
    CHECK(ended.output.find("a subject of 73 characters; the limit is 72: ωωω") !=
          std::string::npos);
}

TEST_CASE("layout: a history that is missing or shallow is skipped with the reason", "[layout]")
{
    const History history;
    const Ended exported = history.check();
    CHECK(exported.status == 77);
    if (run("command -v git").status != 0) return;
    CHECK(exported.output == "skipped: no history here: the tree was exported\n");

    REQUIRE(history.git("init -q").status == 0);
    REQUIRE(history.git("add tests").status == 0);
    history.commit("tests: the rule");
    history.commit("tests: more");
    REQUIRE(
        history.git("clone -q --depth 1 'file://" + history.top().string() + "' clone").status ==
        0);
    const Ended shallow = history.check(history.top() / "clone");
    CHECK(shallow.status == 77);
    CHECK(shallow.output == "skipped: the clone is shallow: it lacks the older commits\n");
}
