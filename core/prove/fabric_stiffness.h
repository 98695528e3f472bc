// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/garment/fabric.h"
#include "core/sew/cloth_stiffness.h"

namespace toile {

/// How a fabric resists and what it weighs: of a preset as docs/prove.md has it with its source, by
/// the id; of a fabric that is not stated, or of a person's own, a sheet that is alike in all
/// directions (`sew::kUnstatedStiffness`), which favours no grain. Pure.
sew::ClothStiffness clothStiffness(const Fabric& fabric);

/// What a person has measured and said of the cloth; the rest is as its fabric is.
struct StatedStiffness {
    std::optional<double> warp{}, weft{};  ///< N/m
    std::optional<double> shear{};         ///< N/m
    std::optional<double> bending{};       ///< N·m
    std::optional<double> weight{};        ///< g/m²

    /// Warp and weft draw on each other as before, in parts of their own stiffness.
    sew::ClothStiffness over(sew::ClothStiffness fabric) const;
    bool operator==(const StatedStiffness&) const = default;
};

}  // namespace toile
