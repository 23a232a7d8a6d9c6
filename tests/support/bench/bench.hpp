// SPDX-License-Identifier: MIT
// Tools of every benchmark: a timer that resists drift, a table, and the JSON format of DESIGN.md.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace rigor {

/// A measured figure with the limit that was promised for it.
struct Reach {
    std::string what;
    double figure = 0, limit = 0;
    std::string better = "lower"; // or "higher": the side of the limit where the promise is kept

    /// A figure that is not a number keeps no promise.
    bool met() const { return better == "higher" ? figure >= limit : figure <= limit; }
};

/// Collects rows and promises, then prints them once: as a table, or as one JSON object
/// `{bench, machine, rows, reach}`.
class Bench {
public:
    using Value = std::variant<double, std::string>;
    using Row = std::vector<std::pair<std::string, Value>>;

    explicit Bench(std::string name) : name_(std::move(name)) {}

    /// Rows with the same keys, one after the other, print as one table.
    void row(Row row) { rows_.push_back(std::move(row)); }
    void reach(Reach reach) { reach_.push_back(std::move(reach)); }
    /// A line of text below the table: how something was measured.
    void note(std::string text) { notes_.push_back(std::move(text)); }

    /// Prints to standard output. @return the exit status, 0: a missed promise is a result
    int finish(bool json) const;

private:
    std::string name_;
    std::vector<Row> rows_;
    std::vector<Reach> reach_;
    std::vector<std::string> notes_;
};

/// Whether `--json` is among the arguments.
bool wants_json(int argc, char** argv);

/// Processor, number of processors and compiler, in one line.
std::string machine_name();

/// Wall-clock time of one call [s].
double seconds(const std::function<void()>& work);

/// Median times of two functions that run in turns, so that a slow phase of the machine affects
/// both [s].
std::pair<double, double> paired_seconds(const std::function<void()>& a,
                                         const std::function<void()>& b, int repeats);

double median(std::vector<double> values);

} // namespace rigor
