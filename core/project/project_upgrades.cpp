// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project_upgrades.h"

#include <algorithm>

namespace toile {

std::span<const ProjectUpgrade> projectUpgrades() {
    return {};
}

void upgradeProject(JsonDocument& document, int version, std::span<const ProjectUpgrade> upgrades) {
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
