// SPDX-License-Identifier: MIT
// Results of benchmarks as a table or as JSON, and the timing of functions.
#include "support/bench/bench.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string_view>
#include <thread>

namespace rigor {

namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Bench::Value& value)
{
    if (const std::string* text = std::get_if<std::string>(&value)) return *text;
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.4g", std::get<double>(value));
    return buffer;
}

// Columns on a terminal: the number of code points, not of bytes.
std::size_t width_of(const std::string& text)
{
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void print_padded(const std::string& text, std::size_t width)
{
    std::printf("  %s%*s", text.c_str(), static_cast<int>(width - std::min(width, width_of(text))),
                "");
}

bool same_keys(const Bench::Row& a, const Bench::Row& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& x, const auto& y) { return x.first == y.first; });
}

void print_table(const Bench::Row* first, const Bench::Row* last)
{
    std::vector<std::size_t> widths;
    for (std::size_t column = 0; column < first->size(); ++column) {
        std::size_t width = width_of((*first)[column].first);
        for (const Bench::Row* row = first; row != last; ++row)
            width = std::max(width, width_of(text_of((*row)[column].second)));
        widths.push_back(width);
    }
    for (std::size_t column = 0; column < first->size(); ++column)
        print_padded((*first)[column].first, widths[column]);
    std::printf("\n");
    for (const Bench::Row* row = first; row != last; ++row) {
        for (std::size_t column = 0; column < row->size(); ++column)
            print_padded(text_of((*row)[column].second), widths[column]);
        std::printf("\n");
    }
    std::printf("\n");
}

Json json_of(const Bench::Row& row)
{
    Json object = Json::object();
    for (const auto& [key, value] : row)
        std::visit([&object, &name = key](const auto& v) { object[name] = v; }, value);
    return object;
}

// The mean number of processes in the last minute that computed or waited for a processor.
double load()
{
    double minute = 0;
    return getloadavg(&minute, 1) == 1 ? minute : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

int Bench::finish(bool json) const
{
    if (json) {
        Json result = {{"bench", name_}, {"machine", machine_name()}, {"load", load()}};
        result["rows"] = Json::array();
        for (const Row& row : rows_)
            result["rows"].push_back(json_of(row));
        result["not_installed"] = missing_;
        result["reach"] = Json::array();
        for (const Reach& r : reach_)
            result["reach"].push_back({{"what", r.what},
                                       {"figure", r.figure},
                                       {"limit", r.limit},
                                       {"better", r.better},
                                       {"met", r.met()}});
        std::printf("%s\n", result.dump(2).c_str());
        return 0;
    }
    std::printf("%s, on %s, with a load of %.3g\n\n", name_.c_str(), machine_name().c_str(),
                load());
    for (std::size_t begin = 0, end = 0; begin < rows_.size(); begin = end) {
        while (end < rows_.size() && same_keys(rows_[begin], rows_[end]))
            ++end;
        print_table(rows_.data() + begin, rows_.data() + end);
    }
    for (const std::string& engine : missing_)
        std::printf("  Not compared with %s: lib%s-dev was not installed when this was built.\n",
                    engine == "ode" ? "ODE" : "Bullet", engine.c_str());
    for (const std::string& note : notes_)
        std::printf("  %s\n", note.c_str());
    for (const Reach& r : reach_)
        std::printf("  %s  %s: %.4g (at %s %.4g)\n", r.met() ? "met   " : "MISSED", r.what.c_str(),
                    r.figure, r.better == "higher" ? "least" : "most", r.limit);
    return 0;
}

bool wants_json(int argc, char** argv)
{
    return std::any_of(argv + 1, argv + argc,
                       [](const char* a) { return std::string_view(a) == "--json"; });
}

std::string machine_name()
{
    std::string processor = "unknown processor";
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos) {
            processor = line.substr(line.find(": ") + 2);
            break;
        }
#ifdef __clang__
    const std::string compiler = "clang " __clang_version__;
#else
    const std::string compiler = "gcc " __VERSION__;
#endif
    return processor + ", " + std::to_string(std::thread::hardware_concurrency()) +
           " processors, " + compiler;
}

double seconds(const std::function<void()>& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values)
{
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::pair<double, double> paired_seconds(const std::function<void()>& a,
                                         const std::function<void()>& b, int repeats)
{
    a();
    b();
    std::vector<double> times_a, times_b;
    for (int i = 0; i < repeats; ++i) {
        times_a.push_back(seconds(a));
        times_b.push_back(seconds(b));
    }
    return {median(times_a), median(times_b)};
}

} // namespace rigor
