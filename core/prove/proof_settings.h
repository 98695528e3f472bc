// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "core/base/units.h"
#include "core/base/words.h"
#include "core/prove/fabric_stiffness.h"

namespace toile {

/// Limits of `ProofSettings::edge` where a person states it, mm.
inline constexpr double kLeastProofEdge = 1, kMostProofEdge = 500;
/// Limits of `ProofSettings::thickness`, mm.
inline constexpr double kLeastThickness = 0.1, kMostThickness = 10;
/// Of `ProofSettings::pressure`, either way, N/m².
inline constexpr double kMostPressure = 1e5;
/// Of `StatedStiffness`: of warp and weft, N/m; of shear, N/m; of bending, N·m; of weight, g/m².
inline constexpr double kLeastStretch = 1, kMostStretch = 1e7;
inline constexpr double kLeastShear = 0.01, kMostShear = kMostStretch;
inline constexpr double kMostBending = 10, kMostClothWeight = 1e5;

/// How a pattern is sewn and what holds it meanwhile, as a person has said it.
struct ProofSettings {
    /// Length of the edges of the fresh triangles, mm; 0: as the garment's own are.
    double edge = 0;
    /// Towards the design or the body, N/m² (10 Pa: 1 g on 10 cm²); below 0: outwards, as of a
    /// cushion's filling.
    double pressure = 10;
    bool hasGravity = false;      ///< down the y axis
    bool touchesItself = false;   ///< else cloth goes through cloth
    double thickness = 1;         ///< that cloth keeps off itself then, mm
    StatedStiffness stiffness{};  ///< in place of what the pieces' fabrics have
    int threads = 0;              ///< 0: as many as the machine has cores; the same bytes for any

    bool operator==(const ProofSettings&) const = default;
};

/// What is sewn back together.
enum class SewnPattern {
    Own,        ///< the garment's, as it is written to a file and read back
    Designer,   ///< the designer's own panels, where the garment's file has them
    Reference,  ///< the pattern file that the pieces are compared with
};

/// What they are called in project files. Once released they stay.
inline constexpr Word<SewnPattern> kSewnPatternWords[] = {{SewnPattern::Own, "own"},
                                                          {SewnPattern::Designer, "designer"},
                                                          {SewnPattern::Reference, "reference"}};

/// How a garment's pattern is proved, as a person has said it.
struct ProofPlan {
    SewnPattern sewn = SewnPattern::Own;
    std::filesystem::path body{};  ///< what it is worn on, a mesh; empty: the design's own surface
    std::optional<FileUnit> bodyUnit{};  ///< of its coordinates; none: see `readBody`
    ProofSettings settings{};

    bool operator==(const ProofPlan&) const = default;
};

}  // namespace toile
