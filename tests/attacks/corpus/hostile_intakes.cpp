// SPDX-License-Identifier: MIT
#include "corpus.hpp"

#include "framework/grading/intake/written_archive.hpp"

#include <fstream>
#include <stdexcept>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

namespace rigor::corpus {

namespace fs = std::filesystem;
using testing::ArchiveEntry;
using testing::ArchiveFormat;

namespace {

const Expectation full = {1, {"passed"}, ""};

Expectation rejected(const std::string& text)
{
    return {0, {"rejected"}, text};
}

void make(int result, const std::string& what)
{
    if (result != 0) throw std::runtime_error("cannot make " + what);
}

fs::path write_file(const fs::path& folder, const std::string& name, const std::string& text)
{
    fs::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder;
}

// A folder with a solution and a name that means harm.
HostileSubmission named(const std::string& what, const std::string& name,
                        const Expectation& expected, const std::string& solution)
{
    return {"names/" + what, expected, [=](const fs::path& folder) {
                return write_file(folder / name, "pipeline.cpp", solution);
            }};
}

HostileSubmission archived(const std::string& what, ArchiveFormat format,
                           const std::vector<ArchiveEntry>& entries, const Expectation& expected)
{
    return {"archives/" + what, expected, [=](const fs::path& folder) {
                return write_archive(folder / (what + ".zip"), format, entries);
            }};
}

fs::path with_socket(const fs::path& folder)
{
    const fs::path place = folder / "socket";
    fs::create_directories(place);
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    const std::string name = place / "pipeline.cpp";
    if (name.size() >= sizeof address.sun_path) throw std::runtime_error("too long: " + name);
    name.copy(address.sun_path, name.size());
    const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
    make(bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), "a socket");
    close(socket);
    return place;
}

void add_names(std::vector<HostileSubmission>& all, const std::string& solution)
{
    all.push_back(named("formula", "=cmd|' /c calc'!A1", full, solution));
    all.push_back(named("wide_formula", "\uFF1DHYPERLINK(1)", full, solution));
    all.push_back(named("formula_after_space", "\u00A0@SUM(1)", full, solution));
    all.push_back(named("markup", "<script>alert(1)<", full, solution));
    all.push_back(named("quotes", "a\"b'c,d;e", full, solution));
    all.push_back(named("option", "--out=x", full, solution));
    const std::string unseen = "expected a name in UTF-8 without control characters";
    all.push_back(named("backward", "a\u202Egnp.b", rejected(unseen), solution));
    all.push_back(named("newline", "a\nb", rejected(unseen), solution));
    all.push_back(named("escape", "a\033[2Jb", rejected(unseen), solution));
    all.push_back(named("not_utf8", "a\xff\xfe", rejected(unseen), solution));
}

void add_kinds(std::vector<HostileSubmission>& all, const std::string& solution)
{
    all.push_back({"kinds/link", rejected("found a link"), [](const fs::path& folder) {
                       fs::create_directories(folder / "link");
                       fs::create_symlink(RIGOR_SOURCE_DIR "/reference/pipeline.cpp",
                                          folder / "link/pipeline.cpp");
                       return folder / "link";
                   }});
    all.push_back({"kinds/pipe", rejected("found a pipe"), [](const fs::path& folder) {
                       fs::create_directories(folder / "pipe");
                       make(mkfifo((folder / "pipe/pipeline.cpp").c_str(), 0644), "a pipe");
                       return folder / "pipe";
                   }});
    all.push_back({"kinds/socket", rejected("found a socket"), with_socket});
    all.push_back({"kinds/folder", rejected("expected pipeline.cpp"), [](const fs::path& folder) {
                       return write_file(folder / "folder", "pipeline.cpp/a.txt", "");
                   }});
    all.push_back({"kinds/too_long",
                   {0, {"compile_error"}, "expected at most 1024 kB"},
                   [](const fs::path& folder) {
                       return write_file(folder / "too_long", "pipeline.cpp",
                                         std::string(2 << 20, ' '));
                   }});
    all.push_back({"kinds/precomposed", full, [solution](const fs::path& folder) {
                       const fs::path place = folder / "precomposed";
                       write_file(place, "\u00E9.hpp", "#error this one\n");
                       write_file(place, "e\u0301.hpp", "#error or that one\n");
                       return write_file(place, "pipeline.cpp", solution);
                   }});
    all.push_back({"kinds/precompiled", full, [solution](const fs::path& folder) {
                       const fs::path place = folder / "precompiled";
                       write_file(place, "formulas/pipeline.hpp.gch", "gpch");
                       write_file(place, "pipeline.hpp.gch", "gpch");
                       return write_file(place, "pipeline.cpp", solution);
                   }});
    all.push_back({"kinds/own_contract", // a copy of the contract that is handed in is not taken
                   {1, {"passed"}, ""},
                   [solution](const fs::path& folder) {
                       const fs::path place = folder / "own_contract";
                       write_file(place, "formulas/pipeline.hpp", "#error not this contract\n");
                       return write_file(place, "pipeline.cpp",
                                         "#include \"./formulas/pipeline.hpp\"\n" + solution);
                   }});
}

void add_archives(std::vector<HostileSubmission>& all, const std::string& solution)
{
    const ArchiveEntry good = {"pipeline.cpp", solution};
    const auto zip = ArchiveFormat::zip, tar = ArchiveFormat::tar, tar_gz = ArchiveFormat::tar_gz;
    const std::string zeros(3 << 20, '\0'), names = "expected names";
    all.push_back(
        archived("leads_out", zip, {good, {"../pipeline.cpp", solution}}, rejected(names)));
    all.push_back(
        archived("absolute", tar, {good, {"/tmp/rigor_attack.cpp", ""}}, rejected(names)));
    all.push_back(archived("twice", tar, {good, good}, rejected("twice")));
    all.push_back(archived("two_files", zip, {{"a/pipeline.cpp", ""}, {"b/pipeline.cpp", ""}},
                           rejected("found 2")));
    all.push_back(
        archived("link", tar, {{"pipeline.cpp", "", AE_IFLNK, "/etc/passwd"}}, rejected("a link")));
    all.push_back(archived("hard_link", tar, {good, {"b.cpp", "", AE_IFREG, "", "pipeline.cpp"}},
                           rejected("a hard link")));
    all.push_back(archived("device", tar, {{"pipeline.cpp", "", AE_IFCHR}}, rejected("a device")));
    all.push_back(archived("bomb", tar_gz, {good, {"zeros.bin", zeros}}, rejected("200 times")));
    all.push_back(
        archived("zip_in_gz", ArchiveFormat::zip_gz, {good}, rejected("compressed again")));
    all.push_back(archived("backward_name", zip, {good, {"a\u202Eppc.b", ""}},
                           rejected("expected names in UTF-8")));
    all.push_back(archived("hidden_solution", zip, {{".git/pipeline.cpp", solution}},
                           rejected("expected pipeline.cpp, found no file")));
    all.push_back(archived("header_of_ours", zip,
                           {good, {"formulas/types.hpp", "#error not these types\n"}}, full));
    std::vector<ArchiveEntry> many = {good};
    for (int i = 0; i <= 10'000; ++i)
        many.push_back({std::to_string(i), ""});
    all.push_back(archived("many_files", tar, many, rejected("at most 10000 files")));
    all.push_back({"archives/broken", rejected("expected a whole"), [](const fs::path& folder) {
                       write_file(folder, "broken.zip", std::string("PK\3\4") + "and no more");
                       return folder / "broken.zip";
                   }});
}

} // namespace

std::vector<HostileSubmission> hostile_intakes(const std::string& solution)
{
    std::vector<HostileSubmission> all;
    add_names(all, solution);
    add_kinds(all, solution);
    add_archives(all, solution);
    return all;
}

} // namespace rigor::corpus
