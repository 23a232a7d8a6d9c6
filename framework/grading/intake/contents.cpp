// SPDX-License-Identifier: MIT
#include "grading/intake/contents.hpp"

#include "errors/quotes.hpp"
#include "errors/utf8.hpp"
#include "grading/intake/refused.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 1024; // [bytes], more than any name has in practice
constexpr std::size_t longest_part = 255;  // [bytes], the limit of most file systems

bool has_drive(std::string_view name)
{
    return name.size() > 1 && name[1] == ':'; // "C:\collision.cpp", in an archive from Windows
}

} // namespace

std::string Contents::add_name(std::string_view given)
{
    // Some programs on Windows write "student\collision.cpp" into archives.
    std::string raw(given);
    std::replace(raw.begin(), raw.end(), '\\', '/');
    if (++entries_ > limits_.entries)
        throw Refused(fmt::format("expected at most {} files, found more", limits_.entries));
    if (!is_plain_utf8(raw))
        throw Refused("expected names in UTF-8 without control characters and without invisible "
                      "ones, found " +
                      in_quotes(given));
    if (raw.size() > longest_name)
        throw Refused(fmt::format("expected names of at most {} bytes, found {}", longest_name,
                                  in_quotes(given)));
    if (raw.starts_with('/') || has_drive(raw))
        throw Refused("expected names relative to the submission, found " + in_quotes(given));
    fs::path name;
    for (const fs::path& part : fs::path(raw)) {
        if (part == "..") throw Refused("expected names without \"..\", found " + in_quotes(given));
        if (!part.empty() && part != ".") name /= part;
    }
    return name.string();
}

void Contents::require_new(const std::string& name) const
{
    if (name.empty()) throw Refused("expected each file to have a name, found one without");
    if (sources_.count(name) > 0 || others_.count(name) > 0)
        throw Refused("expected each file once, found " + in_quotes(name) + " twice");
}

// Refuses a name with which the file cannot be written beside the other files. Otherwise the
// writing would fail later, and count as a fault of the framework.
void Contents::require_place(const std::string& name) const
{
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = name.find('/', begin);
        if (std::min(end, name.size()) - begin > longest_part)
            throw Refused(fmt::format("expected names of at most {} bytes, found {}", longest_part,
                                      in_quotes(name)));
        if (end != std::string::npos && sources_.count(name.substr(0, end)) > 0)
            throw Refused("expected a file or a folder, found both called " +
                          in_quotes(name.substr(0, end)));
    }
    const auto below = sources_.lower_bound(name + "/");
    if (below != sources_.end() && below->first.starts_with(name + "/"))
        throw Refused("expected a file or a folder, found both called " + in_quotes(name));
}

void Contents::add_source(const std::string& name, std::string text)
{
    require_new(name);
    require_place(name);
    source_bytes_ += text.size();
    if (source_bytes_ > limits_.source_bytes) refuse_too_many_sources(limits_);
    sources_.emplace(name, std::move(text));
}

void Contents::add_other(const std::string& name)
{
    require_new(name);
    others_.insert(name);
}

void refuse_too_many_sources(const IntakeLimits& limits)
{
    throw Refused(fmt::format("expected sources of at most {} MB together, found more",
                              limits.source_bytes >> 20));
}

bool is_source(std::string_view name)
{
    constexpr std::array<std::string_view, 9> endings = {".cpp", ".hpp", ".h",   ".hh", ".hxx",
                                                         ".inl", ".ipp", ".inc", ".cc"};
    for (const std::string_view ending : endings)
        if (name.ends_with(ending)) return true;
    return false;
}

bool is_by_product(std::string_view name)
{
    for (const fs::path& part : fs::path(name))
        if (part.string().starts_with('.') || part == "__MACOSX") return true;
    return false;
}

} // namespace rigor
