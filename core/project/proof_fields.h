// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/field_archive.h"
#include "core/prove/proof_settings.h"

namespace toile::project_fields {

/// Fields of a project file for the proof; included in one file.

inline constexpr auto kStiffness = [](auto& at, auto& stated) {
    at.field("warp", stated.warp, kMinStretch, kMaxStretch);
    at.field("weft", stated.weft, kMinStretch, kMaxStretch);
    at.field("shear", stated.shear, kMinShear, kMaxShear);
    at.field("bending", stated.bending, 0, kMaxBending);
    at.field("weight", stated.weight, 0, kMaxClothWeight);
};

/// Writes values that differ from the defaults, except the body's file, which depends on the
/// location of the project, and the threads, which depend on the machine.
inline constexpr auto kProof = [](auto& at, auto& plan) {
    const ProofPlan usual;
    auto& settings = plan.settings;
    const auto field = [&at](const char* key, auto& value, const auto& unsaid, auto... limits) {
        if (at.kReads || !(value == unsaid)) {
            at.field(key, value, limits...);
        }
    };
    if (at.kReads || plan.sewn != usual.sewn) {
        at.word("sewn", plan.sewn, kSewnPatternWords);
    }
    at.field("bodyUnit", plan.bodyUnit);
    field("edge", settings.edge, usual.settings.edge, kMinProofEdge, kMaxProofEdge);
    field("pressure", settings.pressure, usual.settings.pressure, -kMaxPressure, kMaxPressure);
    field("gravity", settings.hasGravity, usual.settings.hasGravity);
    field("selfContact", settings.touchesItself, usual.settings.touchesItself);
    field("thickness", settings.thickness, usual.settings.thickness, kMinThickness, kMaxThickness);
    if (at.kReads || !(settings.stiffness == StatedStiffness{})) {
        at.object("stiffness", settings.stiffness, kStiffness);
    }
};

}  // namespace toile::project_fields
