// SPDX-License-Identifier: MIT
// Forces and strains of all elements of a solid. Data is laid out for the inner loop, which
// computes two elements at once in vector registers.
#pragma once

#include "deformable/elasticity/closed_polar.hpp"
#include "deformable/solid/deformable.hpp"

#include <span>

namespace rigor {

/// One number for each of two elements.
using Two [[gnu::vector_size(16)]] = double;

/// The data that the inner loop reads for two elements. If the number of elements is odd, the last
/// one is paired with a copy of itself that has volume 0.
struct ElementPair {
    int nodes[2][4];
    // [X₁ - X₀, X₂ - X₀, X₃ - X₀]⁻¹ [1/m]. Row i, counted from 0, is ∇N, the gradient of the shape
    // function of corner i + 1.
    Square3<Two> B;
    Two volume;     // volume of the material [m³]
    Two plastic[6]; // ε_p: xx, yy, zz, xy, xz, yz
    bool is_plastic;
};

/// The elastic part of an element's strain, and its rotation.
struct ElementStrain {
    Matrix3d R, elastic;
};

class Elements {
public:
    explicit Elements(const Deformable& solid);

    int size() const { return size_; }

    /// Adds to each node the elastic and the damping forces of its elements, -V P ∇N [N], with the
    /// volume V of an element and the gradient ∇N of the node's shape function.
    ///
    /// P = R (σ - [z]×), where σ is the stress that an elastic strain ε - ε_p + β Ṡ would cause.
    /// Without plastic strain and damping, σ and S commute, and z = 0. Otherwise, with s = Tr S,
    /// z = (s δ - S)⁻¹ axial(σ S - S σ) makes the power P : Ḟ equal to σ : Ṡ. A rotation has Ṡ = 0
    /// and takes no power, so the forces of an element have no torque on it. The exception is an
    /// element deformed so far that R is almost no longer unique: there z is reduced, down to 0.
    /// [z]× is the cross-product matrix of z, and axial(A) the vector a with [a]× = A.
    void add_forces(std::span<const Vector3d> positions, std::span<const Vector3d> velocities,
                    std::vector<Vector3d>& forces) const;

    void add_elastic_forces(std::span<const Vector3d> positions,
                            std::vector<Vector3d>& forces) const;

    /// The rotation R and the elastic strain ε - ε_p of each element at these positions.
    void strains(std::span<const Vector3d> positions, std::vector<ElementStrain>& strains) const;

    void set_plastic_strain(int element, const Matrix3d& strain);

    /// ∇N, the gradient of the shape function, of each corner of an element, in rest space [1/m].
    std::array<Vector3d, 4> gradients(int element) const;
    double volume(int element) const { return pairs_[element / 2].volume[element % 2]; }
    std::array<int, 4> nodes(int element) const;

private:
    template <bool is_damped>
    void add(std::span<const Vector3d> positions, std::span<const Vector3d> velocities,
             std::vector<Vector3d>& forces) const;

    std::vector<ElementPair> pairs_;
    int size_ = 0;
    double lambda_ = 0, G_ = 0, beta_ = 0;
};

} // namespace rigor
