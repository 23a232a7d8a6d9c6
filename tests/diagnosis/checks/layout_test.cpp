// SPDX-License-Identifier: MIT
// Values without their types: nothing is lost, and every place has the name of the contract.
#include "diagnosis/layout.hpp"

#include "diagnosis/formula_types.hpp"
#include "diagnosis/transforms.hpp"
#include "support/catch.hpp"

#include <algorithm>

namespace rigor::testing {

TEST_CASE("layout: the arguments of every formula survive the way there and back", "[diagnosis]")
{
    for (unsigned f = 0; f < formula_count; ++f) {
        CAPTURE(formulas[f].name);
        const diagnosis::FormulaType& type = diagnosis::type_of(FormulaIndex{f});
        REQUIRE(type.arguments.encoding.names.size() == formula_quantities[f].count);
        for (unsigned seed = 0; seed < 5; ++seed) {
            const diagnosis::Bytes bytes = type.draw(seed);
            REQUIRE(type.arguments.encode(type.arguments.decode(bytes)) == bytes);
        }
    }
}

TEST_CASE("layout: every change of arguments leaves a value that can be sent", "[diagnosis]")
{
    for (unsigned f = 0; f < formula_count; ++f) {
        CAPTURE(formulas[f].name);
        const diagnosis::Layout& arguments = diagnosis::type_of(FormulaIndex{f}).arguments;
        const diagnosis::Value drawn =
            arguments.decode(diagnosis::type_of(FormulaIndex{f}).draw(3));
        for (const diagnosis::Transform& transform : diagnosis::transforms(arguments)) {
            CAPTURE(transform.words);
            diagnosis::Value changed = drawn;
            if (!transform.apply(changed)) continue;
            const diagnosis::Value again = arguments.decode(arguments.encode(changed));
            REQUIRE(again.sizes == changed.sizes);
            REQUIRE(again.leaves.size() == changed.leaves.size());
            for (std::size_t i = 0; i < again.leaves.size(); ++i)
                REQUIRE(again.leaves[i].at == changed.leaves[i].at);
        }
    }
}

TEST_CASE("layout: places are named as in the contract", "[diagnosis]")
{
    const auto names = [](FormulaIndex formula) {
        std::vector<std::string> result;
        for (const diagnosis::Role& role : diagnosis::type_of(formula).arguments.roles)
            result.push_back(role.name);
        return result;
    };
    using Names = std::vector<std::string>;
    CHECK(names(FormulaIndex::world_inertia) == Names{"R", "I_body"});
    CHECK(names(FormulaIndex::rotate) == Names{"q", "p"});
    CHECK(names(FormulaIndex::net_wrench) == Names{"forces[i].force", "forces[i].point", "X"});
    CHECK(names(FormulaIndex::combine)[5] == "b.inertia");
}

} // namespace rigor::testing
