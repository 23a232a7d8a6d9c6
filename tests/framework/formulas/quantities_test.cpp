// SPDX-License-Identifier: MIT
// The table of quantities has a row for each formula, and a quantity for each argument and field.
#include "formulas/quantities.hpp"
#include "support/catch.hpp"

#include <tuple>

using namespace rigor;

namespace {

template <class Result, class... Argument>
constexpr std::size_t argument_count(Result (*)(Argument...))
{
    return sizeof...(Argument);
}

template <class T> void check_fields(const T& value)
{
    std::size_t fields = 0;
    Fields<T>::each(value, [&](std::string_view, const auto&) { ++fields; });
    CHECK(fields == std::size(FieldQuantities<T>::of));
}

} // namespace

TEST_CASE("quantities: every formula has a row with all its arguments", "[formulas]")
{
    const std::size_t counts[] = {
#define RIGOR_ROW(tag, topic, function, ...) argument_count(&rigor::function),
        RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW
    };
    REQUIRE(std::size(formula_quantities) == formula_count);
    for (std::size_t i = 0; i < formula_count; ++i) {
        CAPTURE(formulas[i].name);
        CHECK(formula_quantities[i].name == formulas[i].name);
        CHECK(formula_quantities[i].count == counts[i]);
    }
}

TEST_CASE("quantities: every field has a quantity", "[formulas]")
{
    std::apply([](const auto&... value) { (check_fields(value), ...); },
               std::tuple<Quaternion, Particle, PointForce, Wrench, MassProperties, PrincipalAxes,
                          DensitySample, TriangleMesh, MatrixState, MatrixStateRate, RigidState,
                          BodyInertia, Body, ContactPoint, BodyContact, ContactResult, LevelSet,
                          TetrahedralMesh, MeshFace, PrincipalStress, VertexOrigin, SplitMesh,
                          ElementCrack, EmbeddedMesh, Dimension, KnownCall, Judgement, Tangent>());
}
