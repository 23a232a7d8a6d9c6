// SPDX-License-Identifier: MIT
// A formula that is data: the bytes of a number in the place of the function.
// expect: 0 crashed|compile_error
#include "formulas/pipeline.hpp"

asm(R"(
    .data
    .globl _ZN5rigor14kinetic_energyEdRKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEERKNS1_IdLi3ELi3ELi0ELi3ELi3EEES5_
    .type _ZN5rigor14kinetic_energyEdRKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEERKNS1_IdLi3ELi3ELi0ELi3ELi3EEES5_, @object
_ZN5rigor14kinetic_energyEdRKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEERKNS1_IdLi3ELi3ELi0ELi3ELi3EEES5_:
    .quad 0x3ff0000000000000
    .text
)");
