// SPDX-License-Identifier: MIT
// `rigor grade --regrade`: a class is judged again with other random cases. Nobody's points change
// before the instructor has seen whose points would change.
#include "command.hpp"
#include "graded_class.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing::regrade_test {

namespace {

namespace fs = std::filesystem;

// Every file with its content, except the files in .rigor/, which runs keep for themselves.
std::map<std::string, std::string> files_in(const fs::path& out)
{
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(out))
        if (entry.is_regular_file() && !contains(entry.path().string(), "/.rigor/"))
            files[entry.path().lexically_relative(out).string()] = text_in(entry.path());
    return files;
}

class Class {
public:
    Class()
    {
        const fs::path tests = fs::path(RIGOR_SOURCE_DIR) / "tests";
        folder_.write("class/alice/pipeline.cpp", text_in(tests / "alternatives/pipeline.cpp"));
        // This one knows the cases of the first thousand seeds, and no others.
        folder_.write("class/mallory/pipeline.cpp",
                      text_in(tests / "attacks/submissions/detection/known_cases.cpp"));
    }
    void write(const std::string& name, const std::string& text) { folder_.write(name, text); }
    fs::path out() const { return folder_.path() / "out"; }

    Run grade(const std::vector<std::string>& options) const
    {
        std::vector<std::string> arguments = {"grade", "a0", (folder_.path() / "class").string(),
                                              "--out", out().string()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        return rigor(arguments);
    }

private:
    TemporaryFolder folder_;
};

} // namespace

TEST_CASE("regrade: what changes is shown before it is written", "[.long][cli][class]")
{
    const Class some;
    const Run first = some.grade({});
    CAPTURE(first.output);
    REQUIRE(first.status == 0);
    const auto before = files_in(some.out());
    CHECK(contains(before.at("gradebook.csv"), "mallory,graded,1,1,1\r\n"));

    // With other cases, nothing changes unless the instructor has seen the changes and applies
    // them.
    const Run refused = some.grade({"--seed", "7000"});
    CAPTURE(refused.output);
    CHECK(refused.status == 2);
    CHECK(is_one_line(refused.output, "found 2 of others, such as that of \"alice\": --regrade"));
    const Run too_soon = some.grade({"--seed", "7000", "--regrade", "--apply"});
    CAPTURE(too_soon.output);
    CHECK(too_soon.status == 2);
    CHECK(is_one_line(too_soon.output, "expected what --regrade has shown"));
    CHECK((files_in(some.out()) == before));

    const Run shown = some.grade({"--seed", "7000", "--regrade"});
    CAPTURE(shown.output);
    REQUIRE(shown.status == 0);
    CHECK(contains(shown.output, "  mallory: 1/1 points → 0/1 points\n"
                                 "    A0.1 kinetic_energy: passed 1/1 → failed 0/1\n"
                                 "1 of 2 submissions changes; the mean of the points: 1.00 → 0.50\n"
                                 "nothing is written yet"));
    CHECK((files_in(some.out()) == before));
    CHECK(some.grade({"--seed", "8000", "--regrade", "--apply"}).status == 2); // that was not shown
    CHECK((files_in(some.out()) == before));

    const Run applied = some.grade({"--seed", "7000", "--regrade", "--apply"});
    CAPTURE(applied.output);
    REQUIRE(applied.status == 0);
    CHECK(contains(applied.output, "  mallory: 1/1 points → 0/1 points\n"));
    const auto after = files_in(some.out());
    CHECK(contains(after.at("gradebook.csv"), "mallory,graded,0,1,0\r\n"));
    CHECK(after.size() == before.size());
    CHECK(contains(some.grade({"--seed", "7000"}).output, "0 graded now, 2 as before"));
    CHECK((files_in(some.out()) == after));
}

TEST_CASE("regrade: new submissions are shown too and what is current is not graded again",
          "[cli][class]")
{
    Class some;
    REQUIRE(some.grade({}).status == 0);
    some.write("class/bob/pipeline.cpp", "// nothing\n");
    const Run shown = some.grade({"--regrade"});
    CAPTURE(shown.output);
    REQUIRE(shown.status == 0);
    CHECK(contains(shown.output, "  bob: new, 0/1 points\n1 of 3 submissions changes"));
    CHECK(!fs::exists(some.out() / "bob"));
    REQUIRE(some.grade({"--regrade", "--apply"}).status == 0);
    CHECK(contains(text_in(some.out() / "gradebook.csv"), "bob,graded,0,1,0\r\n"));
}

TEST_CASE("regrade: it needs a gradebook and --apply needs --regrade", "[cli][class]")
{
    const Class some;
    const Run none = some.grade({"--regrade"});
    CAPTURE(none.output);
    CHECK(none.status == 2);
    CHECK(is_one_line(none.output, "--regrade: expected a folder with a gradebook.csv"));
    const Run alone = some.grade({"--apply"});
    CHECK(alone.status == 2);
    CHECK(is_one_line(alone.output, "--apply goes with --regrade"));
}

} // namespace rigor::testing::regrade_test
