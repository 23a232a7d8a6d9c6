// SPDX-License-Identifier: MIT
// Text inside HTML, MathML or SVG.
#pragma once

#include <string>

namespace rigor {

/// A text with &lt;, &gt; and &amp; in place of <, > and &, to stand between two tags.
std::string escaped_markup(const std::string& text);

} // namespace rigor
