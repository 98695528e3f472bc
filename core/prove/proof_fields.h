// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/setting.h"
#include "core/prove/proof_settings.h"

namespace toile {

/// Descriptions of the settings of a proof, for project files and forms
/// (core/base/field_archive.h).

inline constexpr const char* kSewnPatternNames[] = {TR("This pattern"), TR("The designer's panels"),
                                                    TR("The reference pattern")};

inline constexpr auto kStiffnessFields = [](auto& at, auto& stated) {
    constexpr const char *kAsFabric = TR("From fabric"), *kPerMetre = TR("N/m");
    at.field(Setting{"warp",
                     TR("Stretch, warp"),
                     TR("Stretch stiffness along the warp"),
                     TR("Force per strain of a strip 1 m wide, stretched along the warp"),
                     kAsFabric,
                     {},
                     Quantity::Other,
                     nullptr,
                     kPerMetre},
             stated.warp, kMinStretch, kMaxStretch);
    at.field(Setting{"weft",
                     TR("Stretch, weft"),
                     TR("Stretch stiffness along the weft"),
                     TR("Force per strain of a strip 1 m wide, stretched along the weft"),
                     kAsFabric,
                     {},
                     Quantity::Other,
                     nullptr,
                     kPerMetre},
             stated.weft, kMinStretch, kMaxStretch);
    at.field(Setting{"shear",
                     TR("Shear"),
                     TR("Shear stiffness"),
                     TR("Resistance to shear, as when the cloth is pulled on the bias"),
                     kAsFabric,
                     {},
                     Quantity::Other,
                     nullptr,
                     kPerMetre},
             stated.shear, kMinShear, kMaxShear);
    at.field(Setting{"bending",
                     TR("Bending"),
                     TR("Bending stiffness"),
                     TR("Resistance to bending"),
                     kAsFabric,
                     {},
                     Quantity::Other,
                     nullptr,
                     TR("µN·m"),
                     1e-6},
             stated.bending, 0, kMaxBending);
    at.field(Setting{"weight",
                     TR("Weight"),
                     TR("Weight of the cloth"),
                     TR("Only used with gravity"),
                     kAsFabric,
                     {},
                     Quantity::Other,
                     nullptr,
                     TR("g/m²")},
             stated.weight, 0, kMaxClothWeight);
};

/// Writes values that differ from the defaults, except the body's file, which depends on the
/// location of the project, and the threads, which depend on the machine.
inline constexpr auto kProofFields = [](auto& at, auto& plan) {
    const ProofPlan usual;
    auto& settings = plan.settings;
    const auto field = [&at](const auto& key, auto& value, const auto& unstated, auto... limits) {
        if (at.kReads || !(value == unstated)) {
            at.field(key, value, limits...);
        }
    };
    if (at.kReads || plan.sewn != usual.sewn) {
        at.word(
            Setting{"sewn", TR("Pattern to test"), TR("Pattern of the proof"),
                    TR("The pattern as written to a file and read back, or another one to compare"),
                    nullptr, kSewnPatternNames},
            plan.sewn, kSewnPatternWords);
    }
    at.field("bodyUnit", plan.bodyUnit);
    field(Setting{.key = "edge",
                  .title = TR("Triangles"),
                  .name = TR("Triangles of the proof"),
                  .help = TR("Edge length of the sewn triangles; shorter edges are finer and "
                             "slower. 0: as in the garment"),
                  .none = TR("As in the garment")},
          settings.edge, usual.settings.edge, kMinProofEdge, kMaxProofEdge);
    field(Setting{"pressure",
                  TR("Pressure"),
                  TR("Pressure of the proof"),
                  TR("Presses the cloth onto the dress form; negative values inflate it. 10 Pa are "
                     "1 g on 10 cm²"),
                  nullptr,
                  {},
                  Quantity::Other,
                  nullptr,
                  TR("Pa")},
          settings.pressure, usual.settings.pressure, -kMaxPressure, kMaxPressure);
    field(Setting{"gravity", TR("Gravity"), TR("Proof with gravity"),
                  TR("Let the cloth hang under its weight")},
          settings.hasGravity, usual.settings.hasGravity);
    field(Setting{"selfContact", TR("Cloth touches itself"), TR("Proof with layers that touch"),
                  TR("Keep layers of cloth apart (slower); otherwise cloth passes through cloth")},
          settings.touchesItself, usual.settings.touchesItself);
    field(Setting{"thickness", TR("Thickness"), TR("Thickness of the cloth"),
                  TR("Distance between layers of cloth")},
          settings.thickness, usual.settings.thickness, kMinThickness, kMaxThickness);
    if (at.kReads || !(settings.stiffness == StatedStiffness{})) {
        at.object("stiffness", settings.stiffness, kStiffnessFields);
    }
};

}  // namespace toile
