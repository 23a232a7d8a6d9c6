// SPDX-License-Identifier: MIT
#include "grading/build/compiled_folder.hpp"

#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

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

} // namespace rigor::testing::compiled_folder_test
