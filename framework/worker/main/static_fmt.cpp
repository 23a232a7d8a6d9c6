// SPDX-License-Identifier: MIT
// The compiled part of the library fmt: the instances of templates that its file format.cc has.
// Debian has this part in a shared library only, but a worker is linked statically.
#include <fmt/format-inl.h>

namespace fmt {

namespace detail {

#if FMT_VERSION >= 100000 // Debian 13
using Arguments = vformat_args<>::type;
#else // Debian 12 and Ubuntu 24.04
using Arguments = basic_format_args<buffer_context<char>>;
#endif

template dragonbox::decimal_fp<float> dragonbox::to_decimal(float);
template dragonbox::decimal_fp<double> dragonbox::to_decimal(double);
template locale_ref::locale_ref(const std::locale&);
template std::locale locale_ref::get<std::locale>() const;
template thousands_sep_result<char> thousands_sep_impl(locale_ref);
template char decimal_point_impl(locale_ref);
template void buffer<char>::append(const char*, const char*);
template void vformat_to(buffer<char>&, string_view, Arguments, locale_ref);

} // namespace detail

} // namespace fmt
