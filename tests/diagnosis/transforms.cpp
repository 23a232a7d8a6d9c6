// SPDX-License-Identifier: MIT
// All changes of the arguments of a formula, from the changes of its places and pairs of places,
// and those of whole arguments.
#include "diagnosis/transforms.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rigor::diagnosis {

namespace {

using Roles = std::vector<Role>;

// The leaves of one place.
std::vector<Leaf> leaves_of(const Value& value, int role)
{
    std::vector<Leaf> result;
    for (const Leaf& leaf : value.leaves)
        if (leaf.role == role) result.push_back(leaf);
    return result;
}

// The argument that a place belongs to: "contacts" of "contacts[i].normal".
std::string argument_of(const Role& role)
{
    return role.name.substr(0, role.name.find_first_of(".["));
}

bool is_of_fixed_length(const Role& role)
{
    const Kind kind = role.quantity.kind;
    return kind == Kind::unit || kind == Kind::direction || kind == Kind::rotation ||
           kind == Kind::orientation;
}

Transform on_role(const Role& role, int index, const LeafChange& change)
{
    const std::string each = role.in_list ? "each " : "";
    const bool removes_unit = change.words == "= 0" && is_of_fixed_length(role);
    return {each + "`" + role.name + "` " + change.words, change.advice,
            [role, index, apply = change.apply](Value& value) {
                for (const Leaf& leaf : leaves_of(value, index))
                    if (!apply(value.of(leaf, role))) return false;
                return true;
            },
            removes_unit ? 1 : 0};
}

// A change of each leaf of one place by the leaf of another that has the same number in its list,
// or by the only one there is.
Transform on_pair(const Roles& roles, int changed, int by, const PairChange& change)
{
    return {change.words, change.advice,
            [role = roles[changed], other = roles[by], changed, by,
             apply = change.apply](Value& value) {
                const std::vector<Leaf> ours = leaves_of(value, changed),
                                        theirs = leaves_of(value, by);
                if (theirs.size() != ours.size() && theirs.size() != 1) return false;
                for (std::size_t i = 0; i < ours.size(); ++i)
                    if (!apply(value.of(ours[i], role),
                               value.of(theirs[theirs.size() == 1 ? 0 : i], other)))
                        return false;
                return true;
            }};
}

bool may_meet(const Role& changed, const Role& by)
{
    if (!changed.in_list && !by.in_list) return true;
    if (argument_of(changed) == argument_of(by)) return changed.in_list == by.in_list;
    return changed.in_list && !by.in_list;
}

using RolePairs = std::vector<std::pair<int, int>>;

// The places that two arguments of one type have in common: `body1.position` and `body2.position`.
RolePairs common_places(const Roles& roles, const std::string& a, const std::string& b)
{
    RolePairs pairs;
    for (int i = 0; i < static_cast<int>(roles.size()); ++i)
        for (int j = 0; j < static_cast<int>(roles.size()); ++j)
            if (argument_of(roles[i]) == a && argument_of(roles[j]) == b &&
                roles[i].name.substr(a.size()) == roles[j].name.substr(b.size()) &&
                roles[i].same_shape(roles[j]))
                pairs.emplace_back(i, j);
    return pairs;
}

Transform exchange(const Roles& roles, const std::string& a, const std::string& b,
                   const RolePairs& pairs)
{
    return {fmt::format("`{}` and `{}` exchanged", a, b), "they may have changed places",
            [pairs, roles](Value& value) {
                for (const auto& [i, j] : pairs) {
                    const auto x = leaves_of(value, i), y = leaves_of(value, j);
                    if (x.size() != y.size()) return false;
                    for (std::size_t k = 0; k < x.size(); ++k) {
                        auto p = value.of(x[k], roles[i]), q = value.of(y[k], roles[j]);
                        std::swap_ranges(p.begin(), p.end(), q.begin());
                    }
                }
                return true;
            }};
}

// The same change of one place of two arguments.
Transform on_both(const Roles& roles, int i, int j, const LeafChange& change)
{
    return {fmt::format("`{}` and `{}` {}", roles[i].name, roles[j].name, change.words),
            change.advice, [=](Value& value) {
                for (const Leaf& leaf : value.leaves)
                    if ((leaf.role == i || leaf.role == j) &&
                        !change.apply(value.of(leaf, roles[leaf.role])))
                        return false;
                return true;
            }};
}

// Changes of two arguments of one type together.
void add_exchanges(const Layout& arguments, std::vector<Transform>& result)
{
    const auto& names = arguments.encoding.names;
    for (std::size_t a = 0; a < names.size(); ++a)
        for (std::size_t b = a + 1; b < names.size(); ++b) {
            const RolePairs pairs = common_places(arguments.roles, names[a], names[b]);
            if (pairs.size() < 2) continue; // one place alone is among the pairs of places
            result.push_back(exchange(arguments.roles, names[a], names[b], pairs));
            for (const auto& [i, j] : pairs)
                for (const LeafChange& change : changes_of(arguments.roles[i]))
                    result.push_back(on_both(arguments.roles, i, j, change));
        }
}

// Sets several places of one argument to zero: an inverse mass together with its inverse inertia,
// and a linear part together with its angular part.
void add_zeros(const Layout& arguments, std::vector<Transform>& result)
{
    constexpr std::pair<const char*, const char*> together[] = {{"inverse_mass", "inverse_inertia"},
                                                                {"inverse_mass", "I_inverse"},
                                                                {"velocity", "angular_velocity"},
                                                                {"V", "omega"},
                                                                {"force", "torque"},
                                                                {"velocity", "angular_momentum"}};
    const Roles& roles = arguments.roles;
    for (const auto& [first, second] : together)
        for (int i = 0; i < static_cast<int>(roles.size()); ++i)
            for (int j = 0; j < static_cast<int>(roles.size()); ++j) {
                const std::string &a = roles[i].name, &b = roles[j].name;
                if (!a.ends_with(first) || !b.ends_with(second)) continue;
                const std::string parent = a.substr(0, a.size() - std::string(first).size());
                if (b != parent + second) continue;
                result.push_back({fmt::format("`{}` = 0 and `{}` = 0", a, b),
                                  "they have no effect in your code", [i, j, roles](Value& value) {
                                      for (const Leaf& leaf : value.leaves)
                                          if (leaf.role == i || leaf.role == j)
                                              for (double& x : value.of(leaf, roles[leaf.role]))
                                                  x = 0;
                                      return true;
                                  }});
            }
}

// The numbers of a list whose elements have one size each, and where its length is.
struct ListPlace {
    std::string name;
    std::size_t size_index = 0;
    int first_role = 0, last_role = 0;
};

// The lists among the arguments. Empty if lists are nested or if numbers are indices into them.
std::vector<ListPlace> lists_of(const Layout& arguments)
{
    std::vector<ListPlace> result;
    int role = 0;
    for (std::size_t i = 0; i < arguments.encoding.parts.size(); ++i) {
        const Encoding& part = arguments.encoding.parts[i];
        const int first = role;
        while (role < static_cast<int>(arguments.roles.size()) &&
               argument_of(arguments.roles[role]) == arguments.encoding.names[i]) {
            const Role& at = arguments.roles[role++];
            if (at.in_list && at.form != Form::real) return {};
            if (at.name.find("[i]") != at.name.rfind("[i]")) return {};
            if (at.in_list && part.form == Form::record) return {};
        }
        if (part.form == Form::list)
            result.push_back({arguments.encoding.names[i], result.size(), first, role - 1});
    }
    return result;
}

enum class ListChange { reversed, without_first, without_last, first_only };

bool change_list(Value& value, const ListPlace& list, ListChange change)
{
    const std::size_t n = value.sizes[list.size_index];
    if (n == 0) return false;
    std::size_t begin = value.numbers.size(), end = 0, leaves = 0;
    for (std::size_t k = 0; k < value.leaves.size(); ++k) {
        const Leaf& leaf = value.leaves[k];
        if (leaf.role < list.first_role || leaf.role > list.last_role) continue;
        begin = std::min(begin, leaf.at);
        end = k + 1 < value.leaves.size() ? value.leaves[k + 1].at : value.numbers.size();
        ++leaves;
    }
    const std::size_t size = (end - begin) / n;
    const auto element = [&](std::size_t i) {
        return value.numbers.begin() + static_cast<long>(begin + i * size);
    };
    if (change == ListChange::reversed) {
        for (std::size_t i = 0; i < n / 2; ++i)
            std::swap_ranges(element(i), element(i + 1), element(n - 1 - i));
        return true;
    }
    // The list loses elements: the numbers go, and the leaves of all that follow move up.
    const std::size_t kept = change == ListChange::first_only ? 1 : n - 1;
    const std::size_t from = change == ListChange::without_first ? 0 : kept;
    value.numbers.erase(element(from), element(from + n - kept));
    std::vector<Leaf> all;
    std::size_t seen = 0;
    const std::size_t for_each = leaves / n, gone = (n - kept) * size;
    for (Leaf leaf : value.leaves) {
        const bool inside = leaf.role >= list.first_role && leaf.role <= list.last_role;
        if (inside && seen++ >= kept * for_each) continue;
        if (!inside && leaf.at >= end) leaf.at -= gone;
        all.push_back(leaf);
    }
    value.leaves = std::move(all);
    value.sizes[list.size_index] = kept;
    return true;
}

void add_list_changes(const Layout& arguments, std::vector<Transform>& result)
{
    constexpr std::pair<const char*, ListChange> changes[] = {
        {"without its last element", ListChange::without_last},
        {"without its first element", ListChange::without_first},
        {"cut to its first element", ListChange::first_only},
        {"in reverse order", ListChange::reversed}};
    for (const ListPlace& list : lists_of(arguments))
        for (const auto& [words, change] : changes)
            result.push_back(
                {fmt::format("`{}` {}", list.name, words),
                 change == ListChange::reversed ? "" : "a loop may end or begin wrongly",
                 [list, change = change](Value& value) {
                     return change_list(value, list, change);
                 }});
}

} // namespace

std::vector<Transform> transforms(const Layout& arguments)
{
    std::vector<Transform> result;
    const Roles& roles = arguments.roles;
    const int n = static_cast<int>(roles.size());
    for (int i = 0; i < n; ++i)
        for (const LeafChange& change : changes_of(roles[i]))
            result.push_back(on_role(roles[i], i, change));
    add_exchanges(arguments, result);
    add_zeros(arguments, result);
    add_list_changes(arguments, result);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            if (i != j && may_meet(roles[i], roles[j]))
                for (const PairChange& change : changes_of(roles[i], roles[j]))
                    result.push_back(on_pair(roles, i, j, change));
    std::stable_sort(result.begin(), result.end(), [](const Transform& a, const Transform& b) {
        return a.strangeness < b.strangeness;
    });
    return result;
}

} // namespace rigor::diagnosis
