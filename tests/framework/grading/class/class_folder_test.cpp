// SPDX-License-Identifier: MIT
#include "grading/class/class_folder.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing {

namespace {

std::string refusal_of(const std::filesystem::path& folder, const std::string& assignment,
                       const std::vector<std::string>& submissions)
{
    try {
        const ClassFolder opened(folder, assignment, submissions);
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("class folder: nothing is overwritten that is not ours", "[class]")
{
    const TemporaryFolder folder;
    folder.write("thesis.txt", "do not lose");
    CHECK(contains(refusal_of(folder.path(), "a4-collision", {"alice"}), "\"thesis.txt\""));
    CHECK(!std::filesystem::exists(folder.path() / ".rigor"));
    CHECK(contains(refusal_of(folder.path() / "thesis.txt", "a4-collision", {"alice"}),
                   "expected a folder"));
}

TEST_CASE("class folder: another assignment or a smaller class is refused", "[class]")
{
    const TemporaryFolder folder;
    const auto out = folder.path() / "new/out";
    CHECK(refusal_of(out, "a4-collision", {"alice", "bob"}).empty());
    CHECK(refusal_of(out, "a4-collision", {"alice", "bob", "carol"}).empty());
    CHECK(contains(refusal_of(out, "a5-contact", {"alice", "bob", "carol"}), "a4-collision"));
    CHECK(contains(refusal_of(out, "a4-collision", {"alice", "carol"}), "\"bob\""));
}

TEST_CASE("class folder: a submission is withdrawn by removing its results", "[class]")
{
    const TemporaryFolder folder;
    const std::vector<std::string> both = {"alice", "bob"};
    const auto refusal = [&] { return refusal_of(folder.path(), "a4-collision", {"alice"}); };
    REQUIRE(refusal_of(folder.path(), "a4-collision", both).empty());
    CHECK(contains(refusal(), "\"bob\"")); // not graded yet
    folder.write("gradebook.csv", "");
    folder.write("bob/result.json", "");
    CHECK(contains(refusal(), "remove " + (folder.path() / "bob").string()));
    std::filesystem::remove_all(folder.path() / "bob");
    {
        const ClassFolder broken_off(folder.path(), "a4-collision", both);
        broken_off.begin_unconfirmed({{"bob", "1111"}});
    }
    CHECK(contains(refusal(), "\"bob\""));
    ClassFolder(folder.path(), "a4-collision", both).confirm();
    CHECK(refusal().empty());
}

TEST_CASE("class folder: only one run at a time writes there", "[class]")
{
    const TemporaryFolder folder;
    const ClassFolder first(folder.path(), "a4-collision", {"alice"});
    CHECK(contains(refusal_of(folder.path(), "a4-collision", {"alice"}), "another rigor"));
}

TEST_CASE("class folder: results that no control has confirmed are dropped whatever the clock says",
          "[class]")
{
    const TemporaryFolder folder;
    const ClassFolder opened(folder.path(), "a4-collision", {"alice", "bob", "carol"});
    const auto write = [&](const std::string& name, const std::string& fingerprint) {
        folder.write(name + "/result.json",
                     R"({"submission": ")" + name + R"(", "assignment": "a4-collision",)" +
                         R"( "status": "graded", "fingerprint": ")" + fingerprint +
                         R"(", "score": 1, "max_score": 1, "tests": [{"tag": "A4.1", "name": "",)" +
                         R"( "status": "passed", "score": 1, "max_score": 1}]})");
        // The clock of the file is a day ahead or a day behind.
        const auto day = std::chrono::hours(name == "alice" ? 24 : -24);
        std::filesystem::last_write_time(opened.result_of(name),
                                         std::filesystem::file_time_type::clock::now() + day);
    };
    write("alice", "1111");
    write("carol", "2222");
    CHECK(!opened.has_unconfirmed());
    opened.begin_unconfirmed({{"bob", "3333"}});
    opened.begin_unconfirmed({{"carol", "4444"}}); // the first run was broken off
    CHECK(opened.has_unconfirmed());
    write("bob", "3333");
    opened.drop_unconfirmed();
    CHECK(std::filesystem::exists(opened.result_of("alice")));
    CHECK(!std::filesystem::exists(opened.result_of("bob")));
    CHECK(std::filesystem::exists(opened.result_of("carol"))); // from an earlier run
    opened.confirm();
    CHECK(!opened.has_unconfirmed());
}

} // namespace rigor::testing
