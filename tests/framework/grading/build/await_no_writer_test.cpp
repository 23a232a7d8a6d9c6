// SPDX-License-Identifier: MIT
// A program can be started only after the last process that writes to it has closed it.
#include "grading/build/await_no_writer.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <atomic>
#include <chrono>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

namespace rigor {

TEST_CASE("await no writer: it returns when the last writer has closed the file")
{
    const testing::TemporaryFolder folder;
    folder.write("program", "#!/bin/sh\n");
    const auto file = folder.path() / "program";
    const int writer = open(file.c_str(), O_WRONLY | O_CLOEXEC);
    REQUIRE(writer >= 0);
    std::atomic<bool> is_closed = false;
    std::thread closes([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        is_closed = true;
        close(writer);
    });
    await_no_writer(file);
    const bool was_closed = is_closed;
    closes.join();
    REQUIRE(was_closed);
}

TEST_CASE("await no writer: a file that is read, or is not there, is not waited for")
{
    const testing::TemporaryFolder folder;
    folder.write("program", "#!/bin/sh\n");
    const int reader = open((folder.path() / "program").c_str(), O_RDONLY | O_CLOEXEC);
    const auto start = std::chrono::steady_clock::now();
    await_no_writer(folder.path() / "program");
    await_no_writer(folder.path() / "none");
    REQUIRE(std::chrono::steady_clock::now() - start < std::chrono::seconds(5));
    close(reader);
}

} // namespace rigor
