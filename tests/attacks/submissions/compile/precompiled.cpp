// SPDX-License-Identifier: MIT
// Tells the compiler to load a precompiled header of its own making.
// expect: 0 compile_error|failed
#pragma GCC pch_preprocess "pipeline.cpp"
