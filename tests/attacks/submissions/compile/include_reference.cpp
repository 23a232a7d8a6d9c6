// SPDX-License-Identifier: MIT
// Includes the reference.
// expect: 0 compile_error
#include "../../../../../reference/pipeline.cpp"
