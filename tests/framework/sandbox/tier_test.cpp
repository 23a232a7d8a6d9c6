// SPDX-License-Identifier: MIT
// Tests of the tiers: which one it is, who may choose it, and that all other tests of this room
// also pass for an ordinary user.
#include "confine.hpp"
#include "errors/input_error.hpp"
#include "support/catch.hpp"

#include <cstdlib>
#include <set>
#include <sys/prctl.h>
#include <sys/stat.h>
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
