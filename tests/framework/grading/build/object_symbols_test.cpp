// SPDX-License-Identifier: MIT
#include "grading/build/object_symbols.hpp"
#include "support/catch.hpp"

#include <algorithm>

namespace rigor {

namespace {

// Linker names as g++ and clang make them.
const std::string normalized = "_ZN5rigor9normalizeERKNS_10QuaternionE"; // topic `rotation`
const std::string helper = "_Z6helperd", cleanup = "_Z7cleanupv";

ObjectSymbols symbols(const std::string& listing)
{
    return parse_symbols(listing);
}

} // namespace

TEST_CASE("object symbols: strong definitions and uses are told apart", "[build]")
{
    const ObjectSymbols found =
        symbols("f T 0 1\ng U\n_Zh W 0 1\ni t 0 1\nj B 8 4\n_Zk V 0 1\nl w\n");
    REQUIRE(found.defined == std::set<std::string>{"f", "j"});
    REQUIRE(found.undefined == std::set<std::string>{"g"});
    const ObjectSymbols weak =
        symbols("malloc W 0 1\n_Znwm W 0 1\n_ZdlPv V 0 1\nmain u 0 1\nmemcpy i 0 1\n"
                "_ZNSt6vectorIdSaIdEE9push_backEOd W 0 1\n_ZZ1fvE1x u 0 4\n"
                "DW.ref.__gxx_personality_v0 V 0 8\n__clang_call_terminate W 0 1\n");
    REQUIRE(weak.defined == std::set<std::string>{"malloc", "_Znwm", "_ZdlPv", "main", "memcpy"});
    REQUIRE(weak.shared == std::vector<std::string>{"_ZNSt6vectorIdSaIdEE9push_backEOd",
                                                    "_ZZ1fvE1x", "DW.ref.__gxx_personality_v0",
                                                    "__clang_call_terminate"});
    // a formula may be inline, but it is defined
    REQUIRE(symbols(normalized + " W 0 1\n").defined == std::set<std::string>{normalized});
    REQUIRE(symbols(normalized + " W 0 1\n").shared.empty());
    REQUIRE(symbols("").defined.empty());
    REQUIRE(symbols("/usr/bin/nm: x: file format not recognized\n").undefined.empty());
}

TEST_CASE("object symbols: a name that cannot be shown is found", "[build]")
{
    CHECK(line_with_unreadable_name("_Z1gd T 0 43\n.LC0 r 8 \nlost U         \n").empty());
    CHECK(line_with_unreadable_name("_Z7gr\xc3\xb6\xc3\x9f"
                                    "ed T 50 1d\n")
              .empty());
    CHECK(line_with_unreadable_name("/usr/bin/nm: out/collision.o: no symbols\n").empty());
    for (const char* line : {"\033[2Jlost U         ", "a b U         ", "a b 0 0 T 0 1",
                             "\xff T 0 1", "a: no symbols", " T 0 1", "a\tT 0 1"}) {
        CAPTURE(line);
        CHECK(line_with_unreadable_name(std::string("_Z1gd T 0 43\n") + line + "\nb T 0 1\n") ==
              line);
    }
}

TEST_CASE("object symbols: a formula is known by its name with any parameters", "[build]")
{
    const auto is_kept = [](const std::string& name) {
        return names_to_hide({{"rotation", symbols(name + " T 0 1\n")}}).empty();
    };
    for (const char* name : {"_ZN5rigor9normalizeERKNS_10QuaternionE", "_ZN5rigor9normalizeEv",
                             "_ZN5rigor9normalizeEddd"})
        CHECK(is_kept(name));
    for (const char* name : {"_ZN5rigor9normalizeE", "_ZN5rigor10normalizedEv", "_Z9normalizev",
                             "_ZN5rigor9normalize1fEv", "_ZN6rigors9normalizeEv", "normalize"})
        CHECK_FALSE(is_kept(name));
}

TEST_CASE("object symbols: a name that stands for a huge one costs nothing", "[build]")
{
    // Each parameter is a template of the one before, twice: the name doubles 36 times.
    for (const std::string start : {"_Z1f", "_ZN5rigor9normalizeE"}) {
        std::string name = start + "1aIiiE";
        for (const char c : std::string("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"))
            name += std::string("S_IS") + c + "_S" + c + "_E";
        names_to_hide({{"rotation", symbols(name + " T 0 1\n")}});
    }
}

TEST_CASE("object symbols: each file keeps its helpers to itself", "[build]")
{
    const auto hidden = names_to_hide({
        {"inertia", symbols(helper + " T 0 1\n" + normalized + " U\nmain T 0 1\n")},
        {"rotation", symbols(helper + " T 0 1\n" + normalized + " T 0 1\n")},
    });
    REQUIRE(hidden.at("inertia") == std::vector<std::string>{helper, "main"});
    REQUIRE(hidden.at("rotation") == std::vector<std::string>{helper});
}

TEST_CASE("object symbols: a helper that another file uses is shared", "[build]")
{
    const auto hidden = names_to_hide({
        {"inertia", symbols(helper + " U\n")},
        {"rotation", symbols(helper + " T 0 1\n" + cleanup + " T 0 1\n")},
    });
    REQUIRE(hidden.at("rotation") == std::vector<std::string>{cleanup});
    REQUIRE(hidden.count("inertia") == 0);
}

TEST_CASE("object symbols: nobody gets another memcpy than that of the library", "[build]")
{
    const std::map<std::string, ObjectSymbols> objects = {
        {"inertia", symbols("memcpy U\n" + helper + " U\n")},
        {"rotation", symbols("memcpy T 0 1\n" + helper + " T 0 1\n" + normalized + " T 0 1\n")},
    };
    REQUIRE(names_to_hide(objects).empty());
    const auto hidden = names_to_hide(objects, {"memcpy", normalized});
    REQUIRE(hidden.at("rotation") == std::vector<std::string>{"memcpy"});
    REQUIRE(hidden.count("inertia") == 0);
}

TEST_CASE("object symbols: a formula counts in the file of its topic", "[build]")
{
    const auto twice = names_to_hide({
        {"inertia", symbols(normalized + " T 0 1\n")},
        {"rotation", symbols(normalized + " T 0 1\n")},
    });
    REQUIRE(twice.at("inertia") == std::vector<std::string>{normalized});
    REQUIRE(twice.count("rotation") == 0);
    const auto elsewhere = names_to_hide({
        {"contact", symbols(normalized + " T 0 1\n")},
        {"inertia", symbols(normalized + " T 0 1\n")},
    });
    REQUIRE(elsewhere.size() == 1); // one of the two is hidden
}

} // namespace rigor
