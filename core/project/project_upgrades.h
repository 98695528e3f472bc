// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>

#include "core/base/json_fields.h"

namespace toile {

/// The version of the project format that is written, and up to which files are read.
inline constexpr int kProjectVersion = 2;

/// Makes a document of one version into one of the next, as far as it is what it should be: what is
/// wrong in it is found when it is read.
struct ProjectUpgrade {
    int from;
    void (*apply)(JsonDocument& document);
};

/// Version 1 knew pieces by name: `pieces` was an object, `partOf` a name.
void listPieces(JsonDocument& document);

/// One for each version before the present one.
inline constexpr ProjectUpgrade kProjectUpgrades[] = {{1, listPieces}};

/// Applies, one after the other, the upgrades from `version` on; each says its new "version".
inline void upgradeProject(JsonDocument& document, int version,
                           std::span<const ProjectUpgrade> upgrades) {
    for (;; ++version) {
        const auto next = std::ranges::find(upgrades, version, &ProjectUpgrade::from);
        if (next == upgrades.end()) {
            return;
        }
        next->apply(document);
        document["version"] = version + 1;
    }
}

}  // namespace toile
