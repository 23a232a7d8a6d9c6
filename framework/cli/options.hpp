// SPDX-License-Identifier: MIT
// The options of a command. CLI11 reads them; no header includes it, for it takes seconds to
// compile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rigor {

/// Declares what a command understands; the variables are filled in before the command runs.
class Options {
public:
    /// Width of the column of names in a help text [characters].
    static constexpr std::size_t name_width = 24;

    explicit Options(CLI::App& app) : app_(app) {}

    /// @param name  "--json"
    void flag(const std::string& name, bool& value, const std::string& meaning);
    /// @param name   "--out"
    /// @param value_name  "FILE"
    void option(const std::string& name, const std::string& value_name, std::string& value,
                const std::string& meaning);
    void option(const std::string& name, const std::string& value_name, std::uint32_t& value,
                const std::string& meaning);
    void words(const std::string& value_name, std::vector<std::string>& values,
               const std::string& meaning);
    /// A word that must be there.
    void word(const std::string& value_name, std::string& value, const std::string& meaning);
    /// Lines for the end of the help, each a command and what it does.
    void examples(const std::vector<std::string>& lines);

private:
    CLI::App& app_;
};

} // namespace rigor
