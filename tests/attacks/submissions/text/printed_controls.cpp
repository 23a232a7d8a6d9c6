// SPDX-License-Identifier: MIT
// Prints what turns text round, hides it, or ends it, and then crashes, so that it is shown.
// expect: 0 crashed: aborted
#include "formulas/pipeline.hpp"

#include <cstdio>
#include <cstdlib>

namespace rigor {

double kinetic_energy(double, const Vector3d&, const Matrix3d&, const Vector3d&)
{
    std::printf("\xc2\x85\xc2\x9b"
                "31m \xe2\x80\xae \xe2\x81\xa6 \xef\xbb\xbf \xe2\x80\xa8 \a\b\r\n");
    std::fwrite("end\0of text", 1, 11, stdout);
    std::fflush(stdout);
    std::abort();
    return 0;
}

} // namespace rigor
