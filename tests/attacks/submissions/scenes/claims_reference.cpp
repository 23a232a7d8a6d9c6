// SPDX-License-Identifier: MIT
// Says that it is the reference, by the macro of the build and by a start of the server. For the
// reference the engine uses faster forms of the formulas.
// topic: contact
// tasks: A5.6
// expect: 0 compile_error|failed|crashed|not_implemented
#define RIGOR_REFERENCE
#include "formulas/contact.hpp"

namespace rigor {

int run_worker(bool is_reference);

ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int)
{
    run_worker(true);
    return {bodies, std::vector<Vector3d>(contacts.size(), Vector3d::Zero())};
}

} // namespace rigor

extern "C" const bool is_reference = true;

int main()
{
    return rigor::run_worker(true);
}
