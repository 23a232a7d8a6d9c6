// SPDX-License-Identifier: MIT
// Whole submissions, from their folder to result.json: those of the demo, and some
// that do not compile.
#include "checked.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <regex>
#include <set>

namespace rigor::testing {

namespace {

std::filesystem::path sample(const std::string& name)
{
    return std::filesystem::path(RIGOR_SOURCE_DIR) / "tests/samples" / name;
}

// The tasks that did not pass, each with its status, such as "A2.4 timed_out".
std::set<std::string> not_passed(const json& result)
{
    std::set<std::string> tasks;
    for (const json& test : result["tests"])
        if (test["status"] != "passed")
            tasks.insert(test["tag"].get<std::string>() + ' ' + test["status"].get<std::string>());
    return tasks;
}

using Statuses = std::set<std::string>;

const std::string combine_start =
    "#include \"formulas/inertia.hpp\"\nnamespace rigor {\n"
    "MassProperties combine(const MassProperties& a, const MassProperties& b)\n";

} // namespace

TEST_CASE("submission: the complete sample has every point", "[cli][submission]")
{
    const Checked checked = check({"a2-inertia"}, sample("complete"));
    REQUIRE(not_passed(checked.result) == Statuses());
    REQUIRE(checked.result["score"] == checked.result["max_score"]);
    REQUIRE(checked.status == 0);
}

TEST_CASE("submission: the half done sample fails where its mistakes are", "[cli][submission]")
{
    const Checked checked = check({"a2-inertia"}, sample("half_done"));
    REQUIRE(not_passed(checked.result) ==
            Statuses{"A2.2 failed", "A2.4 not_implemented", "A2.5 not_finite", "A2.8 failed",
                     "A2.11 not_implemented", "A2.12 not_implemented", "A2.13 not_implemented",
                     "A2.14 failed", "A2.15 not_implemented", "A2.16 not_implemented",
                     "A2.17 not_implemented"});
    REQUIRE(checked.status == 1);
}

TEST_CASE("submission: a crash and an endless loop cost their own tasks only", "[cli][submission]")
{
    const Checked checked = check({"a2-inertia"}, sample("crashing"));
    REQUIRE(not_passed(checked.result) ==
            Statuses{"A2.4 timed_out", "A2.11 crashed", "A2.13 not_implemented"});
    REQUIRE(checked.status == 1);
}

TEST_CASE("submission: an error in an earlier assignment is paid for there alone",
          "[.long][cli][submission]")
{
    if (!std::filesystem::is_directory(std::string(RIGOR_SOURCE_DIR) + "/reference")) return;
    const TemporaryFolder folder;
    std::filesystem::copy_file(sample("complete") / "inertia.cpp", folder.path() / "inertia.cpp");
    const std::string wrong = "#include \"formulas/kinematics.hpp\"\nnamespace rigor {\n"
                              "Vector3d point_velocity(const Vector3d& V, const Vector3d&, "
                              "const Vector3d&, const Vector3d&)\n{\n    return V;\n}\n}\n";
    // First the whole assignment, where the formulas of A1 are missing; then a formula and a short
    // scene, where a formula of A1 is wrong.
    const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
        {"", {"a2-inertia"}}, {wrong, {"A2.3", "A2.16"}}};
    for (const auto& [earlier, what] : cases) {
        folder.write("kinematics.cpp", earlier);
        const Checked checked = check(what, folder.path());
        CAPTURE(checked.said);
        REQUIRE(not_passed(checked.result) == Statuses());
        REQUIRE(checked.result["score"] == checked.result["max_score"]);
        for (const json& test : checked.result["tests"]) {
            const bool is_scene = test["tag"] == "A2.15" || test["tag"] == "A2.16";
            REQUIRE(test["follow_through"] == is_scene);
        }
        REQUIRE(check({"A1.10"}, folder.path()).result["score"] == 0);
    }
}

TEST_CASE("submission: the reference answers in place of others, and never for the task itself",
          "[cli][submission]")
{
    if (!std::filesystem::is_directory(std::string(RIGOR_SOURCE_DIR) + "/reference")) return;
    std::ifstream file(sample("complete") / "inertia.cpp");
    const std::string whole(std::istreambuf_iterator<char>(file), {});
    const std::regex returned("return R \\* \\(I_body_inverse");
    const TemporaryFolder folder;
    // The first code calls a missing formula of A1. The reference answers such a formula where the
    // engine or a test calls it, but not where the submission does. The second code is wrong.
    for (const std::string before : {"cross_matrix(Vector3d(0, 0, 0)) + ", "2 * "}) {
        folder.write(
            "inertia.cpp",
            "#include \"formulas/kinematics.hpp\"\n" +
                std::regex_replace(whole, returned, "return " + before + "R * (I_body_inverse"));
        const Checked checked = check({"A2.3", "A2.16"}, folder.path());
        CAPTURE(before, checked.said);
        REQUIRE(checked.result["status"] == "graded");
        REQUIRE(checked.result["tests"][0]["score"] == 0);
        REQUIRE(checked.result["tests"][1]["status"] != "passed"); // some laws may hold
    }
}

TEST_CASE("submission: a wrong answer is explained in one sentence", "[cli][submission]")
{
    if (!std::filesystem::is_directory(std::string(RIGOR_SOURCE_DIR) + "/reference")) return;
    const TemporaryFolder folder;
    folder.write("inertia.cpp",
                 "#include \"formulas/inertia.hpp\"\nnamespace rigor {\n"
                 "Matrix3d world_inverse_inertia(const Matrix3d& R, const Matrix3d& I)\n"
                 "{\n    return 3 * R * I * R.transpose();\n}\n}\n");
    const Checked checked = check({"A2.3"}, folder.path());
    CAPTURE(checked.said);
    const json& mistake = checked.result["tests"][0]["mistake"];
    REQUIRE(mistake.is_string());
    REQUIRE(
        mistake.get<std::string>().starts_with("Your answer is 3 times the right one, on all "));
    REQUIRE(checked.said.find("the mistake   Your answer is 3 times the right one") !=
            std::string::npos);
}

TEST_CASE("submission: the laws of the topic come before the universal ones", "[cli][submission]")
{
    const TemporaryFolder folder;
    folder.write(
        "pipeline.cpp",
        "#include \"formulas/pipeline.hpp\"\nnamespace rigor {\n"
        "double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)\n"
        "{\n    return 1;\n}\n}\n");
    const Checked checked = check({"A0.1"}, folder.path());
    CAPTURE(checked.said);
    const json& test = checked.result["tests"][0];
    const auto is_universal = [](const json& one) {
        return one["name"].get<std::string>().starts_with("pipeline: kinetic_energy ");
    };
    const json& cases = test["cases"];
    REQUIRE(std::is_partitioned(cases.begin(), cases.end(), std::not_fn(is_universal)));
    REQUIRE(!is_universal(cases.front()));
    REQUIRE(is_universal(cases.back()));
    REQUIRE(test["message"] == cases.front()["name"]); // the first one that is broken
}

TEST_CASE("submission: a syntax error is told with file and line", "[cli][submission]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", combine_start + "{\n    return a\n}\n}\n");
    const Checked checked = check({"A2.14"}, folder.path());
    REQUIRE(checked.status == 1);
    REQUIRE(checked.result["status"] == "compile_error");
    const std::string message = checked.result["message"];
    CAPTURE(message);
    REQUIRE(message.find("inertia.cpp:5:") != std::string::npos);
    REQUIRE(message.find("error: expected") != std::string::npos);
    REQUIRE(checked.result["score"] == 0);
    REQUIRE(checked.result["max_score"] > 0);
}

TEST_CASE("submission: a file that nobody asked for may be broken", "[cli][submission]")
{
    const TemporaryFolder folder;
    std::filesystem::copy_file(sample("complete") / "inertia.cpp", folder.path() / "inertia.cpp");
    folder.write("plasticity.cpp", "not C++\n");
    const Checked asked = check({"A2.14"}, folder.path());
    REQUIRE(asked.status == 0);
    REQUIRE(asked.said.find("plasticity.cpp does not compile: its formulas are missing") !=
            std::string::npos);
    for (const char* what : {"A6.1", "a2"}) {
        folder.write(what == std::string("a2") ? "inertia.cpp" : "plasticity.cpp", "not C++\n");
        const Checked broken = check({what}, folder.path());
        REQUIRE(broken.result["status"] == "compile_error");
        REQUIRE(broken.status == 1);
    }
}

TEST_CASE("submission: a function that is not there costs its own task", "[cli][submission]")
{
    const TemporaryFolder folder;
    std::ifstream file(sample("complete") / "inertia.cpp");
    const std::string whole(std::istreambuf_iterator<char>(file), {});
    folder.write("inertia.cpp", std::regex_replace(whole, std::regex(" combine\\("), " union_of("));
    const Checked checked = check({"A2.14", "A2.7"}, folder.path());
    REQUIRE(checked.result["status"] == "graded");
    REQUIRE(not_passed(checked.result) == Statuses{"A2.14 compile_error"});
    const std::string message = checked.result["tests"][1]["detail"];
    REQUIRE(message.starts_with("A2.14 combine is not defined"));
}

TEST_CASE("submission: another signature costs its own task", "[cli][submission]")
{
    const TemporaryFolder folder;
    folder.write("inertia.cpp", combine_start + "{\n    return a.mass > 0 ? a : b;\n}\n}\n");
    const Checked checked = check({"A2.14", "A2.7"}, folder.path());
    REQUIRE(checked.result["status"] == "graded");
    REQUIRE(not_passed(checked.result) == Statuses{"A2.7 compile_error", "A2.14 failed"});
}

namespace {

// Requires that a submission that includes the reference gets no points and is told why: behind
// walls the compiler finds no such file, and without walls the file is refused.
void require_refused(const TemporaryFolder& folder, const std::string& why = "")
{
    const Checked checked = check({"a0-pipeline"}, folder.path());
    REQUIRE(checked.status == 1);
    REQUIRE(checked.result["status"] == "compile_error");
    REQUIRE(checked.result["score"] == 0);
    const std::string message = checked.result["message"];
    CAPTURE(message);
    const auto says = [&](const std::string& words) {
        return message.find(words) != std::string::npos;
    };
    REQUIRE((why.empty() ? says("No such file or directory") || says("file not found") ||
                               says("a solution may include framework/formulas/, its own folder")
                         : message == why));
}

} // namespace

TEST_CASE("submission: including the reference is refused", "[cli][submission]")
{
    const std::filesystem::path tree = std::filesystem::canonical(RIGOR_SOURCE_DIR);
    const std::filesystem::path reference = tree / "reference/pipeline.cpp";
    if (!std::filesystem::exists(reference)) return;
    const TemporaryFolder folder;

    SECTION("by its absolute path")
    {
        folder.write("pipeline.cpp", "#include \"" + reference.string() + "\"\n");
        require_refused(folder);
    }
    SECTION("by a relative path, in a macro, in a header of the submission's own")
    {
        const auto path = reference.lexically_relative(std::filesystem::canonical(folder.path()));
        folder.write("own/solved.hpp", "#define SOLVED \"../" + path.string() + "\"\n" +
                                           "#pragma GCC system_header\n#include SOLVED\n");
        folder.write("pipeline.cpp", "#include \"own/solved.hpp\"\n");
        require_refused(folder);
    }
    SECTION("by a link to the file")
    {
        create_symlink(reference, folder.path() / "solved.hpp");
        folder.write("pipeline.cpp", "#include \"solved.hpp\"\n");
        require_refused(folder);
    }
    SECTION("by the way up from a link to another folder")
    {
        create_directory_symlink(tree / "framework", folder.path() / "link");
        folder.write("reference/pipeline.cpp", "");
        folder.write("pipeline.cpp", "#include \"link/../reference/pipeline.cpp\"\n");
        require_refused(folder);
    }
    SECTION("as the file itself")
    {
        create_symlink(reference, folder.path() / "pipeline.cpp");
        require_refused(folder, "pipeline.cpp: expected a file, found a link\n");
    }
}

TEST_CASE("submission: what was not handed in gets no points for student/", "[cli][submission]")
{
    const TemporaryFolder folder;
    copy_file(sample("complete") / "inertia.cpp", folder.path() / "inertia.cpp");
    const Run run = rigor({"check", "a3", "--with", folder.path().string()});
    CAPTURE(run.output);
    REQUIRE(run.status == 2);
    REQUIRE(run.output.find("expected rotation.cpp, which a3-rotation is about") !=
            std::string::npos);
}

TEST_CASE("submission: a header of its own is no reason to refuse", "[cli][submission]")
{
    const TemporaryFolder folder;
    create_directory(folder.path() / "a # b");
    copy_file(sample("complete") / "inertia.cpp", folder.path() / "a # b/solved $1.hpp");
    folder.write("inertia.cpp", "#include \"a # b/solved $1.hpp\"\n");
    REQUIRE(check({"A2.14"}, folder.path()).status == 0);
}

TEST_CASE("submission: helpers of one name and a main of its own cost nothing", "[cli][submission]")
{
    const TemporaryFolder folder;
    for (const char* topic : {"inertia", "rotation"})
        folder.write(std::string(topic) + ".cpp",
                     "#include \"complete_" + std::string(topic) +
                         ".hpp\"\n"
                         "double helper(double x) { return x; }\nint counter = 3;\n"
                         "int main() { return static_cast<int>(helper(counter)); }\n");
    std::ifstream complete(sample("complete") / "inertia.cpp");
    folder.write("complete_inertia.hpp", {std::istreambuf_iterator<char>(complete), {}});
    folder.write("complete_rotation.hpp", "");
    const Checked checked = check({"A2.14", "A2.7"}, folder.path());
    REQUIRE(not_passed(checked.result) == Statuses());
    REQUIRE(checked.status == 0);
}

TEST_CASE("submission: inline functions of one name in two files cost nothing", "[cli][submission]")
{
    const TemporaryFolder folder;
    const auto factor = [](const char* value) {
        return std::string("namespace rigor {\nstruct Factor {\n"
                           "    [[gnu::noinline]] static double of(double x) { return ") +
               value +
               " * x; }\n};\n"
               "[[gnu::noinline]] inline double square(double x) { return Factor::of(x) * x / " +
               value + "; }\n";
    };
    folder.write("pipeline.cpp",
                 "#include \"formulas/pipeline.hpp\"\n" + factor("0.5") +
                     "double kinetic_energy(double m, const Vector3d& v, const "
                     "Matrix3d& I, const Vector3d& w)\n"
                     "{\n    return Factor::of(m * v.squaredNorm() + w.dot(I * w));\n"
                     "}\n}\n");
    folder.write("inertia.cpp",
                 "#include \"formulas/inertia.hpp\"\n" + factor("0.4") +
                     "MassProperties solid_sphere(double density, double r)\n{\n"
                     "    const double M = density * 4 / 3 * 3.14159265358979323846 * r * r * r;\n"
                     "    return {M, Vector3d::Zero(), Factor::of(M * square(r)) * "
                     "Matrix3d::Identity()};\n}\n}\n");
    for (const char* tag : {"A0.1", "A2.6"}) {
        CAPTURE(tag);
        REQUIRE(not_passed(check({tag}, folder.path()).result) == Statuses());
    }
}

TEST_CASE("submission: a name that is defined nowhere costs those who call it", "[cli][submission]")
{
    const TemporaryFolder folder;
    std::ifstream complete(sample("complete") / "inertia.cpp");
    const std::string whole(std::istreambuf_iterator<char>(complete), {});
    folder.write("inertia.cpp",
                 "#include \"formulas/inertia.hpp\"\nnamespace rigor {\ndouble lost(double);\n"
                 "MassProperties combine(const MassProperties& a, const MassProperties&)\n"
                 "{\n    return lost(1) > 0 ? a : a;\n}\n}\n#define combine combined\n" +
                     whole);
    const Checked checked = check({"A2.14", "A2.7"}, folder.path());
    REQUIRE(not_passed(checked.result) == Statuses{"A2.14 crashed"});
    const std::string note = checked.result["notes"][0];
    REQUIRE(note.ends_with(" calls rigor::lost(double), which is defined nowhere"));
    REQUIRE(checked.said.find(note) != std::string::npos);
}

TEST_CASE("submission: a compiler without end costs a file and not the night", "[cli][submission]")
{
    const TemporaryFolder folder;
    copy_file(sample("complete") / "inertia.cpp", folder.path() / "inertia.cpp");
    folder.write("rotation.cpp", "#include \"rotation.cpp\"\n");
    folder.write("contact.cpp", "template <int n> struct S : S<n + 1>, S<n + 2> {};\nS<0> s;\n");
    const Checked checked = check({"A2.14", "A3.1"}, folder.path());
    REQUIRE(checked.result[0]["score"] == checked.result[0]["max_score"]);
    REQUIRE(checked.result[1]["status"] == "compile_error");
}

} // namespace rigor::testing
