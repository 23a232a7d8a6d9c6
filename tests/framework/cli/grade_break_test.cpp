// SPDX-License-Identifier: MIT
// `rigor grade` that is broken off, stopped, or has no room to write: what is lost, and that the
// next run makes the same gradebook bit for bit.
#include "class/made_class.hpp"
#include "command.hpp"
#include "framework/grading/memory_disk.hpp"
#include "graded_class.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <chrono>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <functional>
#include <iterator>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <random>
#include <sched.h>
#include <set>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace rigor::testing {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

Run grade(const fs::path& submissions, const fs::path& out)
{
    return rigor({"grade", "a0", submissions.string(), "--out", out.string(), "--jobs", "2"});
}

constexpr int not_prepared = 99; // an exit status

// A run in a process group of its own.
// @param prepare  called in the new process, which ends if the result is false
pid_t started(
    const fs::path& submissions, const fs::path& out, const fs::path& output = "/dev/null",
    const std::function<bool()>& prepare = [] { return true; })
{
    const std::string program = std::string(RIGOR_BINARY_DIR) + "/bin/rigor";
    const pid_t process = fork();
    if (process == 0) {
        setpgid(0, 0);
        const int file = open(output.c_str(), O_WRONLY | O_CREAT, 0644);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        if (!prepare()) _exit(not_prepared);
        execl(program.c_str(), "rigor", "grade", "a0", submissions.c_str(), "--out", out.c_str(),
              "--jobs", "2", nullptr);
        _exit(127);
    }
    return process;
}

int exit_status_of(pid_t process)
{
    int state = 0;
    REQUIRE(waitpid(process, &state, 0) == process);
    REQUIRE(WIFEXITED(state));
    return WEXITSTATUS(state);
}

// From now on, the kernel refuses this process files in memory (memfd_create), as if there were no
// memory left. @return whether this user can arrange that
bool refuse_memory_files()
{
    sock_filter lines[] = {BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
                           BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_memfd_create, 0, 1),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOMEM),
                           BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)};
    const sock_fprog program = {std::size(lines), lines};
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

// Gives this process its own view of the file system (mount namespace), in which /dev/shm has a
// single page and is full. @return whether this user can arrange that
bool fill_shared_memory()
{
    if (unshare(CLONE_NEWNS) != 0 ||
        mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("tmpfs", "/dev/shm", "tmpfs", 0, "size=4k") != 0)
        return false;
    std::ofstream("/dev/shm/full") << std::string(1 << 16, 'x');
    return fs::file_size("/dev/shm/full") <= 4096;
}

} // namespace

TEST_CASE("grade: a seed draws the same class and no two texts are equal", "[cli][class]")
{
    const auto first = made_class(RIGOR_SOURCE_DIR, "kinematics", 200, 1),
               again = made_class(RIGOR_SOURCE_DIR, "kinematics", 200, 1),
               other = made_class(RIGOR_SOURCE_DIR, "kinematics", 200, 2);
    std::set<std::string> kinds, texts;
    bool differs = false;
    for (std::size_t i = 0; i < first.size(); ++i) {
        REQUIRE(first[i].name == again[i].name);
        REQUIRE((first[i].text == again[i].text));
        differs |= first[i].text != other[i].text;
        kinds.insert(first[i].kind);
        if (first[i].kind == "nothing") continue;
        CAPTURE(i, first[i].kind);
        CHECK(texts.insert(first[i].text).second);
    }
    CHECK(differs);
    CHECK(kinds == std::set<std::string>{"attack", "mistake", "nothing", "right", "slip", "stub"});
}

TEST_CASE("grade: each member of a made class defines its formula once", "[cli][class]")
{
    const std::string formula = "\ndouble kinetic_energy(";
    for (const ClassMember& member : made_class(RIGOR_SOURCE_DIR, "pipeline", 200, 1)) {
        int definitions = 0;
        for (std::size_t at = member.text.find(formula); at != std::string::npos;
             at = member.text.find(formula, at + 1))
            ++definitions;
        CAPTURE(member.kind, member.text);
        REQUIRE(definitions <= 1);
    }
}

TEST_CASE("grade: a formula gets another name, and a member of its name keeps it", "[cli][class]")
{
    REQUIRE(renamed("speed(a.speed, b->speed) + rigor::speed(x_speed, speed2);\nspeed", "speed",
                    "right_speed") ==
            "right_speed(a.speed, b->speed) + rigor::right_speed(x_speed, speed2);\nright_speed");
    REQUIRE(renamed("none", "speed", "right_speed") == "none");
}

TEST_CASE("grade: a run that is killed at any moment resumes to the same gradebook",
          "[.long][class]")
{
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 6), whole = folder.path() / "whole",
                   killed = folder.path() / "killed";
    const auto start = Clock::now();
    REQUIRE(grade(submissions, whole).status == 0);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();

    // After three kills, or if a run has ended before its kill, a run completes the results. They
    // are compared and removed, so that the next run begins anew.
    constexpr int kills = 10, in_a_row = 3, most_rounds = 60;
    std::mt19937 random(5);
    int broken_off = 0;
    for (int round = 0; broken_off < kills && round < most_rounds; ++round) {
        const pid_t process = started(submissions, killed);
        std::this_thread::sleep_for(std::chrono::duration<double>(
            seconds / 2 * std::uniform_real_distribution<double>(0, 1)(random)));
        kill(process, SIGKILL);
        int state = 0;
        REQUIRE(waitpid(process, &state, 0) == process);
        const bool was_killed = WIFSIGNALED(state);
        broken_off += was_killed;
        if (was_killed && broken_off % in_a_row != 0 && broken_off < kills) continue;
        const Run resumed = grade(submissions, killed);
        CAPTURE(round, resumed.output);
        REQUIRE(resumed.status == 0);
        CHECK(class_files(killed) == class_files(whole));
        CHECK(!has_drafts(killed));
        fs::remove_all(killed);
    }
    CHECK(broken_off == kills);
}

TEST_CASE("grade: a run that is stopped for a while goes on to the same gradebook",
          "[.long][class]")
{
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 6), whole = folder.path() / "whole",
                   stopped = folder.path() / "stopped";
    REQUIRE(grade(submissions, whole).status == 0);
    const pid_t process = started(submissions, stopped);
    for (int i = 0; i < 3; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        kill(-process, SIGSTOP);
        std::this_thread::sleep_for(std::chrono::seconds(2));
        kill(-process, SIGCONT);
    }
    CHECK(exit_status_of(process) == 0);
    CHECK(class_files(stopped) == class_files(whole));
}

TEST_CASE("grade: a full disk is one line and no half file, and room lets the run go on",
          "[.long][class]")
{
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 6), whole = folder.path() / "whole";
    const MemoryDisk disk(folder.path() / "disk", "size=48k");
    if (!disk.is_mounted()) {
        WARN("left out: this user cannot mount a small disk");
        return;
    }
    REQUIRE(grade(submissions, whole).status == 0);
    const fs::path out = folder.path() / "disk/out";
    const Run full = grade(submissions, out);
    CAPTURE(full.output);
    CHECK(full.status == 2);
    CHECK(is_one_line(full.output, "No space left on device"));
    CHECK(!has_drafts(out));
    CHECK(!fs::exists(out / "gradebook.csv"));
    REQUIRE(disk.remount("size=64m"));
    const Run resumed = grade(submissions, out);
    CAPTURE(resumed.output);
    REQUIRE(resumed.status == 0);
    CHECK(class_files(out) == class_files(whole));
}

TEST_CASE("grade: no memory to share is one line and nothing is graded", "[cli][class]")
{
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 2), out = folder.path() / "out",
                   output = folder.path() / "output";
    const int status = exit_status_of(started(submissions, out, output, refuse_memory_files));
    if (status == not_prepared) {
        WARN("left out: this user cannot have calls of the kernel refused");
        return;
    }
    const std::string text = text_in(output);
    CAPTURE(text);
    CHECK(status == 2);
    CHECK(is_one_line(without_waiting(text), "expected shared memory"));
    CHECK(contains(text, "Cannot allocate memory"));
    CHECK(!fs::exists(out / "gradebook.csv"));
}

TEST_CASE("grade: a full /dev/shm changes nothing since no run needs it", "[.long][class]")
{
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 6), whole = folder.path() / "whole",
                   full = folder.path() / "full", output = folder.path() / "output";
    REQUIRE(grade(submissions, whole).status == 0);
    const int status = exit_status_of(started(submissions, full, output, fill_shared_memory));
    if (status == not_prepared) {
        WARN("left out: this user cannot have a view of the file system of its own");
        return;
    }
    CAPTURE(text_in(output));
    CHECK(status == 0);
    CHECK(class_files(full) == class_files(whole));
}

TEST_CASE("grade: a folder that cannot be written is one line", "[cli][class]")
{
    const TemporaryFolder folder;
    const fs::path submissions = small_class(folder, 1), place = folder.path() / "read_only";
    const MemoryDisk disk(place, "", MS_RDONLY);
    if (geteuid() == 0 && !disk.is_mounted()) {
        WARN("left out: root may write everywhere and cannot mount a read-only disk here");
        return;
    }
    if (geteuid() != 0) fs::permissions(place, fs::perms::owner_read | fs::perms::owner_exec);
    for (const fs::path& out : {place, place / "out"}) {
        const Run run = grade(submissions, out);
        CAPTURE(run.output);
        CHECK(run.status == 2);
        CHECK(is_one_line(run.output, place.string()));
    }
    std::error_code error;
    fs::permissions(place, fs::perms::owner_all, error);
}

} // namespace rigor::testing
