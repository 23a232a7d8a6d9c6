// SPDX-License-Identifier: MIT
#include "grading/build/compiled_folder.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>

namespace rigor::testing::compiled_folder_test {

namespace fs = std::filesystem;

TEST_CASE("compiled folder: a key that cannot be written with all its lines does not hold",
          "[build]")
{
    const TemporaryFolder folder;
    const KeyFile key(folder.path() / "inertia.key");
    key.write(1, {"a T 0", "b T 8"});
    REQUIRE(key.holds(1));
    REQUIRE(key.lines() == std::vector<std::string>{"a T 0", "b T 8"});
    fs::create_symlink("/dev/full", key.file().string() + ".new"); // as on a disk that is full
    CHECK_THROWS(key.write(2, {"c T 0"}));
    CHECK_FALSE(key.holds(2));
    CHECK(key.lines().size() == 2);
}

TEST_CASE("compiled folder: nobody sees a key without the lines that belong to it", "[build]")
{
    const TemporaryFolder folder;
    const KeyFile key(folder.path() / "inertia.key");
    const std::vector<std::string> old = {"a T 0"};
    key.write(1, old);
    // Another name of the file shows whether the file itself is written or another takes its place.
    fs::create_hard_link(key.file(), folder.path() / "seen");
    key.write(2, {"b T 0", "c T 8"});
    CHECK(KeyFile(folder.path() / "seen").holds(1));
    CHECK(KeyFile(folder.path() / "seen").lines() == old);
    CHECK(key.holds(2));
    CHECK(key.lines().size() == 2);
}

TEST_CASE("compiled folder: a file is compiled again if a topic's file that it includes changes",
          "[build]")
{
    const TemporaryFolder folder;
    const Toolchain tools = student_toolchain();
    using Steps = std::vector<std::string>;
    const auto compile = [&] {
        Steps steps;
        CompiledFolder compiled(folder.path(), tools);
        for (const auto& [topic, object] :
             compiled.compile({"collision", "contact", "inertia"}, {}, steps))
            CHECK(object.errors.empty());
        std::sort(steps.begin(), steps.end());
        return steps;
    };
    folder.write("collision.cpp", "inline int a() { return 1; }\n");
    folder.write("contact.cpp", "#include \"collision.cpp\"\nint b() { return a(); }\n");
    folder.write("inertia.cpp", "int c;\n");
    CHECK(compile().size() == 3);
    CHECK(compile() == Steps());
    folder.write("collision.cpp", "inline int a() { return 2; }\n");
    CHECK(compile() == Steps{"Building collision.cpp", "Building contact.cpp"});
    CHECK(compile() == Steps());
    folder.write("contact.cpp", "int b() { return 3; }\n");
    CHECK(compile() == Steps{"Building contact.cpp"});
    folder.write("collision.cpp", "inline int a() { return 3; }\n");
    CHECK(compile() == Steps{"Building collision.cpp"});
    fs::remove_all(CompiledFolder::place_of(folder.path()));
}

TEST_CASE("compiled folder: a file is compiled again if it asks for one that is there now",
          "[build]")
{
    const TemporaryFolder folder;
    const Toolchain tools = student_toolchain();
    std::vector<std::string> steps;
    folder.write("contact.cpp", "#if __has_include(\"collision.cpp\")\nint b;\n#endif\n");
    CompiledFolder(folder.path(), tools).compile({"contact"}, {}, steps);
    CHECK(steps.size() == 1);
    folder.write("collision.cpp", "");
    CompiledFolder(folder.path(), tools).compile({"contact"}, {}, steps);
    CHECK(steps.size() == 2);
    fs::remove_all(CompiledFolder::place_of(folder.path()));
}

TEST_CASE("compiled folder: what fails for want of a removed file is no error of the student",
          "[build]")
{
    const TemporaryFolder folder;
    const Toolchain tools = student_toolchain();
    const fs::path place = CompiledFolder::place_of(folder.path());
    std::vector<std::string> steps;
    folder.write("contact.cpp", "#include \"own.hpp\"\nint b = a;\n");
    folder.write("own.hpp", "constexpr int a = 1;\n");
    for (const fs::path& gone : {place / "files/own.hpp", place / "files"}) {
        CompiledFolder compiled(folder.path(), tools);
        fs::remove_all(gone);
        CHECK_THROWS_AS(compiled.compile({"contact"}, {}, steps), std::runtime_error);
    }
    {
        CompiledFolder compiled(folder.path(), tools);
        folder.write("own.hpp", "none\n"); // a copy has been taken
        CHECK(compiled.compile({"contact"}, {}, steps).at("contact").errors.empty());
        fs::remove(place / "contact.o");
        std::ofstream(place / "files/own.hpp") << "another\n";
        CHECK_THROWS_AS(compiled.compile({"contact"}, {}, steps), std::runtime_error);
    }
    CompiledFolder wrong(folder.path(), tools);
    CHECK(!wrong.compile({"contact"}, {}, steps).at("contact").errors.empty());
    fs::remove_all(place);
}

} // namespace rigor::testing::compiled_folder_test
