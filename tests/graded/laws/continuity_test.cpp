// SPDX-License-Identifier: MIT
// The law of continuity: most formulas have no special values, so the result at a special input is
// the limit of the results nearby. Special inputs have entries that are zero or equal, turn about
// an axis of the frame, have a point straight above another one, or repeat an argument. Random
// numbers almost never do, so a formula that is wrong only there would otherwise keep its points.
#include "strata.hpp"
#include "support/seeds.hpp"

#include <fmt/format.h>

namespace rigor::testing {

namespace {

// The formulas that are continuous wherever the special inputs below may lie. The others jump by
// their definition: where sliding begins, between cells, where eigenvalues change their order.
constexpr std::string_view continuous =
    "kinetic_energy cross_matrix world_point object_point angular_velocity point_velocity "
    "velocity_modes generalized_mass net_wrench equations_of_motion velocity_mode_rates "
    "inertial_wrench particle_mass_properties world_inertia world_inverse_inertia invert_moments "
    "solid_sphere solid_box solid_cylinder solid_ellipsoid thin_rod grid_mass_properties "
    "sampled_mass_properties combine bounding_box_mass_properties advance_matrix gram_schmidt "
    "euler_to_matrix euler_rates multiply conjugate normalize rotate to_matrix quaternion_rate "
    "advance_exact advance_linear gravity_wrench step_symplectic_euler step_buss sample_level_set "
    "relative_velocity impulse_matrix frictionless_impulse static_friction_impulse apply_impulse "
    "deviator von_mises_principal von_mises_frobenius von_mises isotropic_stress "
    "von_mises_from_strain yield_strain plastic_flow smooth_stress";

bool one_in(int n, Random& random)
{
    return random_index(random, static_cast<std::size_t>(n)) == 0;
}

// Sets entries to zero, or to another entry or its negative.
template <class Entries> void make_entries_special(Entries& x, bool may_vanish, Random& random)
{
    for (int i = 0; i < x.size(); ++i) {
        if (may_vanish && one_in(3, random)) x(i) = 0;
        if (!one_in(4, random)) continue;
        const double other = x(random_index(random, static_cast<std::size_t>(x.size())));
        x(i) = may_vanish && one_in(2, random) ? -other : other;
    }
}

// A turn about an axis or a diagonal of the frame, or one without a part about some axes; the real
// part has either sign, or is 0 for half a turn.
Quaternion special_unit_quaternion(Random& random)
{
    Eigen::Vector4d q(random.uniform(-1, 1), 0, 0, 0);
    q.tail<3>() = random.vector();
    make_entries_special(q, true, random);
    if (one_in(4, random)) q.setZero(); // no turn, or half a turn about an axis
    if (q.norm() < 0.1) q[random_index(random, 4)] = one_in(2, random) ? 1 : -1;
    q.normalize();
    return {q[0], q.tail<3>()};
}

Matrix3d matrix_of(const Quaternion& q)
{
    return Eigen::Quaterniond(q.s, q.v.x(), q.v.y(), q.v.z()).toRotationMatrix();
}

// A body's inertia, or its inverse: moments that are equal or not, products that are zero or not.
// The eigenvalues lie between 0.6 and 1.2, so no moment is above the sum of the others.
Matrix3d special_definite(Random& random)
{
    Vector3d moments(random.uniform(0.8, 1), random.uniform(0.8, 1), random.uniform(0.8, 1));
    make_entries_special(moments, false, random);
    if (one_in(4, random)) moments.setConstant(moments[0]);
    Vector3d products = 0.1 * random.vector();
    make_entries_special(products, true, random);
    if (one_in(3, random)) products.setZero();
    Matrix3d I = moments.asDiagonal();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        I(i, j) = I(j, i) = products[i];
    }
    return I;
}

// Makes a number, vector or matrix special within its set.
template <class T> void make_special(T& value, const Quantity& q, Random& random)
{
    const bool may_vanish = q.kind != Kind::along_axes || q.dimension == quantities::none;
    if constexpr (std::is_same_v<T, double>) {
        if (q.kind == Kind::any_number)
            value = random_index(random, 3) - 1;
        else if (q.kind == Kind::number && q.dimension != quantities::duration.dimension)
            value = 1;
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        make_entries_special(value, may_vanish, random);
        if (q.kind != Kind::unit) return;
        if (value.norm() < 0.1) value = Vector3d::Unit(random_index(random, 3));
        value.normalize();
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        if (q.kind == Kind::rotation) {
            value = matrix_of(special_unit_quaternion(random));
        } else if (q.kind == Kind::definite) {
            value = special_definite(random);
        } else if (q.kind == Kind::symmetric) {
            make_entries_special(value, true, random);
            value = Matrix3d(value.template selfadjointView<Eigen::Upper>());
        } else if (q.kind == Kind::columns) { // near a rotation, so they do not depend
            Matrix3d change = 0.2 * value;
            make_entries_special(change, true, random);
            value = matrix_of(special_unit_quaternion(random)) + change;
        } else {
            make_entries_special(value, true, random);
            if (one_in(3, random)) value.diagonal().setZero();
        }
    }
}

// Moves a value by about t within its set.
template <class T> void nudge(T& value, const Quantity& q, double t, Random& random)
{
    if constexpr (std::is_same_v<T, double>) {
        value += t * random.uniform(-1, 1);
    } else if constexpr (std::is_same_v<T, Vector3d>) {
        value += t * random.vector();
        if (q.kind == Kind::unit) value.normalize();
    } else if constexpr (std::is_same_v<T, Matrix3d>) {
        Matrix3d change;
        change << random.vector(), random.vector(), random.vector();
        if (q.kind == Kind::rotation) {
            const Vector3d axis = random.unit_vector();
            value = Eigen::AngleAxisd(t, axis) * value;
        } else {
            if (q.kind == Kind::symmetric || q.kind == Kind::definite)
                change = (change + change.transpose()).eval() / 2;
            value += t * change;
        }
    }
}

template <class T> void make_unit(T& value, const Quantity& q)
{
    if constexpr (std::is_same_v<T, RigidState>)
        make_unit(value.orientation, quantities::orientation);
    if constexpr (std::is_same_v<T, Quaternion>) {
        if (q.kind != Kind::orientation) return;
        const double length = std::hypot(value.s, value.v.norm());
        value.s /= length;
        value.v /= length;
    }
}

template <class T> void make_argument_special(T& value, const Quantity& q, Random& random)
{
    if constexpr (std::is_same_v<T, LevelSet>) return; // its point is special instead
    const T ordinary = value;
    each_pair(value, ordinary, q, false, [&](auto& leaf, const auto&, const Quantity& of) {
        if (of.kind != Kind::index && !one_in(3, random)) make_special(leaf, of, random);
    });
    if constexpr (std::is_same_v<T, RigidState>) {
        if (one_in(2, random)) value.orientation = special_unit_quaternion(random);
    } else if constexpr (std::is_same_v<T, Quaternion>) {
        if (one_in(2, random) || std::hypot(value.s, value.v.norm()) < 0.1)
            value = special_unit_quaternion(random);
    }
    make_unit(value, q);
}

template <class T> void nudge_argument(T& value, const Quantity& q, double t, Random& random)
{
    const T before = value;
    each_pair(value, before, q, false, [&](auto& leaf, const auto&, const Quantity& of) {
        if (of.kind != Kind::index) nudge(leaf, of, t, random);
    });
    make_unit(value, q);
}

// Gives two arguments that are points a difference of few entries.
template <class Arguments> void align_points(Arguments& arguments, Random& random)
{
    if constexpr (std::tuple_size_v<Arguments> >= 2) {
        constexpr std::size_t last = std::tuple_size_v<Arguments> - 1;
        auto& x = std::get<last>(arguments);
        auto& X = std::get<last - 1>(arguments);
        if constexpr (std::is_same_v<decltype(x), Vector3d&> &&
                      std::is_same_v<decltype(X), Vector3d&>) {
            Vector3d arm = random.vector();
            make_entries_special(arm, true, random);
            if (one_in(2, random)) x = X + arm;
        }
    }
}

// Arguments of the formula, special and within what the contract says of them together.
template <FormulaIndex f, auto& formula> Arguments<formula> special_arguments(Random& random)
{
    using F = FormulaIndex;
    constexpr bool is_impulse = f == F::frictionless_impulse || f == F::static_friction_impulse;
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    Arguments<formula> arguments =
        random_arguments<f, formula>(static_cast<unsigned>(random.bits()));
    std::size_t k = 0;
    std::apply([&](auto&... one) { (make_argument_special(one, of.arguments[k++], random), ...); },
               arguments);
    if constexpr (f == F::sample_level_set) {
        auto& [grid, p] = arguments;
        for (int i = 0; i < 3; ++i) // a node, the middle of an edge, or a place between them
            p[i] = grid.origin[i] + grid.cell_size / 2 * (random_index(random, 12) - 3) +
                   (one_in(3, random) ? grid.cell_size * random.uniform(-1, 1) : 0);
    } else if constexpr (is_impulse) {
        const Vector3d& n = std::get<2>(arguments);
        Vector3d& v = std::get<1>(arguments);
        if (v.dot(n) > 0) v = -v; // bodies that approach
        if (v.dot(n) > -0.05) v -= n;
    } else {
        align_points(arguments, random);
    }
    return arguments;
}

template <FormulaIndex f, auto& formula> void check_continuity()
{
    const FormulaQuantities& of = formula_quantities[static_cast<unsigned>(f)];
    for (Random random : seeds(150)) {
        const Arguments<formula> arguments = special_arguments<f, formula>(random);
        const auto found = std::apply(formula, arguments);
        for (const double t : {0x1p-32, 0x1p-22, 0x1p-14}) {
            Arguments<formula> nearby = arguments;
            std::size_t k = 0;
            std::apply(
                [&](auto&... one) { (nudge_argument(one, of.arguments[k++], t, random), ...); },
                nearby);
            const auto limit = std::apply(formula, nearby);

            INFO(fmt::format("{} has no special values: if each argument changes by about {:.1g}, "
                             "the result may change by no more than some multiple of that; the "
                             "expected value is the result for such changed arguments",
                             formulas[static_cast<unsigned>(f)].name, t));
            REQUIRE_THAT(found, IsClose(limit, Order(512 * t)));
        }
    }
}

#define RIGOR_ROW(tag, topic, function, ...)                                                       \
    [[maybe_unused]] const bool continuity_of_##function = [] {                                    \
        if constexpr (has_word(continuous, #function))                                             \
            return add_test(&check_continuity<FormulaIndex::function, rigor::function>,            \
                            #topic ": " #function " has no special values",                        \
                            "[" #tag "][" #topic "]");                                             \
        return false;                                                                              \
    }();
RIGOR_FORMULAS(RIGOR_ROW)
#undef RIGOR_ROW

} // namespace

} // namespace rigor::testing
