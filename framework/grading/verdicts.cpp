// SPDX-License-Identifier: MIT
#include "grading/verdicts.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace rigor {

namespace {

using nlohmann::json;

std::string text_of(const json& line, const char* key)
{
    const auto found = line.find(key);
    if (found == line.end() || found->is_null()) return "";
    if (found->is_string()) return found->get<std::string>();
    if (found->is_number_float()) return fmt::format("{:.3g}", found->get<double>());
    return found->dump();
}

// A number of the line, 0 if there is none. JSON has null for what is no number.
double number_of(const json& line, const char* key)
{
    const auto found = line.find(key);
    if (found == line.end()) return 0;
    return found->is_null() ? std::numeric_limits<double>::quiet_NaN() : found->get<double>();
}

// The lines of the message without repetitions. The line with the seed is left out, since the seed
// has a field of its own.
std::string message_of(const json& line)
{
    std::istringstream lines(text_of(line, "message"));
    std::vector<std::string> kept;
    for (std::string text; std::getline(lines, text);)
        if (!text.starts_with("seed := ") &&
            std::find(kept.begin(), kept.end(), text) == kept.end())
            kept.push_back(text);
    return fmt::format("{}", fmt::join(kept, "\n"));
}

TestCase test_case(const json& line)
{
    TestCase result;
    result.name = line.at("name").get<std::string>();
    result.message = message_of(line);
    result.hint = text_of(line, "hint");
    result.mistake = text_of(line, "mistake");
    result.is_hidden = line.at("hidden").get<bool>();
    result.seconds = line.at("seconds").get<double>();
    result.largest_error = number_of(line, "largest_error");
    result.expected = text_of(line, "expected");
    result.actual = text_of(line, "actual");
    result.place = text_of(line, "place");
    result.tolerance_class = text_of(line, "class");
    if (!result.expected.empty()) { // numbers were compared
        result.error = text_of(line, "error");
        result.tolerance = text_of(line, "tolerance");
    }
    const auto seed = line.find("seed");
    if (seed != line.end() && seed->is_number_integer() && seed->get<std::int64_t>() >= 0)
        result.seed = seed->get<std::int64_t>();
    return result;
}

} // namespace

void Verdicts::take(std::string_view text)
{
    if (!fault_.empty()) return;
    try {
        const json line = json::parse(text);
        is_complete_ = line.contains("end");
        if (is_complete_) return;
        tag_ = line.at("tag").get<std::string>();
        if (line.contains("begin")) {
            open_ = line.at("begin").get<std::string>();
            return;
        }
        add(line.at("status").get<std::string>(), test_case(line));
        if (line.value("stalled", false)) add_stalled(tests_[tag_].back().name);
        spent_ = text_of(line, "spent");
        cost_ = text_of(line, "cost");
        open_.clear();
    } catch (const json::exception& error) {
        fault_ = fmt::format("not a verdict: {:.200}", text);
    } catch (const std::runtime_error& error) {
        fault_ = error.what();
    }
}

void Verdicts::add(const std::string& status, TestCase&& test)
{
    if (status == "reference_late") late_.insert(tag_);
    if (status == "internal_error" || status == "reference_late") {
        own_failures_.emplace_back(tag_, "in '" + test.name + "': " + test.message);
        test.status = Status::failed;
    } else if (const auto known = status_of(status)) {
        test.status = *known;
    } else {
        throw std::runtime_error("'" + status + "' is no status");
    }
    if (!std::isfinite(test.largest_error)) { // then no comparison can be trusted
        test.largest_error = 0;
        if (test.status == Status::passed) {
            test.status = Status::failed;
            test.message = "the error of a comparison is not a number";
        }
    }
    tests_[tag_].push_back(std::move(test));
}

void Verdicts::add_stalled(const std::string& name)
{
    if (std::find(stalled_.begin(), stalled_.end(), name) != stalled_.end())
        throw std::runtime_error("the test case '" + name + "' ran again");
    stalled_.push_back(name);
}

bool Verdicts::is_given_up(std::string_view tag) const
{
    std::istringstream words(spent_);
    for (std::string word; words >> word;)
        if (word == tag) return true;
    return false;
}

const std::vector<TestCase>& Verdicts::of(const std::string& tag) const
{
    static const std::vector<TestCase> none;
    const auto found = tests_.find(tag);
    return found == tests_.end() ? none : found->second;
}

} // namespace rigor
