// SPDX-License-Identifier: MIT
// What a student's test throws about a hidden formula tells nothing about this formula.
#include "graded/validation/without_texts.hpp"

namespace rigor {

namespace {

constexpr const char* confession = "confession: 1 2 3 -> 4";

template <class Thrown> std::string told(const Thrown& thrown)
{
    try {
        testing::without_texts([&]() -> Judgement { throw thrown; });
    } catch (const WorkerFailure& failure) {
        return failure.what() + failure.output;
    } catch (const std::exception& other) {
        return other.what();
    }
    return "";
}

} // namespace

TEST_CASE("hidden texts: a failure keeps its kind and loses its text")
{
    using Cause = WorkerFailure::Cause;
    for (const Cause cause : {Cause::crashed, Cause::exited, Cause::timed_out, Cause::flooded,
                              Cause::malformed, Cause::threw}) {
        WorkerFailure failure(cause, "A8.3 test_tangent", confession);
        failure.output = confession;
        const std::string text = told(failure);
        CAPTURE(text);
        REQUIRE(text.starts_with("A8.3 test_tangent "));
        REQUIRE(text.find("confession") == std::string::npos);
    }
    REQUIRE(told(WorkerFailure(Cause::threw, "A8.3 test_tangent", confession)) ==
            "A8.3 test_tangent threw an exception on a hidden formula; its texts are not shown");
    REQUIRE(told(NotFinite("A8.3 test_tangent", confession)).find("confession") ==
            std::string::npos);
}

TEST_CASE("hidden texts: a stub is told as one and another name is not")
{
    REQUIRE(told(NotImplemented("validation::test_tangent")) == "validation::test_tangent");
    REQUIRE(testing::is_stub_of_test("validation::test_units"));
    for (const char* other : {confession, "fracture::virtual_nodes", "validation::", "test_units"})
        REQUIRE_FALSE(testing::is_stub_of_test(other));
}

TEST_CASE("hidden texts: a judgement passes as it is")
{
    REQUIRE(testing::without_texts([] { return rejected(17); }).rejected_in == 17);
}

} // namespace rigor
