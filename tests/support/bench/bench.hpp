// SPDX-License-Identifier: MIT
// Tools of every benchmark: a timer that resists drift, a table, and one JSON format for all.
#pragma once

#include <algorithm>
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
/// `{bench, machine, load, rows, not_installed, reach}`; `load` is the mean number of processes in
/// the last minute that computed or waited for a processor.
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
    /// Says that an engine to compare with was not installed when this was built, so that no row
    /// and no promise of it is missed in silence. `engine` is "bullet" or "ode".
    void missing(std::string engine) { missing_.push_back(std::move(engine)); }

    /// Prints to standard output. @return the exit status, 0: a missed promise is a result
    int finish(bool json) const;

private:
    std::string name_;
    std::vector<Row> rows_;
    std::vector<Reach> reach_;
    std::vector<std::string> notes_, missing_;
};

/// Calls `Bench::missing` for Bullet and for ODE, unless a contestant runs it.
template <class Contestants> void note_missing_engines(Bench& bench, const Contestants& contestants)
{
    for (const char* engine : {"bullet", "ode"})
        if (std::none_of(contestants.begin(), contestants.end(),
                         [&](const auto& contestant) { return contestant.engine == engine; }))
            bench.missing(engine);
}

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
