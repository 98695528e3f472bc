// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace toile {

/// How far cloth can be strained along one direction before it tears, puckers or bags; parts of its
/// length at rest, `least` <= 0 <= `most`.
struct StrainLimits {
    double least = 0;  ///< compressed without folds
    double most = 0;   ///< stretched

    bool operator==(const StrainLimits&) const = default;
};

inline constexpr double kUsualClothWidth = 1400;  // mm
inline constexpr double kMaxClothWidth = 100'000;

/// The properties of the cut fabric that matter for flattening.
struct Fabric {
    std::string id;                   ///< "woven"; of a preset, or "custom"; "unstated": unknown
    StrainLimits warp;                ///< along the grain
    StrainLimits weft;                ///< across it
    StrainLimits bias;                ///< at 45 degrees to it
    double width = kUsualClothWidth;  ///< as sold, across the warp, mm

    bool operator==(const Fabric&) const = default;
};

/// Common fabrics; the first one, the default, is not stated and has no limits. These are rules of
/// thumb, not measurements: for accurate limits, measure a sample and type them in. Widths are
/// common ones.
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

/// Whether the fabric's limits are known: false until the user states them.
inline bool hasLimits(const Fabric& fabric) {
    return fabric.id != fabricPresets().front().id;
}

/// The preset with the same limits, whatever its width; null if there is none.
inline const Fabric* presetOf(const Fabric& fabric) {
    const auto presets = fabricPresets();
    const auto found = std::ranges::find_if(presets, [&fabric](const Fabric& preset) {
        return preset.id == fabric.id && preset.warp == fabric.warp && preset.weft == fabric.weft &&
               preset.bias == fabric.bias;
    });
    return found == presets.end() ? nullptr : &*found;
}

/// Limits of a preset are a matter of judgement; limits typed by the user are not.
inline bool isRuleOfThumb(const Fabric& fabric) {
    return presetOf(fabric) != nullptr;
}

/// A second fabric of some pieces besides the garment's own: its lining, an interfacing.
struct Material {
    std::string name;  ///< the user's name for it
    Fabric fabric = fabricPresets().front();

    bool operator==(const Material&) const = default;
};

/// By name, each name once.
using MaterialList = std::vector<Material>;

/// Null if the name is empty or not among these.
inline const Material* findMaterial(std::string_view name, const MaterialList& materials) {
    const auto found = std::ranges::find(materials, name, &Material::name);
    return name.empty() || found == materials.end() ? nullptr : &*found;
}

/// The fabric of a material: the garment's own fabric if the material is not among these.
inline const Fabric& fabricOf(std::string_view material, const MaterialList& materials,
                              const Fabric& own) {
    const Material* found = findMaterial(material, materials);
    return found ? found->fabric : own;
}

/// The preset with this id; null if there is none.
inline const Fabric* fabricPreset(std::string_view id) {
    const auto presets = fabricPresets();
    const auto found = std::ranges::find(presets, id, &Fabric::id);
    return found == presets.end() ? nullptr : &*found;
}

}  // namespace toile
