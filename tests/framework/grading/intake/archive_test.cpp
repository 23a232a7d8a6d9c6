// SPDX-License-Identifier: MIT
#include "grading/intake/archive.hpp"

#include "grading/intake/refused.hpp"
#include "grading/intake/unpacked.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "written_archive.hpp"

#include <fmt/format.h>
#include <fstream>

namespace rigor::testing::archive_test {

namespace {

using Format = ArchiveFormat;

// Why an archive with these entries is refused; empty if it is taken.
std::string refusal_of(Format format, const std::vector<ArchiveEntry>& entries,
                       const IntakeLimits& limits = {})
{
    const TemporaryFolder folder;
    try {
        write_archive(folder.path() / "a", format, entries);
        read_archive_behind_walls(folder.path(), "a", limits);
        return "";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

std::string refusal_of_file(const std::string& content)
{
    const TemporaryFolder folder;
    try {
        folder.write("a", content);
        read_archive_behind_walls(folder.path(), "a");
        return "";
    } catch (const Refused& refused) {
        return refused.what();
    }
}

std::string bytes_of(Format format, const std::vector<ArchiveEntry>& entries)
{
    const TemporaryFolder folder;
    std::ifstream in(write_archive(folder.path() / "a", format, entries), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

// A .tar with one sparse file that has no bytes, only a gap of this size.
std::string only_a_gap(const std::string& name, std::size_t size)
{
    std::string header(512, '\0');
    const auto put = [&](std::size_t at, const std::string& text) {
        header.replace(at, text.size(), text);
    };
    const std::string real_size = fmt::format("{:011o}", size);
    put(0, name);
    put(100, "0000644");
    put(108, "0000000");
    put(116, "0000000");
    put(124, "00000000000"); // the bytes that follow
    put(136, "00000000000");
    put(156, "S"); // a sparse file, in the format of GNU
    put(257, "ustar  ");
    put(386, real_size); // the first piece, an empty one at the end
    put(398, "00000000000");
    put(483, real_size);
    put(148, "        ");
    unsigned sum = 0;
    for (const char c : header)
        sum += static_cast<unsigned char>(c);
    put(148, fmt::format("{:06o}", sum) + std::string(1, '\0'));
    return header + std::string(1024, '\0');
}

// A text that no compression makes much shorter.
std::string noise(std::size_t size)
{
    std::string text;
    unsigned state = 1;
    for (std::size_t i = 0; i < size; ++i) {
        state = state * 1664525 + 1013904223;
        text += static_cast<char>(state >> 24);
    }
    return text;
}

const ArchiveEntry good = {"collision.cpp", "int x;\n"};

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

TEST_CASE("archive: every format gives the same files", "[intake]")
{
    for (const Format format :
         {Format::zip, Format::tar, Format::tar_gz, Format::tar_xz, Format::tar_zst}) {
        CAPTURE(static_cast<int>(format));
        const TemporaryFolder folder;
        write_archive(
            folder.path() / "a", format,
            {{"Zoë", "", AE_IFDIR}, {"Zoë/collision.cpp", "int x;\n"}, {"./notes.txt", "hello"}});
        const Contents contents = read_archive_behind_walls(folder.path(), "a");
        REQUIRE(contents.sources() ==
                std::map<std::string, std::string>{{"Zoë/collision.cpp", "int x;\n"}});
        REQUIRE(contents.others() == std::set<std::string>{"notes.txt"});
    }
}

TEST_CASE("archive: names that lead out of it are refused", "[intake]")
{
    for (const Format format : {Format::zip, Format::tar})
        for (const char* name : {"../collision.cpp", "a/../../collision.cpp", "/etc/collision.cpp",
                                 "C:/collision.cpp", "..\\collision.cpp", "\\collision.cpp",
                                 "C:\\collision.cpp", "a\\..\\..\\collision.cpp"}) {
            CAPTURE(name);
            const std::string refusal = refusal_of(format, {good, {name, "int x;\n"}});
            REQUIRE(contains(refusal, "collision.cpp\""));
            REQUIRE(contains(refusal, "expected names"));
        }
}

TEST_CASE("archive: names that cannot be shown are refused", "[intake]")
{
    for (const Format format : {Format::zip, Format::tar})
        for (const char* name : {"a\xff.cpp", "a\x1b[31m.cpp", "a\nb.cpp", "a\xe2\x80\xaeppc.b"}) {
            const std::string refusal = refusal_of(format, {good, {name, "int x;\n"}});
            CAPTURE(refusal);
            REQUIRE(contains(refusal, "UTF-8"));
            REQUIRE(!contains(refusal, "\x1b"));
        }
}

TEST_CASE("archive: links and devices are refused", "[intake]")
{
    CHECK(contains(refusal_of(Format::tar, {{"collision.cpp", "", AE_IFLNK, "/etc/passwd"}}),
                   "a link"));
    CHECK(contains(refusal_of(Format::zip, {{"collision.cpp", "", AE_IFLNK, "/etc/passwd"}}),
                   "a link"));
    CHECK(contains(refusal_of(Format::tar, {good, {"b.cpp", "", AE_IFREG, "", "collision.cpp"}}),
                   "a hard link"));
    CHECK(contains(refusal_of(Format::tar, {{"collision.cpp", "", AE_IFIFO}}), "a pipe"));
    CHECK(contains(refusal_of(Format::tar, {{"collision.cpp", "", AE_IFCHR}}), "a device"));
}

TEST_CASE("archive: a sparse file counts as large as it unpacks", "[intake]")
{
    CHECK(refusal_of_file(only_a_gap("zeros.bin", std::size_t{7} << 30)) ==
          "expected an archive that unpacks to at most 64 MB, found more");
    CHECK(refusal_of_file(only_a_gap("zeros.bin", std::size_t{3} << 20)) ==
          "expected an archive that unpacks to at most 200 times its size, found more");
    CHECK(refusal_of_file(only_a_gap("zeros.bin", 1000)).empty());
    CHECK(contains(refusal_of_file(only_a_gap("collision.cpp", 1000)), "with gaps"));
}

TEST_CASE("archive: a name twice is refused", "[intake]")
{
    CHECK(contains(refusal_of(Format::tar, {good, good}), "twice"));
    CHECK(contains(refusal_of(Format::zip, {{"a.txt", "1"}, {"./a.txt", "2"}}), "twice"));
}

TEST_CASE("archive: limits on files, bytes and ratio", "[intake]")
{
    IntakeLimits few;
    few.entries = 2;
    CHECK(refusal_of(Format::tar, {good, {"a", ""}}, few).empty());
    CHECK(contains(refusal_of(Format::tar, {good, {"a", ""}, {"b", ""}}, few), "at most 2 files"));

    const std::string zeros(3 << 20, '\0');
    CHECK(contains(refusal_of(Format::zip, {{"a.bin", zeros}}), "200 times"));
    CHECK(contains(refusal_of(Format::tar_gz, {{"a.bin", zeros}}), "200 times"));
    CHECK(refusal_of(Format::tar, {{"a.bin", zeros}}).empty());

    IntakeLimits small;
    small.unpacked_bytes = 1 << 20;
    CHECK(contains(refusal_of(Format::tar, {{"a.bin", noise(2 << 20)}}, small), "at most 1 MB"));
    small = {};
    small.archive_bytes = 1 << 20;
    CHECK(contains(refusal_of(Format::tar, {{"a.bin", noise(2 << 20)}}, small),
                   "an archive of at most 1 MB"));
    small = {};
    small.source_bytes = 1 << 20;
    CHECK(contains(refusal_of(Format::tar, {{"a.cpp", noise(2 << 20)}}, small), "sources"));
}

TEST_CASE("archive: what is broken is refused wherever it is cut", "[intake]")
{
    const std::vector<ArchiveEntry> entries = {{"collision.cpp", noise(3000)}};
    for (const Format format : {Format::zip, Format::tar, Format::tar_gz, Format::tar_xz}) {
        const std::string whole = bytes_of(format, entries);
        for (const std::size_t size : {0, 1, 100, 700, 2500}) {
            CAPTURE(static_cast<int>(format), size);
            REQUIRE(contains(refusal_of_file(whole.substr(0, size)), "expected"));
        }
    }
    CHECK(contains(refusal_of_file("this is no archive"), "cannot be read"));
    CHECK(contains(refusal_of(Format::tar, {}), "empty"));
    CHECK(contains(refusal_of(Format::zip, {}), "expected"));
}

TEST_CASE("archive: a byte that changed in a zip is found", "[intake]")
{
    std::string bytes = bytes_of(Format::zip, {{"collision.cpp", noise(3000)}});
    bytes[1500] = static_cast<char>(bytes[1500] ^ 1);
    CHECK(contains(refusal_of_file(bytes), "cannot be read"));
}

TEST_CASE("archive: compressed twice is refused", "[intake]")
{
    const TemporaryFolder folder;
    const std::string inner = bytes_of(Format::tar_gz, {good});
    archive* out = archive_write_new();
    archive_write_set_format_raw(out);
    archive_write_add_filter_gzip(out);
    const auto file = folder.path() / "a.tar.gz.gz";
    REQUIRE(archive_write_open_filename(out, file.c_str()) == ARCHIVE_OK);
    add_entry(out, {"a.tar.gz", inner});
    archive_write_close(out);
    archive_write_free(out);
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), {}};
    REQUIRE(contains(refusal_of_file(bytes), "compressed once"));
}

TEST_CASE("archive: the ending is not part of the submission's name", "[intake]")
{
    CHECK(without_archive_ending("alice.tar.gz") == "alice");
    CHECK(without_archive_ending("Bob.B.ZIP") == "Bob.B");
    CHECK(without_archive_ending("alice") == "alice");
    CHECK(without_archive_ending(".zip") == ".zip");
    CHECK(is_archive_name("x.rar"));
    CHECK(!is_archive_name("notes.txt"));
}

TEST_CASE("intake: a zip archive that is compressed again is refused", "[intake]")
{
    // Otherwise a folder in it could claim to have any number of bytes, all of which are unpacked.
    REQUIRE(
        contains(refusal_of(Format::zip_gz, {{"collision.cpp", "int x;\n"}}), "compressed again"));
    REQUIRE(refusal_of(Format::zip, {{"collision.cpp", "int x;\n"}}).empty());
    REQUIRE(refusal_of(Format::tar_gz, {{"collision.cpp", "int x;\n"}}).empty());
}

} // namespace rigor::testing::archive_test
