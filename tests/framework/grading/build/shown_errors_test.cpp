// SPDX-License-Identifier: MIT
#include "grading/build/shown_errors.hpp"
#include "grading/places.hpp"
#include "support/catch.hpp"

#include <csignal>
#include <fmt/format.h>
#include <string>

namespace rigor::testing::shown_errors_test {

TEST_CASE("shown errors: what a compiler says about its options is left out", "[build]")
{
    CHECK(shown_errors("a.cpp:1:2: fatal error: template instantiation depth exceeds maximum of "
                       "900 (use '-ftemplate-depth=' to increase the maximum)\n"
                       "    1 | x\ncompilation terminated.\n") ==
          "| a.cpp:1:2: fatal error: template instantiation depth exceeds maximum of 900\n"
          "|     1 | x\n");
    CHECK(shown_errors("a.cpp:1:9: error: #include nested depth 200 exceeds maximum of 200 (use "
                       "-fmax-include-depth=DEPTH to increase the maximum)\n") ==
          "| a.cpp:1:9: error: #include nested depth 200 exceeds maximum of 200\n");
    CHECK(shown_errors("a.cpp:1:35: fatal error: recursive template instantiation exceeded maximum "
                       "depth of 1024\na.cpp:1:35: note: use -ftemplate-depth=N to increase "
                       "recursive template instantiation depth\n1 error generated.\n") ==
          "| a.cpp:1:35: fatal error: recursive template instantiation exceeded maximum depth of "
          "1024\n");
    for (const char* last : {"compilation terminated due to -fmax-errors=20.",
                             "fatal error: too many errors emitted, stopping now [-ferror-limit=]"})
        CHECK(shown_errors("a.cpp:1:2: error: no\n" + std::string(last) + "\n") ==
              "| a.cpp:1:2: error: no\n| (there are more errors: the compiler stopped here)\n");
}

TEST_CASE("shown errors: no path of this machine is in them", "[build]")
{
    const std::string source = places().source.string(), build = places().build.string();
    CHECK(shown_errors(source + "/framework/formulas/a.hpp:1:2: error: no\n") ==
          "| framework/formulas/a.hpp:1:2: error: no\n");
    CHECK(shown_errors("a.cpp:1:2: error: no\nIn file included from " + build +
                       "/framework/CMakeFiles/eigen_precompiled.dir/cmake_pch.hxx:5,\n"
                       "c++: error: '" +
                       build + "/x.dir/cmake_pch.hxx.gch' is old\n") ==
          "| a.cpp:1:2: error: no\n| In file included from the precompiled headers:5,\n"
          "| c++: error: 'the precompiled headers' is old\n");
}

TEST_CASE("shown errors: a question about the age of a file has no answer", "[build]")
{
    const std::string error = "a.cpp:1:2: error: no\n", last = "a.cpp:9:2: error: too\n";
    for (const char* answer : {"cannot find source file /home/b/x", "current file is older than x"})
        CHECK(shown_errors(error + "a.cpp:2:24: warning: " + answer +
                           "\n    2 | #pragma GCC dependency \"x\"\n      |   ^\n" + last) ==
              shown_errors(error + last));
}

TEST_CASE("shown errors: a file of others looks like none", "[build]")
{
    const auto gcc = [](const std::string& reason) {
        return shown_errors("a.cpp:1:10: fatal error: /home/b/x: " + reason + "\n");
    };
    const auto clang = [](const std::string& words) {
        return shown_errors("a.cpp:1:10: fatal error: " + words + "\n");
    };
    CHECK(gcc("Permission denied") == gcc("No such file or directory"));
    CHECK(gcc("Not a directory") == gcc("No such file or directory"));
    CHECK(clang("cannot open file '/home/b/x': Permission denied") ==
          clang("'/home/b/x' file not found"));
}

TEST_CASE("shown errors: each limit of a tool is known by its words", "[build]")
{
    using enum ToolLimit;
    const auto met = [](int signal, const std::string& output) {
        ConfinedRun run;
        run.signal = signal;
        run.output = output;
        return limit_met(run, 60);
    };
    CHECK(met(0, "c++: internal compiler error: File size limit exceeded signal terminated "
                 "program as\n") == file_size);
    CHECK(met(0, "c++: fatal error: CPU time limit exceeded signal terminated program "
                 "cc1plus\n") == time);
    for (const char* words : {"cc1plus: out of memory allocating 65536 bytes after a total of 9\n",
                              "virtual memory exhausted: Cannot allocate memory\n",
                              "LLVM ERROR: out of memory\n", "as: memory exhausted\n",
                              "terminate called after throwing an instance of 'std::bad_alloc'\n"})
        CHECK(met(0, words) == memory);
    CHECK(met(0, "a.cpp:1:2: error: no\n") == none);
    // What a line of the student says is not the tool's word, with or without a number before it.
    for (const char* words : {"CPU time limit exceeded", ": out of memory", "std::bad_alloc"})
        for (const char* shown :
             {"a.cpp:1:2: error: #error {}\n    1 | #error {}\n      |  ^~~~~\n",
              "a.cpp:1:2: error: {}\n#error {}\n ^\n"})
            CHECK(met(0, fmt::format(fmt::runtime(shown), words, words)) == none);
    CHECK(met(SIGXFSZ, "Stack dump:\n") == file_size);
    CHECK(met(SIGXCPU, "") == time);
    CHECK(met(SIGSEGV, "") == none);
}

TEST_CASE("shown errors: a tool that was killed has met its limit on time or none of its own",
          "[build]")
{
    ConfinedRun run;
    const auto check_killed = [&] {
        run.processor_seconds = 3;
        CHECK(limit_met(run, 60) == ToolLimit::none);
        run.processor_seconds = 59;
        CHECK(limit_met(run, 60) == ToolLimit::time);
    };
    run.signal = SIGKILL;
    check_killed();
    run.signal = 0;
    for (const char* words : {"c++: fatal error: Killed signal terminated program cc1plus\n",
                              "collect2: fatal error: ld terminated with signal 9 [Killed]\n",
                              "clang: error: unable to execute command: Killed\n"}) {
        run.output = words;
        check_killed();
    }
}

} // namespace rigor::testing::shown_errors_test
