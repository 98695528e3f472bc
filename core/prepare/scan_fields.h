// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/setting.h"
#include "core/prepare/preparation.h"

namespace toile {

/// Description of the steps that prepare a scan, for project files and forms
/// (core/base/field_archive.h).
inline constexpr auto kScanStepFields = [](auto& at, auto& steps) {
    at.field(Setting{"dropDebris", TR("Drop &debris"), TR("Drop debris"),
                     TR("Leave out fragments too small for a piece; groups of one kind, such as "
                        "buttons, stay")},
             steps.dropDebris);
    at.field(
        Setting{
            .key = "largestHole",
            .title = TR("Close &holes with a perimeter up to"),
            .name = TR("Close holes"),
            .help = TR(
                "Fill holes with cloth; neck, sleeves and hem stay open, however short they are"),
            .hasSwitch = true},
        steps.largestHole, 0, kMaxPreparedLength);
    at.field(Setting{.key = "smoothing",
                     .title = TR("&Smooth noise by at most"),
                     .name = TR("Smooth noise"),
                     .help = TR("Largest movement of a point; folds and hems stay"),
                     .hasSwitch = true},
             steps.smoothing, 0, kMaxPreparedLength);
    at.field(
        Setting{.key = "edgeLength",
                .title = TR("&Remesh with edges of"),
                .name = TR("Edge length of the mesh"),
                .help = TR(
                    "Replace the mesh by triangles of about equal size; names and UV map are lost"),
                .hasSwitch = true},
        steps.edgeLength, 0, kMaxPreparedLength);
};

}  // namespace toile
