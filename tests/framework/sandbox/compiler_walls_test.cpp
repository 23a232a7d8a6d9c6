// SPDX-License-Identifier: MIT
// Tests of the walls around a compiler: it compiles what it should, reads nothing else of this
// machine, writes only in its own folder, and nothing that it starts outlives it.
#include "confine.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

namespace rigor {

using namespace testing;

namespace {

const std::string tree = RIGOR_SOURCE_DIR;

/// A compiler that may read the contract and write in one folder.
class Compiler {
public:
    explicit Compiler(Tier tier) : walls_(confinement(Profile::compiler, tier))
    {
        walls_.readable = {tree + "/framework/formulas"};
        walls_.writable = {own_.path()};
        walls_.folder = own_.path();
        walls_.environment = {"PATH=/usr/bin:/bin", "LC_ALL=C", "TMPDIR=" + own_.path().string()};
        walls_.limits.file_size = std::uint64_t{32} << 20;
    }

    ConfinedRun compile(const std::string& text, const std::string& object = "object.o") const
    {
        chmod(own_.write("source.cpp", text).c_str(), 0644);
        return run_confined(walls_,
                            {"/usr/bin/c++", "-std=c++20", "-isystem", "/usr/include/eigen3", "-I",
                             tree + "/framework", "-c", "source.cpp", "-o", object},
                            ample_time());
    }

    ConfinedRun attempt(const std::string& name, const std::string& about) const
    {
        Confinement walls = walls_;
        walls.readable = {program("attempt")};
        return run_attempt(walls, name, about);
    }

    bool has(const std::string& name) const { return std::filesystem::exists(own_.path() / name); }
    std::string folder() const { return own_.path(); }

private:
    TemporaryFolder own_;
    Confinement walls_;
};

/// Whether there is a process with this word on its command line.
bool is_running(const std::string& word)
{
    for (const auto& process : std::filesystem::directory_iterator("/proc")) {
        std::ifstream file(process.path() / "cmdline");
        std::string line;
        std::getline(file, line, '\n');
        if (line.find(word) != std::string::npos) return true;
    }
    return false;
}

} // namespace

TEST_CASE("sandbox: a compiler reads the system, the contract and its own folder")
{
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        const Compiler compiler(tier);
        const ConfinedRun good = compiler.compile("#include \"formulas/not_implemented.hpp\"\n"
                                                  "#if !__has_include(<Eigen/Core>)\n"
                                                  "#error no Eigen\n"
                                                  "#endif\n"
                                                  "double one() { return 1; }\n");
        CAPTURE(good.output, blocked(good));
        REQUIRE(good.ok());
        REQUIRE(compiler.has("object.o"));
        const ConfinedRun bad = compiler.compile("double one() { return x; }\n");
        REQUIRE(bad.status == 1);
        REQUIRE(bad.output.find("'x' was not declared") != std::string::npos);
    }
}

TEST_CASE("sandbox: a compiler finds no other file")
{
    const std::string environment = "/proc/" + std::to_string(getpid()) + "/environ";
    for (const std::string& path :
         {tree + "/README.md", tree + "/CMakeLists.txt", std::string("/etc/passwd"), environment}) {
        const std::string text = "asm(\".incbin \\\"" + path + "\\\"\");\n";
        for (const Tier tier : possible_tiers()) {
            CAPTURE(description(tier), path);
            const Compiler compiler(tier);
            const ConfinedRun run = compiler.compile(text);
            CAPTURE(run.output);
            REQUIRE(run.ok() == (tier == Tier::c)); // readable in tier C: it exists
            REQUIRE(compiler.has("object.o") == run.ok());
        }
    }
}

TEST_CASE("sandbox: a compiler writes only in its own folder")
{
    const TemporaryFolder other;
    chmod(other.path().c_str(), 0777);
    for (const Tier tier : walled_tiers()) {
        CAPTURE(description(tier));
        const Compiler compiler(tier);
        REQUIRE(!compiler.compile("int one = 1;\n", other.path() / "object.o").ok());
        REQUIRE(std::filesystem::is_empty(other.path()));
        REQUIRE(compiler.attempt("make a folder", compiler.folder() + "/new").output == "done\n");
        REQUIRE(compiler.attempt("make a folder", other.path() / "new").output != "done\n");
        REQUIRE(compiler.attempt("fill the disk", compiler.folder() + "/large").output ==
                "failed: File too large\n");
        REQUIRE(std::filesystem::is_empty(other.path()));
    }
}

TEST_CASE("sandbox: what no compiler needs is blocked and named")
{
    const std::string parent = std::to_string(getpid());
    const std::string cases[][3] = {{"socket", "", "open a network socket"},
                                    {"ptrace", parent, "look into another process"},
                                    {"read memory", parent, "look into another process"},
                                    {"mount", "/usr", "change mounts or namespaces"},
                                    {"shared memory", "", "share memory with other processes"}};
    for (const Tier tier : walled_tiers())
        for (const auto& [attempt, about, words] : cases) {
            CAPTURE(description(tier), attempt);
            const ConfinedRun run = Compiler(tier).attempt(attempt, about);
            CAPTURE(run.output);
            REQUIRE(run.output.empty());
            if (possible_walls().listener) REQUIRE(blocked(run) == words);
        }
}

TEST_CASE("sandbox: what a compiler may call does not reach beyond the walls")
{
    const std::string parent = std::to_string(getpid());
    const std::string cases[][2] = {{"read", "/proc/" + parent + "/mem"},
                                    {"read", "/proc/" + parent + "/environ"},
                                    {"read", tree + "/README.md"},
                                    {"list", tree},
                                    {"list", "/tmp"},
                                    {"execute", program("hello")},
                                    {"own user", ""}};
    for (const Tier tier : walled_tiers())
        for (const auto& [attempt, about] : cases) {
            CAPTURE(description(tier), attempt, about);
            const bool is_root = geteuid() == 0 && !walls_of(tier).another_user;
            if (attempt == "own user" && is_root) continue; // root without capabilities
            const ConfinedRun run = Compiler(tier).attempt(attempt, about);
            CAPTURE(run.output, blocked(run));
            REQUIRE(run.output.starts_with("failed: "));
        }
}

TEST_CASE("sandbox: in tier A the tree is not there and no process outside can be named")
{
    if (strongest(possible_walls()) != Tier::a) {
        WARN("skipped: this machine or user has no namespaces");
        return;
    }
    const Compiler compiler(Tier::a);
    for (const std::string& path :
         {tree + "/README.md", std::string("/proc/self"), std::string("/etc/passwd")})
        REQUIRE(compiler.attempt("look", path).output == "failed: No such file or directory\n");
    REQUIRE(compiler.attempt("look", compiler.folder()).output == "done\n");
    const std::string parent = std::to_string(getpid());
    REQUIRE(compiler.attempt("signal", parent).output == "failed: No such process\n");
    const std::string ordinary = compiler.attempt("make a folder", "/usr/new").output;
    REQUIRE(ordinary == "failed: Read-only file system\n");
}

TEST_CASE("sandbox: another user runs it each time if root may arrange that")
{
    for (const Tier tier : walled_tiers()) {
        CAPTURE(description(tier));
        const Compiler compiler(tier);
        const std::string first = compiler.attempt("user", "").output;
        const std::string own = std::to_string(getuid()) + " done\n";
        const bool is_another = walls_of(tier).another_user;
        REQUIRE((first != own) == is_another);
        if (is_another) REQUIRE(compiler.attempt("user", "").output != first);
    }
}

TEST_CASE("sandbox: daemons of twenty sessions end with the program")
{
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        const std::string mark = "daemons-of-" + std::to_string(getpid());
        const ConfinedRun run = Compiler(tier).attempt("daemons", mark);
        CAPTURE(run.output);
        REQUIRE(run.output.find("done\n") != std::string::npos);
        REQUIRE(run.output.find("daemon ") != std::string::npos);
        REQUIRE(run.seconds < 30);
        REQUIRE(!is_running(mark));
    }
}

TEST_CASE("sandbox: processes are limited where no others of their user are counted")
{
    for (const Tier tier : walled_tiers()) {
        CAPTURE(description(tier));
        if (!can_limit_processes(walls_of(tier))) continue;
        Confinement few = confinement(Profile::compiler, tier);
        few.readable = {program("attempt")};
        few.limits.processes = 10;
        const ConfinedRun run = run_attempt(few, "daemons");
        CAPTURE(run.output);
        REQUIRE(run.output.find("done\n") == std::string::npos);
        REQUIRE(run.output.find("failed: Resource temporarily unavailable") != std::string::npos);
    }
}

TEST_CASE("sandbox: descendants end too when the run is ended from outside")
{
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        const std::string mark = "ended-from-outside-" + std::to_string(getpid());
        Confinement walls = confinement(Profile::compiler, tier);
        walls.readable = {program("attempt")};
        RunLimits limits;
        limits.time = std::chrono::milliseconds(300);
        const ConfinedRun run = run_confined(walls, {program("attempt"), "loop", mark}, limits);
        REQUIRE(run.timed_out);
        REQUIRE(!is_running(mark));
    }
}

} // namespace rigor
