// SPDX-License-Identifier: MIT
// Assignment A5. Read: assignments/a5-contact/README.md, then framework/formulas/contact.hpp,
// which says what each function takes and returns, and what it does in special cases.
// Check: ./rigor check contact, or one task, ./rigor check A5.3
#include "formulas/contact.hpp"

#include "formulas/collision.hpp"

namespace rigor {

// A5.1  ε = (k + 1)/n - 1
double contact_restitution(int k, int n)
{
    throw NotImplemented("contact::contact_restitution");
}

// A5.2  one contact at a time, the deepest first, while ε rises to 0
ContactResult resolve_contacts(const std::vector<Body>& bodies,
                               const std::vector<BodyContact>& contacts, int n)
{
    throw NotImplemented("contact::resolve_contacts");
}

// A5.3  0 for static bodies, else one more than the highest level below; a cycle shares one level
std::vector<int> contact_levels(const std::vector<std::vector<int>>& rests_on,
                                const std::vector<bool>& is_static)
{
    throw NotImplemented("contact::contact_levels");
}

// A5.4  level by level from the ground up, while all bodies of lower levels are held
ContactResult shock_propagation(const std::vector<Body>& bodies,
                                const std::vector<BodyContact>& contacts,
                                const std::vector<int>& levels, int n)
{
    throw NotImplemented("contact::shock_propagation");
}

// A5.5  jₙ ← max(0, jₙ - (v·n - s)/(nᵀKn)),  j_T ← j_T - v_T/λ, |j_T| ≤ μ jₙ
ContactResult resolve_simultaneously(const std::vector<Body>& bodies,
                                     const std::vector<BodyContact>& contacts, int sweeps)
{
    throw NotImplemented("contact::resolve_simultaneously");
}

} // namespace rigor
