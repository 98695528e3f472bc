// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/garment/fabric.h"
#include "core/sew/cloth_stiffness.h"

namespace toile {

/// Stiffness and weight of a fabric. Presets are found by id and documented in docs/prove.md;
/// unknown fabrics and those of the user are an isotropic sheet (`sew::kUnstatedStiffness`), which
/// favours no grain. Pure.
sew::ClothStiffness clothStiffness(const Fabric& fabric);

/// Measured values set by the user; empty fields use the fabric's values.
struct StatedStiffness {
    std::optional<double> warp{}, weft{};  ///< N/m
    std::optional<double> shear{};         ///< N/m
    std::optional<double> bending{};       ///< N·m
    std::optional<double> weight{};        ///< g/m²

    /// Coupling of warp and weft keeps its ratio to their stiffness.
    sew::ClothStiffness over(sew::ClothStiffness fabric) const;
    bool operator==(const StatedStiffness&) const = default;
};

}  // namespace toile
