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

TEST_CASE("class folder: only one run at a time writes there", "[class]")
{
    const TemporaryFolder folder;
    const ClassFolder first(folder.path(), "a4-collision", {"alice"});
    CHECK(contains(refusal_of(folder.path(), "a4-collision", {"alice"}), "another rigor"));
}

TEST_CASE("class folder: results that no control has confirmed can be dropped", "[class]")
{
    const TemporaryFolder folder;
    const ClassFolder opened(folder.path(), "a4-collision", {"alice", "bob"});
    folder.write("alice/result.json", "{}");
    std::filesystem::last_write_time(opened.result_of("alice"),
                                     std::filesystem::file_time_type::clock::now() -
                                         std::chrono::hours(1));
    CHECK(!opened.has_unconfirmed());
    opened.begin_unconfirmed();
    CHECK(opened.has_unconfirmed());
    folder.write("bob/result.json", "{}");
    opened.drop_unconfirmed({"alice", "bob"});
    CHECK(std::filesystem::exists(opened.result_of("alice")));
    CHECK(!std::filesystem::exists(opened.result_of("bob")));
    opened.confirm();
    CHECK(!opened.has_unconfirmed());
}

} // namespace rigor::testing
