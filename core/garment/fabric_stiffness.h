// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/garment/fabric.h"

namespace toile {

/// Resistance of cloth to deformation (tangent moduli at rest of an orthotropic sheet), and its
/// weight.
struct ClothStiffness {
    double weft = 1000;     ///< force per width and strain along the weft, N/m
    double warp = 1000;     ///< along the warp, N/m
    double coupling = 300;  ///< between both (C12), N/m; below the mean of the two
    double shear = 350;     ///< force per width and shear angle, N/m
    double bending = 1e-5;  ///< moment per width and curvature, N·m
    double weight = 150;    ///< g/m²; only used with gravity

    bool operator==(const ClothStiffness&) const = default;
};

/// An isotropic sheet. @param stretch  E h, N/m  @param poisson  in [0, 1)
constexpr ClothStiffness isotropicStiffness(double stretch, double poisson, double bending) {
    const double along = stretch / (1 - poisson * poisson);
    return {along, along, poisson * along, stretch / (2 * (1 + poisson)), bending};
}

/// Default if the fabric is unknown; not measured. Woven fabrics shear far more easily; an
/// isotropic sheet favours no grain.
inline constexpr ClothStiffness kUnstatedStiffness = isotropicStiffness(1000, 0.3, 1e-5);

/// By piece number, as in `sew::Cloth::pieceOf`; pieces past the end use the default.
using PieceStiffness = std::vector<ClothStiffness>;

inline const ClothStiffness& stiffnessOf(const PieceStiffness& pieces, int piece) {
    const auto number = static_cast<std::size_t>(piece);
    return number < pieces.size() ? pieces[number] : kUnstatedStiffness;
}

/// Stiffness and weight of a fabric. Presets are found by id and documented in docs/prove.md;
/// unknown fabrics and those of the user are an isotropic sheet (`kUnstatedStiffness`), which
/// favours no grain. Pure.
ClothStiffness clothStiffness(const Fabric& fabric);

/// Measured values set by the user; empty fields use the fabric's values.
struct StatedStiffness {
    std::optional<double> warp{}, weft{};  ///< N/m
    std::optional<double> shear{};         ///< N/m
    std::optional<double> bending{};       ///< N·m
    std::optional<double> weight{};        ///< g/m²

    /// Coupling of warp and weft keeps its ratio to their stiffness.
    ClothStiffness over(ClothStiffness fabric) const;
    bool operator==(const StatedStiffness&) const = default;
};

}  // namespace toile
