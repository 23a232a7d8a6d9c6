// SPDX-License-Identifier: MIT
// A class whose submissions change while they are graded. The engine of these tests grades nothing:
// it changes submissions, and passes on a result.
#include "grading/class/grade_class.hpp"

#include "framework/grading/class/one_task.hpp"
#include "grading/class/fingerprint.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"

#include <functional>

namespace rigor::testing::grade_class_test {

namespace {

// @param during  called while a submission is graded
class FakeEngine : public Engine {
public:
    explicit FakeEngine(std::function<void(const Submission&)> during) : during_(std::move(during))
    {
    }

    std::string grade(const ClassWork& work, const std::vector<std::size_t>& numbers,
                      const OnGraded& on_graded, const OnWait&) override
    {
        for (const std::size_t i : numbers) {
            during_(work.submissions[i]);
            Submission refused = work.submissions[i];
            refused.refusal = "refused";
            on_graded(
                i, graded_submission(work.selection, refused, work.run, "", work.fingerprints[i]));
            graded.push_back(work.submissions[i].name);
        }
        return "";
    }

    std::vector<std::string> graded;

private:
    std::function<void(const Submission&)> during_;
};

// A class of three submissions.
struct SmallClass {
    SmallClass()
    {
        work.selection = one_task();
        work.fingerprint = 1;
        for (const char* name : {"alice", "bob", "carol"})
            work.submissions.push_back({name, folder.write(std::string(name) + ".cpp", "1\n"), ""});
    }
    ClassOutcome graded(Engine& engine) const
    {
        const ClassFolder results(folder.path() / "out", "a2-inertia", {"alice", "bob", "carol"});
        return grade_class(work, results, engine, {}, OldResults::are_replaced);
    }

    TemporaryFolder folder;
    ClassWork work;
};

} // namespace

TEST_CASE("class: a submission that changes while it is graded is graded once more", "[class]")
{
    const SmallClass small;
    FakeEngine engine([&, times = 0](const Submission& submission) mutable {
        if (submission.name == "bob" && ++times == 1) small.folder.write("bob.cpp", "2\n");
    });
    const ClassOutcome outcome = small.graded(engine);
    CHECK(engine.graded.size() == 4);
    CHECK(engine.graded.back() == "bob");
    REQUIRE(outcome.rows.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(outcome.rows[i].status == "rejected");
        CHECK(outcome.rows[i].fingerprint == fingerprint_of(small.work.submissions[i], 1));
    }
    FakeEngine again([](const Submission&) {});
    CHECK(small.graded(again).graded == 0);
}

TEST_CASE("class: a submission that changes all the time has no points until it rests", "[class]")
{
    const SmallClass small;
    FakeEngine engine([&, text = std::string()](const Submission& submission) mutable {
        if (submission.name == "bob") small.folder.write("bob.cpp", text += "x");
    });
    const ClassOutcome outcome = small.graded(engine);
    CHECK(engine.graded.size() == 4);
    REQUIRE(outcome.rows.size() == 3);
    CHECK(outcome.rows[0].status == "rejected");
    CHECK(outcome.rows[1].status == "internal_error");
    CHECK(outcome.rows[1].message.find("changed while it was graded") != std::string::npos);
    CHECK(outcome.rows[1].fingerprint.empty());
    FakeEngine again([](const Submission&) {});
    CHECK(small.graded(again).rows[1].status == "rejected");
    CHECK(again.graded == std::vector<std::string>{"bob"});
}

} // namespace rigor::testing::grade_class_test
