// SPDX-License-Identifier: MIT
// Tests of the tiers: which one it is, who may choose it, and that all other tests of this room
// also pass for an ordinary user.
#include "confine.hpp"
#include "errors/input_error.hpp"
#include "sandbox/descriptor.hpp"
#include "support/catch.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <set>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace rigor {

using namespace testing;

namespace {

/// Sets RIGOR_TIER as long as this object lives.
class WantedTier {
public:
    explicit WantedTier(const char* name) { setenv("RIGOR_TIER", name, 1); }
    ~WantedTier() { before_ ? setenv("RIGOR_TIER", before_->c_str(), 1) : unsetenv("RIGOR_TIER"); }
    WantedTier(const WantedTier&) = delete;
    WantedTier& operator=(const WantedTier&) = delete;

private:
    std::optional<std::string> before_ = std::getenv("RIGOR_TIER")
                                             ? std::optional<std::string>(std::getenv("RIGOR_TIER"))
                                             : std::nullopt;
};

/// A system call that fails, as in a kernel that does not have it. If there is a `second`, it fails
/// only if that is its second argument.
struct MissingCall {
    unsigned call;
    std::optional<unsigned> second;
    int error;
};
constexpr MissingCall no_calls = {~0u, {}, ENOSYS};

/// A filter that lets every call pass but one. The kernel keeps it for this process for ever.
void lose(const MissingCall& missing)
{
    const auto load = [](std::size_t offset) {
        return sock_filter(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset)));
    };
    sock_filter code[] = {
        load(offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, missing.call, 0, 3),
        load(offsetof(seccomp_data, args) + 8),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, missing.second.value_or(0), 0,
                 static_cast<std::uint8_t>(missing.second ? 1 : 0)),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(missing.error)),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog filter = {static_cast<unsigned short>(std::size(code)), code};
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter);
}

/// The walls that the launcher finds, in its words, on a kernel without this call.
std::string probed_without(const MissingCall& missing)
{
    const std::string launcher = std::string(RIGOR_BINARY_DIR) + "/bin/confine";
    Ends ends = output_pipe();
    const pid_t child = fork();
    if (child == 0) {
        dup2(ends.write, STDOUT_FILENO);
        lose(missing);
        const std::string user = "--user=" + std::to_string(unused_user());
        execl(launcher.c_str(), launcher.c_str(), "--probe", user.c_str(), nullptr);
        _exit(126);
    }
    int status = -1;
    waitpid(child, &status, 0);
    REQUIRE(status == 0);
    std::string words(512, '\0');
    const ssize_t n = read(ends.read, words.data(), words.size());
    words.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
    return words;
}

} // namespace

TEST_CASE("sandbox: the tier follows from the walls that are possible")
{
    const auto plain = Walls::Namespaces::plain, none = Walls::Namespaces::none;
    REQUIRE(strongest({.namespaces = plain, .filter = true, .listener = true, .landlock = true}) ==
            Tier::a);
    REQUIRE(strongest({.namespaces = none, .filter = true, .landlock = true}) == Tier::b);
    REQUIRE(strongest({.namespaces = none, .filter = true, .listener = true}) == Tier::c);
    REQUIRE(strongest({.namespaces = plain, .filter = true, .listener = true}) == Tier::a);
    REQUIRE(!is_possible(Tier::b, {.namespaces = plain, .filter = true, .listener = true}));
    REQUIRE(strongest({.namespaces = plain, .filter = true}) == Tier::c);
    REQUIRE(strongest({.namespaces = plain, .landlock = true}) == Tier::c);
    REQUIRE(strongest({}) == Tier::c);
    REQUIRE(description(Tier::c) == "C: limits on resources only");
    for (const Tier tier : walled_tiers())
        REQUIRE(description(tier).find("seccomp, ") != std::string::npos);
}

TEST_CASE("sandbox: a wall whose calls the kernel lacks is not there")
{
    const std::string all = probed_without(no_calls);
    const bool has_namespaces = all.find("namespaces=") != std::string::npos;
    const bool has_listener = all.find("seccomp=notify") != std::string::npos;
    CAPTURE(all);
    REQUIRE(has_namespaces == (possible_walls().namespaces != Walls::Namespaces::none));
    REQUIRE(has_listener == possible_walls().listener);
    for (const unsigned call : {SYS_open_tree, SYS_move_mount, SYS_mount_setattr, SYS_unshare}) {
        CAPTURE(call);
        const std::string found = probed_without({call, {}, ENOSYS});
        CHECK(found.find("namespaces=") == std::string::npos);
        CHECK((found.find("seccomp=notify") != std::string::npos) == has_listener);
    }
    // Linux 5.0 to 5.4 do not know the flag in the answer to a listener.
    const std::string old =
        probed_without({SYS_ioctl, static_cast<unsigned>(SECCOMP_IOCTL_NOTIF_SEND), EINVAL});
    CHECK(old.find("seccomp=notify") == std::string::npos);
    CHECK(old.find("seccomp=kill") != std::string::npos);
    CHECK(probed_without({SYS_seccomp, {}, ENOSYS}).find("seccomp") == std::string::npos);
    CHECK(probed_without({SYS_landlock_create_ruleset, {}, ENOSYS}).find("landlock") ==
          std::string::npos);
}

TEST_CASE("sandbox: a weaker tier can be asked for and a stronger one cannot be pretended")
{
    {
        const WantedTier wanted("C");
        REQUIRE(usual_tier() == Tier::c);
    }
    {
        const WantedTier wanted("strong");
        REQUIRE_THROWS_WITH(usual_tier(), "RIGOR_TIER: expected A, B or C, found 'strong'");
    }
    const WantedTier wanted("A");
    if (strongest(possible_walls()) == Tier::a)
        REQUIRE(usual_tier() == Tier::a);
    else
        REQUIRE_THROWS_AS(usual_tier(), InputError);
}

TEST_CASE("sandbox: the user of a run is another each time")
{
    std::set<unsigned> users;
    for (int i = 0; i < 10; ++i)
        users.insert(unused_user());
    REQUIRE(users.size() > 5);
    REQUIRE(*users.begin() > 60000);
}

TEST_CASE("sandbox: a program that cannot be started is an error that names it")
{
    for (const Tier tier : possible_tiers()) {
        CAPTURE(description(tier));
        try {
            run_confined(confinement(Profile::worker, tier), {"/nowhere/worker"});
            FAIL("it was started");
        } catch (const std::system_error& error) {
            REQUIRE(error.code().value() == ENOENT);
            REQUIRE(std::string(error.what()).find("/nowhere/worker") != std::string::npos);
        }
        REQUIRE_THROWS_AS(run_confined(confinement(Profile::worker, tier), {"/etc/passwd"}),
                          std::system_error);
    }
}

TEST_CASE("sandbox: an undumpable process hides its memory and its descriptors")
{
    const pid_t child = fork();
    if (child == 0) {
        make_undumpable();
        struct stat memory = {};
        _exit(prctl(PR_GET_DUMPABLE) == 0 && stat("/proc/self/mem", &memory) == 0 &&
                      memory.st_uid == 0
                  ? 0
                  : 1);
    }
    int status = -1;
    REQUIRE(waitpid(child, &status, 0) == child);
    REQUIRE(status == 0);
}

TEST_CASE("sandbox: ordinary users and root in containers have walls that hold as well", "[root]")
{
    if (geteuid() != 0) {
        SUCCEED("these tests run as an ordinary user already");
        return;
    }
    const std::string self = std::filesystem::read_symlink("/proc/self/exe");
    for (const std::string who : {"--reuid=60699 --regid=60699 --clear-groups",
                                  "--bounding-set=-sys_admin", "--bounding-set=-all"}) {
        CAPTURE(who);
        const std::string as_user = "setpriv " + who + " ";
        const std::string try_files = "test -r " + self + " -a -x " + program("attempt");
        if (std::system((as_user + try_files).c_str()) != 0) {
            WARN("skipped: with " << who << ", " << self << " cannot be read");
            continue;
        }
        REQUIRE(std::system((as_user + self + " '~[root]'").c_str()) == 0);
    }
}

} // namespace rigor
