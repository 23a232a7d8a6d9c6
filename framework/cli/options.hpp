// SPDX-License-Identifier: MIT
// The options of a command, parsed by CLI11. No header includes CLI11, since it takes seconds to
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

/// Declares the options of a command. The variables `value` get their values from the command line
/// before the command runs.
class Options {
public:
    /// Width of the column of names in a help text [characters].
    static constexpr std::size_t name_width = 24;

    explicit Options(CLI::App& app) : app_(app) {}

    /// @param name  such as "--json"
    void flag(const std::string& name, bool& value, const std::string& meaning);
    /// @param name  such as "--out"
    /// @param value_name  such as "FILE"
    void option(const std::string& name, const std::string& value_name, std::string& value,
                const std::string& meaning);
    void option(const std::string& name, const std::string& value_name, std::uint32_t& value,
                const std::string& meaning);
    void words(const std::string& value_name, std::vector<std::string>& values,
               const std::string& meaning);
    /// A required positional argument.
    void word(const std::string& value_name, std::string& value, const std::string& meaning);
    /// A positional argument that may be left out.
    void word_or_none(const std::string& value_name, std::string& value,
                      const std::string& meaning);
    /// Examples at the end of the help text. Each line is a command and what it does.
    void examples(const std::vector<std::string>& lines);

private:
    CLI::App& app_;
};

} // namespace rigor
