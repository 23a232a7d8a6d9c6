// SPDX-License-Identifier: MIT
#include "grading/build/submission_build.hpp"

#include "grading/build/compiled_folder.hpp"
#include "grading/places.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <filesystem>
#include <string>
#include <thread>

namespace rigor::testing::submission_build_test {

namespace fs = std::filesystem;

TEST_CASE("submission build: objects of student/ are linked as they were when they were lent",
          "[build]")
{
    const fs::path place = CompiledFolder::place_of(places().source / "student");
    const TemporaryFolder folder;
    folder.write("inertia.cpp", "");
    // As soon as pipeline.cpp of student/ is compiled for the submission, another rigor waits until
    // it may remove the object. If some other test compiles the file before, there is another try.
    std::jthread other;
    const auto start_other = [&](int, int, const std::string& step) {
        if (step != "Building pipeline.cpp" || other.joinable()) return;
        other = std::jthread([&] {
            const BuildLock lock(place);
            fs::remove(place / "pipeline.o");
        });
    };
    SubmissionBuild build;
    for (int i = 0; i < 10 && !other.joinable(); ++i) {
        prepare_submission_builds({});
        fs::remove(place / "pipeline.o");
        remove_submission_build(folder.path());
        build = build_submission(folder.path(), start_other);
    }
    REQUIRE(other.joinable());
    other.join();
    CHECK(build.broken.empty());
    CHECK(fs::exists(build.worker));
    remove_submission_build(folder.path());
}

} // namespace rigor::testing::submission_build_test
