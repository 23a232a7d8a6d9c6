// SPDX-License-Identifier: MIT
#include "release/autograder.hpp"

#include "grading/places.hpp"
#include "release/autograder_proof.hpp"
#include "release/proof.hpp"
#include "release/zip.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <algorithm>

namespace rigor::testing {

namespace {

Assignment collision()
{
    return load_assignment(places().assignments() / "a4-collision/assignment.json");
}

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
        ++n;
    return n;
}

bool has(const ReleasedTree& tree, const std::string& path, bool is_executable)
{
    return std::any_of(tree.begin(), tree.end(), [&](const ReleasedFile& file) {
        return file.path == path && file.is_executable == is_executable;
    });
}

} // namespace

TEST_CASE("release: an autograder has its two scripts at the top and all that grades",
          "[release][gradescope]")
{
    const ReleasedTree tree = gradescope_tree(places().source, collision(), "");
    CHECK(has(tree, "setup.sh", true));
    CHECK(has(tree, "run_autograder", true));
    CHECK(has(tree, "rigor/rigor", true));
    for (const char* path :
         {"rigor/reference/collision.cpp", "rigor/tests/graded/hidden/collision_test.cpp",
          "rigor/framework/rigid/bodies/optimised_forms.hpp", "rigor/student/collision.cpp"})
        CHECK(has(tree, path, false));
    for (const ReleasedFile& file : tree) {
        // A right collision.cpp calls a formula of kinematics, which is therefore solved.
        if (file.path == "rigor/student/kinematics.cpp")
            CHECK(count(file.content, "NotImplemented") == 0);
        if (file.path == "rigor/student/inertia.cpp")
            CHECK(count(file.content, "NotImplemented") > 0);
    }
    for (const ReleasedFile& file : tree)
        if (file.path == "setup.sh" || file.path == "run_autograder") {
            CHECK(file.content.starts_with("#!/usr/bin/env bash\n"));
            CHECK(count(file.content, "ASSIGNMENT") == 0);
            CHECK(count(file.content, "a4-collision") == 1);
        }
}

TEST_CASE("release: an autograder with a secret draws other random cases", "[release][gradescope]")
{
    const std::string secret = "a secret of the course";
    for (const bool has_secret : {false, true}) {
        CAPTURE(has_secret);
        const ReleasedTree tree =
            gradescope_tree(places().source, collision(), has_secret ? secret : "");
        CHECK(has(tree, "secret", false) == has_secret);
        for (const ReleasedFile& file : tree) {
            if (file.path == "secret") CHECK(file.content == secret + "\n");
            if (file.path == "run_autograder")
                CHECK(count(file.content, "--jobs 1 --secret \"$home/source/secret\"\n") ==
                      (has_secret ? 1 : 0));
            if (file.path == "run_autograder") CHECK(count(file.content, "OPTIONS") == 0);
        }
    }
}

TEST_CASE("release: a zip gives back its files and is the same each time", "[release][gradescope]")
{
    const ReleasedTree tree = {{"a/b.txt", std::string(100000, 'x') + "\n", false},
                               {"empty", "", false},
                               {"run", "#!/bin/sh\n", true}};
    const std::string bytes = zip_of(tree);
    CHECK((zip_of(tree) == bytes));
    const TemporaryFolder folder;
    const ReleasedTree found = unzipped(folder.write("tree.zip", bytes));
    REQUIRE(found.size() == tree.size());
    for (std::size_t i = 0; i < tree.size(); ++i) {
        CHECK(found[i].path == tree[i].path);
        CHECK((found[i].content == tree[i].content));
        CHECK(found[i].is_executable == tree[i].is_executable);
    }
    CHECK_THROWS(unzipped(folder.write("cut.zip", bytes.substr(0, bytes.size() / 2))));
}

TEST_CASE("release: the workflow has a step for each visible task and reports all of them",
          "[release][classroom]")
{
    const Assignment assignment = collision();
    const std::string text = classroom_workflow(assignment);
    CAPTURE(text);
    // GitHub Classroom finds the points only under these names.
    CHECK(count(text, "\nname: Autograding Tests\n") == 1);
    CHECK(count(text, "\n  run-autograding-tests:\n") == 1);
    std::size_t visible = 0;
    double points = 0;
    for (const Task& task : assignment.tasks) {
        const std::string command = "command: ./rigor check " + task.tag + "\n";
        CHECK(count(text, command) == (task.is_hidden ? 0 : 1));
        visible += !task.is_hidden;
        points += task.is_hidden ? 0 : task.points;
    }
    REQUIRE(visible > 5);
    CHECK(count(text, "autograding-command-grader@v1") == visible);
    CHECK(count(text, "autograding-grading-reporter@v1") == 1);
    CHECK(count(text, "_RESULTS: \"${{steps.a4-") == visible);
    CHECK(count(text, ",a4-") == visible - 1);
    double sum = 0;
    const std::string key = "max-score: ";
    for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos; at += key.size())
        sum += std::stod(text.substr(at + key.size()));
    CHECK(sum == points);
    CHECK(text.find('\t') == std::string::npos);
}

TEST_CASE("release: a wrong tree is found by its results", "[release]")
{
    const auto results = [](const std::string& status, double score, double most,
                            const std::string& visibility) {
        return R"([{"assignment": "a0-pipeline", "status": "graded", "message": null, "tests": [)"
               R"({"tag": "A0.1", "status": ")" +
               status + R"(", "score": )" + std::to_string(score) + R"(, "max_score": )" +
               std::to_string(most) + R"(, "visibility": ")" + visibility + R"("}]}])";
    };
    TreeProof proof;
    CHECK(fault_of_tree(results("not_implemented", 0, 2, "visible"), false, proof).empty());
    CHECK(proof.tasks == 1);
    CHECK(proof.points == 2);
    CHECK(fault_of_tree(results("passed", 2, 2, "visible"), true, proof).empty());
    CHECK(!fault_of_tree(results("passed", 2, 2, "visible"), false, proof).empty());
    CHECK(!fault_of_tree(results("failed", 0, 2, "visible"), false, proof).empty());
    CHECK(!fault_of_tree(results("failed", 0, 2, "visible"), true, proof).empty());
    CHECK(!fault_of_tree(results("skipped", 0, 0, "visible"), false, proof).empty());
    CHECK(!fault_of_tree(results("passed", 2, 2, "hidden"), true, proof).empty());
    CHECK(!fault_of_tree(results("skipped", 0, 0, "hidden"), true, proof).empty()); // none visible
    CHECK(!fault_of_tree("[]", true, proof).empty());
    CHECK(!fault_of_tree("no JSON", true, proof).empty());
}

TEST_CASE("release: wrong points of an autograder are found", "[release][gradescope]")
{
    const std::string good = R"({"score": 3, "tests": [{"score": 1, "max_score": 1},
                                                       {"score": 2, "max_score": 2}]})";
    CHECK(fault_of_results(good, 3, 3).empty());
    CHECK(!fault_of_results(good, 0, 3).empty());
    CHECK(!fault_of_results(good, 3, 4).empty());
    CHECK(!fault_of_results(R"({"score": 3, "tests": []})", 3, 3).empty());
    CHECK(!fault_of_results("", 3, 3).empty());
}

} // namespace rigor::testing
