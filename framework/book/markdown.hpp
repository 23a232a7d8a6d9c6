// SPDX-License-Identifier: MIT
// Converts the Markdown of the handouts to HTML.
#pragma once

#include <functional>
#include <string>

namespace rigor::book {

/// The HTML of a picture, from its path and its description.
using Picture = std::function<std::string(const std::string& path, const std::string& text)>;

/// Converts Markdown to HTML, as far as the handouts use it: headings, paragraphs, lists, tables,
/// quotes, code, pictures, formulas, and bold or italic words. A link becomes its text, without the
/// target. The HTML tags of folded parts (<details>, <summary>) stay as they are.
/// @throws InputError for a formula that cannot be shown
std::string html(const std::string& markdown, const Picture& picture);

} // namespace rigor::book
