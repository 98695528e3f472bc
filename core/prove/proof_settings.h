// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/units.h"
#include "core/base/wording.h"
#include "core/garment/fabric_stiffness.h"

namespace toile {

/// Limits of `ProofSettings::edge` if it is set, mm.
inline constexpr double kMinProofEdge = 1, kMaxProofEdge = 500;
/// Limits of `ProofSettings::thickness`, mm.
inline constexpr double kMinThickness = 0.1, kMaxThickness = 10;
/// Limit of `ProofSettings::pressure`, in either direction, N/m².
inline constexpr double kMaxPressure = 1e5;
/// Limits of `StatedStiffness`: warp and weft, N/m; shear, N/m; bending, N·m; weight, g/m².
inline constexpr double kMinStretch = 1, kMaxStretch = 1e7;
inline constexpr double kMinShear = 0.01, kMaxShear = kMaxStretch;
inline constexpr double kMaxBending = 10, kMaxClothWeight = 1e5;

/// User settings for sewing a pattern, and for the forces on it.
struct ProofSettings {
    /// Length of the edges of the fresh triangles, mm; 0: like the garment's own.
    double edge = 0;
    /// Towards the design or the body, N/m² (10 Pa: 1 g on 10 cm²); negative: outwards, like a
    /// cushion's filling.
    double pressure = 10;
    bool hasGravity = false;      ///< down the y axis
    bool touchesItself = false;   ///< false: cloth passes through cloth
    double thickness = 1;         ///< distance between layers if touchesItself, mm
    StatedStiffness stiffness{};  ///< replaces values of the pieces' fabrics
    int threads = 0;              ///< 0: all cores; results do not depend on it

    bool operator==(const ProofSettings&) const = default;
};

/// The pattern to sew back together.
enum class SewnPattern {
    Own,        ///< the garment's, written to a file and read back
    Designer,   ///< the designer's own panels, if the garment's file has them
    Reference,  ///< the pattern file that the pieces are compared with
};

/// Names in project files. They must not change once released.
inline constexpr Word<SewnPattern> kSewnPatternWords[] = {{SewnPattern::Own, "own"},
                                                          {SewnPattern::Designer, "designer"},
                                                          {SewnPattern::Reference, "reference"}};

/// User settings for proving a garment's pattern.
struct ProofPlan {
    SewnPattern sewn = SewnPattern::Own;
    std::filesystem::path body{};        ///< body mesh to wear it; empty: the design's own surface
    std::optional<FileUnit> bodyUnit{};  ///< of its coordinates; none: see `readBody`
    ProofSettings settings{};

    bool operator==(const ProofPlan&) const = default;
};

}  // namespace toile
