// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/fabric.h"

#include <algorithm>

namespace toile {

std::span<const Fabric> fabricPresets() {
    static const Fabric presets[] = {
        {"woven", {-0.01, 0.02}, {-0.01, 0.03}, {-0.03, 0.08}},
        {"denim", {-0.005, 0.01}, {-0.005, 0.015}, {-0.015, 0.04}},
        {"jersey", {-0.05, 0.15}, {-0.08, 0.35}, {-0.06, 0.25}},
        {"neoprene", {-0.04, 0.20}, {-0.04, 0.20}, {-0.04, 0.20}},
        {"leather", {-0.005, 0.03}, {-0.005, 0.05}, {-0.005, 0.04}},
    };
    return presets;
}

const Fabric* fabricPreset(std::string_view id) {
    const auto presets = fabricPresets();
    const auto found = std::ranges::find(presets, id, &Fabric::id);
    return found == presets.end() ? nullptr : &*found;
}

}  // namespace toile
