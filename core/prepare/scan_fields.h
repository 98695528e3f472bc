// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/setting.h"
#include "core/prepare/preparation.h"

namespace toile {

/// Description of the steps that prepare a scan, for project files and forms
/// (core/base/field_archive.h).
inline constexpr auto kScanStepFields = [](auto& at, auto& steps) {
    at.field(Setting{"dropDebris", TR("Drop &debris"), TR("Drop debris"),
                     TR("Leave out fragments that are too small for a piece, but not several of "
                        "one kind, such as buttons")},
             steps.dropDebris);
    at.field(Setting{.key = "largestHole",
                     .title = TR("Close &holes with a perimeter up to"),
                     .name = TR("Close holes"),
                     .help = TR("Patches continue the cloth around them; neck, sleeves and hem "
                                "stay open, however short they are"),
                     .hasSwitch = true},
             steps.largestHole, 0, kMaxPreparedLength);
    at.field(Setting{.key = "smoothing",
                     .title = TR("&Smooth noise by at most"),
                     .name = TR("Smooth noise"),
                     .help = TR("No point moves farther; folds and hems stay"),
                     .hasSwitch = true},
             steps.smoothing, 0, kMaxPreparedLength);
    at.field(Setting{.key = "edgeLength",
                     .title = TR("&Remesh with edges of"),
                     .name = TR("Edge length of the mesh"),
                     .help = TR("Replace the triangles by ones of about equal size; the names and "
                                "the UV map of the file are lost"),
                     .hasSwitch = true},
             steps.edgeLength, 0, kMaxPreparedLength);
};

}  // namespace toile
