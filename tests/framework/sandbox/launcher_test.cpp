// SPDX-License-Identifier: MIT
// Tests of the launcher itself, with options that the grader would choose on other machines: where
// the kernel cannot tell the grader which call was blocked, such a call kills the program.
#include "confine.hpp"
#include "sandbox/report.hpp"
#include "support/catch.hpp"

#include <array>
#include <csignal>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigor {

using namespace testing;

namespace {

struct Launched {
    int status = -1; // as `waitpid` tells it
    Report report = {};
    std::string output;
};

/// Runs the launcher with these options, which end with "--" and the program.
Launched launch(std::vector<std::string> options)
{
    int sockets[2];
    REQUIRE(socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets) == 0);
    Ends output = output_pipe();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output.write, 1);
    posix_spawn_file_actions_adddup2(&actions, sockets[1], 100); // not a number that is in use
    posix_spawn_file_actions_adddup2(&actions, 100, 3);
    const std::string launcher = std::string(RIGOR_BINARY_DIR) + "/bin/confine";
    options.insert(options.begin(), {launcher, "--report=3"});
    std::vector<char*> arguments;
    for (std::string& option : options)
        arguments.push_back(option.data());
    arguments.push_back(nullptr);
    char* no_environment[] = {nullptr};
    pid_t pid = -1;
    REQUIRE(posix_spawn(&pid, launcher.c_str(), &actions, nullptr, arguments.data(),
                        no_environment) == 0);
    posix_spawn_file_actions_destroy(&actions);
    close(sockets[1]);
    Launched launched;
    REQUIRE(recv(sockets[0], &launched.report, sizeof(Report), 0) == sizeof(Report));
    REQUIRE(waitpid(pid, &launched.status, 0) == pid);
    close(sockets[0]);
    std::array<char, 4096> text;
    const ssize_t n = read(output.read, text.data(), text.size());
    if (n > 0) launched.output.assign(text.data(), n);
    return launched;
}

} // namespace

TEST_CASE("sandbox: without a listener a blocked call kills the program")
{
    const Walls& walls = possible_walls();
    if (!walls.filter || !walls.landlock) {
        WARN("skipped: this machine has no filter of calls or no Landlock");
        return;
    }
    const std::vector<std::string> behind_walls = {"--seccomp=kill", "--landlock", "--"};
    const auto with = [&](std::initializer_list<std::string> arguments) {
        std::vector<std::string> all = behind_walls;
        all.insert(all.end(), arguments);
        return launch(all);
    };
    const Launched honest = with({program("hello")});
    REQUIRE(honest.report.error == 0);
    REQUIRE(honest.status == 0);
    REQUIRE(honest.output == "hello\n");

    for (const std::string name : {"socket", "read", "fork", "execute"}) {
        CAPTURE(name);
        const Launched blocked = with({program("attempt"), name, program("hello")});
        REQUIRE(blocked.report.error == 0);
        REQUIRE(WIFSIGNALED(blocked.status));
        REQUIRE(WTERMSIG(blocked.status) == SIGSYS);
        REQUIRE(blocked.output.empty());
    }
    // The call that starts the program stays allowed for its descriptor, and the kernel ignores the
    // descriptor beside an absolute path. Landlock allows nothing but the program itself.
    const Launched twice =
        with({program("attempt"), "execute like the launcher", program("hello")});
    REQUIRE(twice.output.find("hello") == std::string::npos);
}

TEST_CASE("sandbox: a wall that cannot be put up is an error and no weaker wall")
{
    const Launched wrong_option = launch({"--seccomp=weak", "--", program("hello")});
    const Launched no_program = launch({"--landlock", "--", "/nowhere/worker"});
    const Launched no_path = launch({"--landlock", "--read=/nowhere", "--", program("hello")});
    for (const Launched& launched : {wrong_option, no_program, no_path}) {
        CAPTURE(launched.report.action);
        REQUIRE(launched.report.error != 0);
        REQUIRE(WIFEXITED(launched.status));
        REQUIRE(WEXITSTATUS(launched.status) == not_started);
        REQUIRE(launched.output.empty());
    }
}

} // namespace rigor
