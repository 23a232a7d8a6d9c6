// SPDX-License-Identifier: MIT
#include "grading/intake/contents.hpp"

#include "errors/quotes.hpp"
#include "errors/utf8.hpp"
#include "grading/intake/refused.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>

namespace rigor {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_name = 1024; // [bytes], more than any name has in practice

bool has_drive(std::string_view name)
{
    return name.size() > 1 && name[1] == ':'; // "C:\collision.cpp", from an archive of Windows
}

} // namespace

std::string Contents::add_name(std::string_view raw)
{
    if (++entries_ > limits_.entries)
        throw Refused(fmt::format("expected at most {} files, found more", limits_.entries));
    if (!is_plain_utf8(raw))
        throw Refused("expected names in UTF-8 without control characters, found " +
                      in_quotes(raw));
    if (raw.size() > longest_name)
        throw Refused(fmt::format("expected names of at most {} bytes, found {}", longest_name,
                                  in_quotes(raw)));
    if (raw.starts_with('/') || raw.starts_with('\\') || has_drive(raw))
        throw Refused("expected names relative to the submission, found " + in_quotes(raw));
    fs::path name;
    for (const fs::path& part : fs::path(raw)) {
        if (part == "..") throw Refused("expected names without \"..\", found " + in_quotes(raw));
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

void Contents::add_source(const std::string& name, std::string text)
{
    require_new(name);
    source_bytes_ += text.size();
    if (source_bytes_ > limits_.source_bytes)
        throw Refused(fmt::format("expected sources of at most {} MB together, found more",
                                  limits_.source_bytes >> 20));
    sources_.emplace(name, std::move(text));
}

void Contents::add_other(const std::string& name)
{
    require_new(name);
    others_.insert(name);
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
