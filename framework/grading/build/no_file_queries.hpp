// SPDX-License-Identifier: MIT
// The compiler includes this header before each file of a submission. A submission may not ask the
// preprocessor which files there are: without namespaces (tier B) the compiler sees the names of
// other files, even if it cannot open them. So each such query gives 0, the answer no, in whatever
// way a submission writes the name of the macro, such as over two lines or by token pasting. A
// submission cannot restore the meaning that the compiler gives to the name.
#pragma once
#pragma GCC system_header

#define __has_include(...) 0
#define __has_include_next(...) 0
#define __has_embed(...) 0
