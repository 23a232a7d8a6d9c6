// SPDX-License-Identifier: MIT
// A formula that is a thread-local variable.
// expect: 0 crashed|compile_error
#include "formulas/pipeline.hpp"

namespace rigor {

// The definition is below.
double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&);

} // namespace rigor

asm(R"(
    .section .tdata, "awT", @progbits
    .globl _ZN5rigor14kinetic_energyEdRKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEERKNS1_IdLi3ELi3ELi0ELi3ELi3EEES5_
    .type _ZN5rigor14kinetic_energyEdRKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEERKNS1_IdLi3ELi3ELi0ELi3ELi3EEES5_, @tls_object
_ZN5rigor14kinetic_energyEdRKN5Eigen6MatrixIdLi3ELi1ELi0ELi3ELi1EEERKNS1_IdLi3ELi3ELi0ELi3ELi3EEES5_:
    .quad 0
    .text
)");
