// SPDX-License-Identifier: MIT
// Computes the nodal forces of corotated linear elasticity with plastic strain and
// stiffness-proportional damping (Müller and Gross 2004, "Interactive virtual materials"). For each
// pair of elements the code computes the deformation gradient, its polar decomposition, the elastic
// strain and its rate, and the stress, in this order, and then adds the forces to the nodes.
#include "deformable/elasticity/elements.hpp"

#include "deformable/elasticity/polar_decomposition.hpp"
#include "deformable/solid/lumped_mass.hpp"

#include <algorithm>
#include <cmath>

namespace rigor {

namespace {

// A symmetric matrix for each of two elements.
struct Symmetric {
    Two xx, yy, zz, xy, xz, yz;
};

[[gnu::always_inline]] inline Two square_root(Two a)
{
    return Two{std::sqrt(a[0]), std::sqrt(a[1])};
}

// [a₁ - a₀, a₂ - a₀, a₃ - a₀] for both elements of a pair, with the values a at their corners.
[[gnu::always_inline]] inline Square3<Two> edges(const ElementPair& pair,
                                                 std::span<const Vector3d> a)
{
    const Vector3d *p[4], *q[4];
    for (int i = 0; i < 4; ++i) {
        p[i] = &a[pair.nodes[0][i]];
        q[i] = &a[pair.nodes[1][i]];
    }
    Square3<Two> D;
    for (int i = 0; i < 3; ++i) {
        const Two origin{(*p[0])[i], (*q[0])[i]};
        for (int j = 0; j < 3; ++j)
            D.a[i][j] = Two{(*p[j + 1])[i], (*q[j + 1])[i]} - origin;
    }
    return D;
}

// R, S and s = Tr S of both elements of a pair. Where the closed form is inaccurate, R and s come
// from an eigenvector.
struct PolarPair {
    Square3<Two> R;
    Symmetric S;
    Two s, conditioning;
};

[[gnu::noinline]] void polar_by_eigenvector(const Square3<Two>& F, int lane, PolarPair& polar)
{
    Matrix3d G;
    for (int i = 0; i < 9; ++i)
        G(i / 3, i % 3) = F.a[i / 3][i % 3][lane];
    const Polar exact = polar_decomposition(G);
    for (int i = 0; i < 9; ++i)
        polar.R.a[i / 3][i % 3][lane] = exact.R(i / 3, i % 3);
    polar.s[lane] = exact.S.trace();
}

[[gnu::always_inline]] inline PolarPair polar_pair(const Square3<Two>& F)
{
    const Two norm2 = dot(F, F);
    const auto is_end = [](Two step) {
        return std::abs(step[0]) < small_step && std::abs(step[1]) < small_step;
    };
    const ClosedPolar<Two> closed = closed_polar(F, norm2, square_root(3.0 * norm2), is_end);
    PolarPair polar{closed.R, {}, closed.s, closed.conditioning};
    for (int lane = 0; lane < 2; ++lane)
        if (!is_exact(closed.conditioning[lane], closed.last_step[lane]))
            polar_by_eigenvector(F, lane, polar);
    const Square3<Two> S = transposed_times(polar.R, F);
    polar.S = {S.a[0][0],
               S.a[1][1],
               S.a[2][2],
               0.5 * (S.a[0][1] + S.a[1][0]),
               0.5 * (S.a[0][2] + S.a[2][0]),
               0.5 * (S.a[1][2] + S.a[2][1])};
    return polar;
}

// z = (s δ - S)⁻¹ a by cofactors, with s = Tr S and the unit matrix δ. Near a deformation whose R
// is not unique, z and the stiffness would grow without bound; there z is reduced to 0 gradually.
[[gnu::always_inline]] inline void solve_spin(const PolarPair& polar, const Two (&a)[3],
                                              Two (&z)[3])
{
    const Symmetric& S = polar.S;
    const Two xx = polar.s - S.xx, yy = polar.s - S.yy, zz = polar.s - S.zz;
    const Two cxx = yy * zz - S.yz * S.yz, cyy = xx * zz - S.xz * S.xz, czz = xx * yy - S.xy * S.xy;
    const Two cxy = S.xz * S.yz + S.xy * zz, cxz = S.xy * S.yz + S.xz * yy,
              cyz = S.xy * S.xz + S.yz * xx;
    const Two det = xx * cxx - S.xy * cxy - S.xz * cxz;
    Two inverse{0, 0};
    for (int lane = 0; lane < 2; ++lane) {
        // z is 0 where the conditioning is below `none`, and not reduced where it is above `all`.
        // The conditioning is 0.59 at rest; below 0.01 the closed form of R is inaccurate (see
        // is_exact). `none` and `all` were chosen by trial.
        constexpr double none = 0.02, all = 0.1;
        const double part = std::clamp((polar.conditioning[lane] - none) / (all - none), 0.0, 1.0);
        inverse[lane] = part > 0 ? part / det[lane] : 0;
    }
    z[0] = (cxx * a[0] + cxy * a[1] + cxz * a[2]) * inverse;
    z[1] = (cxy * a[0] + cyy * a[1] + cyz * a[2]) * inverse;
    z[2] = (cxz * a[0] + cyz * a[1] + czz * a[2]) * inverse;
}

// The elastic strain ε - ε_p = S - δ - ε_p, with the unit matrix δ and the plastic strain ε_p.
[[gnu::always_inline]] inline Symmetric elastic_part(const Symmetric& S, const Two (&plastic)[6])
{
    return {S.xx - 1.0 - plastic[0], S.yy - 1.0 - plastic[1], S.zz - 1.0 - plastic[2],
            S.xy - plastic[3],       S.xz - plastic[4],       S.yz - plastic[5]};
}

// Ṡ = A - W S with A = Rᵀ Ḟ. The spin W = [w]× = Rᵀ Ṙ follows because Ṡ is symmetric:
// (s δ - S) w = axial(A - Aᵀ), with s = Tr S and the unit matrix δ.
[[gnu::always_inline]] inline Symmetric strain_rate(const Square3<Two>& A, const PolarPair& polar)
{
    const auto& a = A.a;
    const Two axial[3] = {a[2][1] - a[1][2], a[0][2] - a[2][0], a[1][0] - a[0][1]};
    Two w[3];
    solve_spin(polar, axial, w);
    const Symmetric& S = polar.S; // column j of W S is w × (column j of S)
    return {a[0][0] - (w[1] * S.xz - w[2] * S.xy), a[1][1] - (w[2] * S.xy - w[0] * S.yz),
            a[2][2] - (w[0] * S.yz - w[1] * S.xz), a[0][1] - (w[1] * S.yz - w[2] * S.yy),
            a[0][2] - (w[1] * S.zz - w[2] * S.yz), a[1][2] - (w[2] * S.xz - w[0] * S.zz)};
}

// The axial vector c of the skew-symmetric matrix σ S - S σ, with the stress σ = p.
[[gnu::always_inline]] inline void commutator(const Symmetric& p, const Symmetric& S, Two (&c)[3])
{
    const Two zy = p.xz * S.xy + p.yz * S.yy + p.zz * S.yz,
              yz = p.xy * S.xz + p.yy * S.yz + p.yz * S.zz;
    const Two xz = p.xx * S.xz + p.xy * S.yz + p.xz * S.zz,
              zx = p.xz * S.xx + p.yz * S.xy + p.zz * S.xz;
    const Two yx = p.xy * S.xx + p.yy * S.xy + p.yz * S.xz,
              xy = p.xx * S.xy + p.xy * S.yy + p.xz * S.yz;
    c[0] = zy - yz;
    c[1] = xz - zx;
    c[2] = yx - xy;
}

// Adds the forces on the corners, (f₁ f₂ f₃) = -V R T Bᵀ and f₀ = -(f₁ + f₂ + f₃), with the volume
// V of the element and T = σ - [z]×.
[[gnu::always_inline]] inline void scatter(const ElementPair& pair, const Square3<Two>& R,
                                           const Square3<Two>& T, std::vector<Vector3d>& forces)
{
    const Square3<Two> P = times(R, T);
    for (int i = 0; i < 3; ++i) {
        Two sum{0, 0};
        for (int j = 0; j < 3; ++j) {
            const Two f = -pair.volume * (P.a[i][0] * pair.B.a[j][0] + P.a[i][1] * pair.B.a[j][1] +
                                          P.a[i][2] * pair.B.a[j][2]);
            sum += f;
            forces[pair.nodes[0][j + 1]][i] += f[0];
            forces[pair.nodes[1][j + 1]][i] += f[1];
        }
        forces[pair.nodes[0][0]][i] -= sum[0];
        forces[pair.nodes[1][0]][i] -= sum[1];
    }
}

} // namespace

Elements::Elements(const Deformable& solid)
    : size_(static_cast<int>(solid.rest.tetrahedra.size())), lambda_(solid.material.lame_lambda()),
      G_(solid.material.shear_modulus()), beta_(solid.material.damping)
{
    pairs_.resize((size_ + 1) / 2);
    for (int slot = 0; slot < 2 * static_cast<int>(pairs_.size()); ++slot) {
        const int e = std::min(slot, size_ - 1), lane = slot % 2;
        ElementPair& pair = pairs_[slot / 2];
        const auto& t = solid.rest.tetrahedra[e];
        Matrix3d D;
        for (int i = 0; i < 4; ++i)
            pair.nodes[lane][i] = t[i];
        for (int i = 0; i < 3; ++i)
            D.col(i) = solid.rest.vertices[t[i + 1]] - solid.rest.vertices[t[0]];
        const Matrix3d B = D.inverse();
        for (int i = 0; i < 9; ++i)
            pair.B.a[i / 3][i % 3][lane] = B(i / 3, i % 3);
        pair.volume[lane] = slot < size_ ? matter_volume(solid, e) : 0;
        if (lane == 0) pair.is_plastic = false;
    }
    for (int e = 0; e < size_; ++e)
        set_plastic_strain(e, solid.plastic_strains[e]);
    if (size_ % 2 == 1)
        for (Two& component : pairs_.back().plastic)
            component[1] = component[0];
}

void Elements::set_plastic_strain(int element, const Matrix3d& strain)
{
    ElementPair& pair = pairs_[element / 2];
    const int lane = element % 2;
    const Matrix3d& e = strain;
    const double components[6] = {e(0, 0), e(1, 1), e(2, 2), e(0, 1), e(0, 2), e(1, 2)};
    for (int i = 0; i < 6; ++i)
        pair.plastic[i][lane] = components[i];
    if (!strain.isZero(0)) pair.is_plastic = true;
}

template <bool is_damped>
void Elements::add(std::span<const Vector3d> positions, std::span<const Vector3d> velocities,
                   std::vector<Vector3d>& forces) const
{
    const Two lambda{lambda_, lambda_}, G2{2 * G_, 2 * G_}, beta{beta_, beta_};
    for (const ElementPair& pair : pairs_) {
        const PolarPair polar = polar_pair(times(edges(pair, positions), pair.B));
        Symmetric e = elastic_part(polar.S, pair.plastic);
        if constexpr (is_damped) {
            const Square3<Two> A =
                transposed_times(polar.R, times(edges(pair, velocities), pair.B));
            const Symmetric d = strain_rate(A, polar);
            e = {e.xx + beta * d.xx, e.yy + beta * d.yy, e.zz + beta * d.zz,
                 e.xy + beta * d.xy, e.xz + beta * d.xz, e.yz + beta * d.yz};
        }
        // σ = λ Tr(ε) δ + 2 G ε
        const Two pressure = lambda * (e.xx + e.yy + e.zz);
        const Symmetric p{pressure + G2 * e.xx,
                          pressure + G2 * e.yy,
                          pressure + G2 * e.zz,
                          G2 * e.xy,
                          G2 * e.xz,
                          G2 * e.yz};
        Square3<Two> T = {{{p.xx, p.xy, p.xz}, {p.xy, p.yy, p.yz}, {p.xz, p.yz, p.zz}}};
        if (is_damped || pair.is_plastic) {
            Two c[3], z[3];
            commutator(p, polar.S, c);
            solve_spin(polar, c, z);
            T.a[0][1] += z[2], T.a[1][0] -= z[2]; // σ - [z]×
            T.a[0][2] -= z[1], T.a[2][0] += z[1];
            T.a[1][2] += z[0], T.a[2][1] -= z[0];
        }
        scatter(pair, polar.R, T, forces);
    }
}

void Elements::add_forces(std::span<const Vector3d> positions, std::span<const Vector3d> velocities,
                          std::vector<Vector3d>& forces) const
{
    if (beta_ > 0)
        add<true>(positions, velocities, forces);
    else
        add<false>(positions, velocities, forces);
}

void Elements::add_elastic_forces(std::span<const Vector3d> positions,
                                  std::vector<Vector3d>& forces) const
{
    add<false>(positions, positions, forces);
}

void Elements::strains(std::span<const Vector3d> positions,
                       std::vector<ElementStrain>& strains) const
{
    strains.resize(size_);
    for (int e = 0; e < size_; e += 2) {
        const ElementPair& pair = pairs_[e / 2];
        const PolarPair polar = polar_pair(times(edges(pair, positions), pair.B));
        const Symmetric s = elastic_part(polar.S, pair.plastic);
        for (int lane = 0; lane < 2 && e + lane < size_; ++lane) {
            ElementStrain& out = strains[e + lane];
            for (int i = 0; i < 9; ++i)
                out.R(i / 3, i % 3) = polar.R.a[i / 3][i % 3][lane];
            out.elastic << s.xx[lane], s.xy[lane], s.xz[lane], s.xy[lane], s.yy[lane], s.yz[lane],
                s.xz[lane], s.yz[lane], s.zz[lane];
        }
    }
}

std::array<Vector3d, 4> Elements::gradients(int element) const
{
    const ElementPair& pair = pairs_[element / 2];
    const int lane = element % 2;
    std::array<Vector3d, 4> gradients;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            gradients[i + 1][j] = pair.B.a[i][j][lane];
    gradients[0] = -gradients[1] - gradients[2] - gradients[3];
    return gradients;
}

std::array<int, 4> Elements::nodes(int element) const
{
    const auto& n = pairs_[element / 2].nodes[element % 2];
    return {n[0], n[1], n[2], n[3]};
}

} // namespace rigor
