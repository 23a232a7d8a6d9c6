// SPDX-License-Identifier: MIT
#include "grading/machine/permissions.hpp"

#include "grading/places.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

namespace rigor::testing::permissions_test {

namespace fs = std::filesystem;
using fs::perms;

namespace {

perms for_others(const fs::path& path)
{
    return fs::status(path).permissions() & perms::others_all;
}

void make_private(const fs::path& path)
{
    fs::permissions(path, perms::group_all | perms::others_all, fs::perm_options::remove);
}

} // namespace

TEST_CASE("permissions: others read a folder and its files, but nothing that a link leads to",
          "[build]")
{
    const TemporaryFolder folder;
    const fs::path secret = folder.write("secret", ""), file = folder.write("files/a/b.cpp", "");
    fs::create_symlink(secret, folder.path() / "files/link");
    for (const fs::path& path : {secret, file, file.parent_path(), folder.path() / "files"})
        make_private(path);
    let_others_read(folder.path() / "files");
    let_others_read(folder.path() / "files/link");
    CHECK(for_others(folder.path() / "files") == (perms::others_read | perms::others_exec));
    CHECK(for_others(file.parent_path()) == (perms::others_read | perms::others_exec));
    CHECK(for_others(file) == perms::others_read);
    CHECK(for_others(secret) == perms::none);
    CHECK(for_others(folder.path()) == perms::none);
}

TEST_CASE("permissions: others pass through folders of the build and no others", "[build]")
{
    const fs::path folder = places().build / "submissions/permissions_test/out";
    fs::create_directories(folder);
    make_private(folder);
    make_private(folder.parent_path());
    let_others_pass(folder / "object.o");
    CHECK(for_others(folder) == perms::others_exec);
    CHECK(for_others(folder.parent_path()) == perms::others_exec);
    fs::remove_all(folder.parent_path());

    const TemporaryFolder other;
    let_others_pass(other.path() / "object.o");
    CHECK(for_others(other.path()) == perms::none);
}

} // namespace rigor::testing::permissions_test
