// SPDX-License-Identifier: MIT
#include "report/result_json.hpp"

#include "errors/input_error.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace rigor {

namespace {

using json = nlohmann::ordered_json;

json text_or_null(const std::string& text)
{
    return text.empty() ? json(nullptr) : json(text);
}

json case_json(const TestCase& test)
{
    return {{"name", test.name},
            {"status", to_string(test.status)},
            {"visibility", test.is_hidden ? "hidden" : "visible"},
            {"message", text_or_null(test.message)},
            {"seconds", test.seconds}};
}

json task_json(const TaskResult& result)
{
    const TestCase* failure = result.first_failure();
    const TestCase shown = failure ? *failure : TestCase();
    const bool did_not_run = result.tests.empty();
    json cases = json::array();
    for (const TestCase& test : result.tests)
        cases.push_back(case_json(test));
    return {
        {"tag", result.task.tag},
        {"name", result.task.name()},
        {"status", to_string(result.status)},
        {"score", result.score},
        {"max_score", result.max_score},
        {"visibility", result.task.is_hidden ? "hidden" : "visible"},
        {"message", did_not_run ? json("did not run") : text_or_null(failure ? failure->name : "")},
        {"detail", text_or_null(shown.message)},
        {"mistake", nullptr},
        {"expected", text_or_null(shown.expected)},
        {"actual", text_or_null(shown.actual)},
        {"error", text_or_null(shown.error)},
        {"tolerance", text_or_null(shown.tolerance)},
        {"tolerance_class", text_or_null(shown.tolerance_class)},
        {"place", text_or_null(shown.place)},
        {"seed", shown.seed ? json(*shown.seed) : json(nullptr)},
        {"hint",
         failure ? json(shown.hint.empty() ? result.task.hint : shown.hint) : json(nullptr)},
        {"cases", cases}};
}

json result_json(const Result& result)
{
    json tests = json::array();
    for (const TaskResult& task : result.tasks)
        tests.push_back(task_json(task));
    return {{"assignment", result.assignment.name},
            {"submission", result.submission},
            {"status", to_string(result.status)},
            {"message", text_or_null(result.message)},
            {"score", result.score()},
            {"max_score", result.max_score()},
            {"seed", result.seed},
            {"tests", tests},
            {"timing",
             {{"build_seconds", result.build_seconds}, {"test_seconds", result.test_seconds}}},
            {"versions", {{"rigor", RIGOR_VERSION}, {"compiler", RIGOR_COMPILER}}}};
}

} // namespace

std::string to_json(const std::vector<Result>& results)
{
    json value = json::array();
    for (const Result& result : results)
        value.push_back(result_json(result));
    if (results.size() == 1) value = json(value[0]);
    return value.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

void write_whole(const std::filesystem::path& file, const std::string& content)
{
    const std::string draft = file.string() + ".new";
    const auto fail = [&] {
        throw InputError(file.string() + ": cannot be written: " + std::strerror(errno));
    };
    const int descriptor = open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor < 0) fail();
    bool ok = true;
    for (std::size_t sent = 0; ok && sent < content.size();) {
        const ssize_t n = write(descriptor, content.data() + sent, content.size() - sent);
        ok = n > 0;
        if (ok) sent += static_cast<std::size_t>(n);
    }
    // fsync before the rename: after a crash there is either the old file or the new one.
    ok = fsync(descriptor) == 0 && ok;
    close(descriptor);
    if (!ok || rename(draft.c_str(), file.c_str()) != 0) fail();
}

} // namespace rigor
