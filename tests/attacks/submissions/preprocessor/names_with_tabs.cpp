// SPDX-License-Identifier: MIT
// Includes the reference by a name with a tab and a backslash in it, as lists of files write them.
// expect: 0 compile_error
#include "formulas/pipeline.hpp"

#include "	../../../../../reference/pipeline.cpp \
"
#include "..\	/../../../../reference/pipeline.cpp"
