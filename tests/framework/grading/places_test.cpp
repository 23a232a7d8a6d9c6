// SPDX-License-Identifier: MIT
#include "grading/places.hpp"

#include "errors/input_error.hpp"
#include "support/catch.hpp"

namespace rigor::testing {

TEST_CASE("places: a tree that compilers of submissions can read does not grade", "[grading]")
{
    for (const char* hidden : {"/home/course/rigor", "/usrs/rigor", "/opt/usr/rigor", "/"}) {
        CAPTURE(hidden);
        CHECK_NOTHROW(require_hidden({hidden, hidden}));
    }
    for (const char* readable : {"/usr", "/usr/src/rigor", "/usr/local/src/../rigor", "/bin/x"}) {
        CAPTURE(readable);
        CHECK_THROWS_AS(require_hidden({readable, "/home/course/build"}), InputError);
        CHECK_THROWS_AS(require_hidden({"/home/course/rigor", readable}), InputError);
    }
}

} // namespace rigor::testing
