// SPDX-License-Identifier: MIT
// What is taken from a folder that holds more than a solution.
#include "grading/build/submission_files.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace rigor {

namespace fs = std::filesystem;
using testing::TemporaryFolder;

namespace {

struct Intake {
    TemporaryFolder folder, copies;
    SubmissionFiles take() const { return take_files(folder.path(), copies.path()); }

    std::vector<std::string> copied() const
    {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(copies.path()))
            if (entry.is_regular_file())
                names.push_back(entry.path().lexically_relative(copies.path()).string());
        std::sort(names.begin(), names.end());
        return names;
    }
};

} // namespace

TEST_CASE("submission files: topics and headers are taken, the rest is not", "[build]")
{
    const Intake intake;
    intake.folder.write("inertia.cpp", "int a;\n");
    intake.folder.write("own/a b.hpp", "int b;\n");
    intake.folder.write("größe.hpp", "int c;\n");
    intake.folder.write("report.pdf", "%PDF");
    intake.folder.write("a/b/c/d/e/f/deep.hpp", "");
    intake.folder.write("bad\nname.hpp", "");
    intake.copies.write("left/over.hpp", "");
    const SubmissionFiles files = intake.take();
    REQUIRE(files.topics == std::vector<std::string>{"inertia"});
    REQUIRE(files.refused.empty());
    REQUIRE(intake.copied() == std::vector<std::string>{"größe.hpp", "inertia.cpp", "own/a b.hpp"});
    const std::uint64_t before = files.hash;
    intake.folder.write("own/a b.hpp", "int c;\n");
    REQUIRE(intake.take().hash != before);
}

TEST_CASE("submission files: a header that is not taken is named with the reason", "[build]")
{
    const Intake intake;
    intake.folder.write("inertia.cpp", "");
    intake.folder.write("a/b/c/d/taken.hpp", "");
    intake.folder.write("a/b/c/d/e/deep.hpp", "");
    intake.folder.write("large.hpp", std::string(std::size_t{3} << 20, ' '));
    intake.folder.write("utf16.hpp", std::string("\xFF\xFEi\0n\0", 6));
    intake.folder.write("folder.hpp/notes.txt", "");
    fs::create_symlink("inertia.cpp", intake.folder.path() / "link.hpp");
    const SubmissionFiles files = intake.take();
    REQUIRE(files.left_out == std::vector<std::string>{
                                  "a/b/c/d/e/deep.hpp: expected at most 4 folders around it",
                                  "large.hpp: expected at most 1024 kB, found 3072 kB",
                                  "link.hpp: expected a file, found a link",
                                  "utf16.hpp: expected a text in UTF-8, found UTF-16: save it as "
                                  "UTF-8"});
    REQUIRE(intake.copied() == std::vector<std::string>{"a/b/c/d/taken.hpp", "inertia.cpp"});
}

TEST_CASE("submission files: the first headers in the order of their names are taken", "[build]")
{
    const Intake intake;
    intake.folder.write("inertia.cpp", "");
    std::vector<std::string> expected;
    for (int i = 0; i < 250; ++i) { // not written in the order of the names
        const int number = 100 + i * 7 % 250;
        intake.folder.write("own/" + std::to_string(number) + ".hpp", "");
        if (i < 200) expected.push_back("own/" + std::to_string(100 + i) + ".hpp");
    }
    expected.insert(expected.begin(), "inertia.cpp");
    const SubmissionFiles files = intake.take();
    REQUIRE(intake.copied() == expected);
    REQUIRE(files.left_out.size() == 50);
    REQUIRE(files.left_out.front() ==
            "own/300.hpp: expected at most 200 headers and other sources");
}

TEST_CASE("submission files: the framework's own headers are not taken", "[build]")
{
    const Intake intake;
    intake.folder.write("inertia.cpp", "int a;\n");
    for (const char* name : {"formulas/types.hpp", "formulas/rotation.hpp", "formulas/own.hpp"})
        intake.folder.write(name, "int b;\n");
    intake.take();
    REQUIRE(intake.copied() == std::vector<std::string>{"formulas/own.hpp", "inertia.cpp"});
}

TEST_CASE("submission files: what is no file is refused in a line, without waiting", "[build]")
{
    const Intake intake;
    const fs::path folder = intake.folder.path();
    fs::create_directory(folder / "pipeline.cpp");
    REQUIRE(mkfifo((folder / "inertia.cpp").c_str(), 0600) == 0);
    fs::create_symlink("contact.cpp", folder / "collision.cpp");
    fs::create_symlink("collision.cpp", folder / "contact.cpp");
    fs::create_symlink("/dev/zero", folder / "rotation.cpp");
    intake.folder.write("fracture.cpp", std::string(std::size_t{3} << 20, ' '));
    const int socket_end = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    (folder / "plasticity.cpp").string().copy(address.sun_path, sizeof address.sun_path - 1);
    REQUIRE(bind(socket_end, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    close(socket_end);

    const SubmissionFiles files = intake.take();
    REQUIRE(files.topics.empty());
    REQUIRE(files.refused ==
            std::map<std::string, std::string>{
                {"pipeline", "pipeline.cpp: expected a file, found a folder\n"},
                {"inertia", "inertia.cpp: expected a file, found a pipe\n"},
                {"collision", "collision.cpp: expected a file, found a link\n"},
                {"contact", "contact.cpp: expected a file, found a link\n"},
                {"rotation", "rotation.cpp: expected a file, found a link\n"},
                {"fracture", "fracture.cpp: expected at most 1024 kB, found 3072 kB\n"},
                {"plasticity", "plasticity.cpp: expected a file, found a socket\n"}});
}

TEST_CASE("submission files: a text that Windows saved as UTF-16 is refused in a line", "[build]")
{
    const Intake intake;
    intake.folder.write("inertia.cpp", std::string("\xFF\xFEi\0n\0", 6));
    intake.folder.write("contact.cpp", std::string("\xFE\xFF\0i\0n", 6));
    intake.folder.write("collision.cpp", "\xEF\xBB\xBFint a;\n"); // the mark of UTF-8
    const SubmissionFiles files = intake.take();
    REQUIRE(files.topics == std::vector<std::string>{"collision"});
    for (const std::string topic : {"inertia", "contact"})
        REQUIRE(files.refused.at(topic) ==
                topic + ".cpp: expected a text in UTF-8, found UTF-16: save it as UTF-8\n");
}

TEST_CASE("submission files: links to headers are not followed", "[build]")
{
    const Intake intake;
    intake.folder.write("inertia.cpp", "");
    fs::create_symlink("/etc/hostname", intake.folder.path() / "host.hpp");
    fs::create_directory_symlink("/etc", intake.folder.path() / "etc");
    REQUIRE(intake.take().topics.size() == 1);
    REQUIRE(intake.copied() == std::vector<std::string>{"inertia.cpp"});
}

} // namespace rigor
