// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// How far a cloth gives way along one direction before it tears, puckers or bags; parts of its
/// length at rest, `least` <= 0 <= `most`.
struct StrainLimits {
    double least = 0;  ///< taken in without folds
    double most = 0;   ///< stretched

    bool operator==(const StrainLimits&) const = default;
};

inline constexpr double kUsualClothWidth = 1400;  // mm
inline constexpr double kMaxClothWidth = 100'000;

/// What a garment is cut from, as far as flattening needs it.
struct Fabric {
    std::string id;     ///< "woven"; of a preset, or "custom"; "unstated": nothing is known of it
    StrainLimits warp;  ///< along the grain
    StrainLimits weft;  ///< across it
    StrainLimits bias;  ///< at 45 degrees to it
    double width = kUsualClothWidth;  ///< as it is sold, across the warp, mm

    bool operator==(const Fabric&) const = default;
};

/// Common fabrics, the first of them the one to begin with: not stated, without limits. Rules of
/// thumb, not measurements: where it matters a sample is to be measured and the limits typed in.
/// Widths are common ones.
inline std::span<const Fabric> fabricPresets() {
    static const Fabric presets[] = {
        {"unstated", {}, {}, {}},
        {"woven", {-0.01, 0.02}, {-0.01, 0.03}, {-0.03, 0.08}},
        {"denim", {-0.005, 0.01}, {-0.005, 0.015}, {-0.015, 0.04}, 1500},
        {"canvas", {-0.005, 0.01}, {-0.005, 0.02}, {-0.02, 0.05}},
        {"jersey", {-0.05, 0.15}, {-0.08, 0.35}, {-0.06, 0.25}, 1600},
        {"spandex", {-0.08, 0.40}, {-0.08, 0.50}, {-0.08, 0.45}, 1500},
        {"neoprene", {-0.04, 0.20}, {-0.04, 0.20}, {-0.04, 0.20}, 1300},
        {"leather", {-0.005, 0.03}, {-0.005, 0.05}, {-0.005, 0.04}},
        {"faux-leather", {-0.005, 0.04}, {-0.005, 0.08}, {-0.005, 0.06}},
        {"eva-foam", {-0.03, 0.05}, {-0.03, 0.05}, {-0.03, 0.05}, 1000},
    };
    return presets;
}

/// Whether anything is known of what the fabric takes: false as long as nobody has stated it.
inline bool hasLimits(const Fabric& fabric) {
    return fabric.id != fabricPresets().front().id;
}

/// The preset whose limits it has, as they are, whatever its width; null where there is none.
inline const Fabric* presetOf(const Fabric& fabric) {
    const auto presets = fabricPresets();
    const auto found = std::ranges::find_if(presets, [&fabric](const Fabric& preset) {
        return preset.id == fabric.id && preset.warp == fabric.warp && preset.weft == fabric.weft &&
               preset.bias == fabric.bias;
    });
    return found == presets.end() ? nullptr : &*found;
}

/// What goes beyond a preset is a matter of judgement; limits that a person typed are not.
inline bool isRuleOfThumb(const Fabric& fabric) {
    return presetOf(fabric) != nullptr;
}

/// What some pieces are cut from beside the garment's own fabric: its lining, an interfacing.
struct Material {
    std::string name;  ///< as a person calls it
    Fabric fabric = fabricPresets().front();

    bool operator==(const Material&) const = default;
};

/// By name, each once.
using MaterialList = std::vector<Material>;

/// Null where it is none of these, or has no name.
inline const Material* findMaterial(std::string_view name, const MaterialList& materials) {
    const auto found = std::ranges::find(materials, name, &Material::name);
    return name.empty() || found == materials.end() ? nullptr : &*found;
}

/// What a piece of this material is cut from: the garment's own fabric where it is none of these.
inline const Fabric& fabricOf(std::string_view material, const MaterialList& materials,
                              const Fabric& own) {
    const Material* found = findMaterial(material, materials);
    return found ? found->fabric : own;
}

/// The preset of this id; null where there is none.
inline const Fabric* fabricPreset(std::string_view id) {
    const auto presets = fabricPresets();
    const auto found = std::ranges::find(presets, id, &Fabric::id);
    return found == presets.end() ? nullptr : &*found;
}

}  // namespace toile
