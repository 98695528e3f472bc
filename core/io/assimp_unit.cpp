// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/assimp_unit.h"

#include <cmath>

#include <assimp/scene.h>

#include "core/base/text.h"
#include "core/io/text_cursor.h"

namespace toile {
namespace {

/// FBX states how many centimetres its unit has; assimp leaves the coordinates as they are.
AssimpUnit unitOfFbx(const aiScene& scene) {
    float stated = 0;
    const bool known =
        scene.mMetaData != nullptr && scene.mMetaData->Get("UnitScaleFactor", stated);
    if (!known || !std::isfinite(stated) || stated <= 0) {
        return {};
    }
    const auto factor = static_cast<double>(stated);
    constexpr double kSame = 1e-6;  // the factor is a float
    for (const LengthUnit unit :
         {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch}) {
        const double centimetres = millimetresPer(unit) / 10;
        if (std::abs(factor / centimetres - 1) < kSame) {
            return {StatedUnit{unit, worded("stated in the FBX file")}};
        }
    }
    return {StatedUnit{LengthUnit::Centimetre,
                       worded("the FBX file's own unit is %1 cm", {figure(factor, 3)})},
            factor};
}

}  // namespace

AssimpUnit unitOf(const aiScene& scene, std::string_view ending) {
    if (equalsIgnoringCase(ending, ".glb") || equalsIgnoringCase(ending, ".gltf")) {
        return {StatedUnit{LengthUnit::Metre, worded("glTF files are in metres")}};
    }
    if (equalsIgnoringCase(ending, ".dae")) {
        // Assimp scales the root by the unit that the file states, metres where it states none.
        return {StatedUnit{LengthUnit::Metre,
                           worded("Collada files state their unit; read as metres")}};
    }
    return equalsIgnoringCase(ending, ".fbx") ? unitOfFbx(scene) : AssimpUnit{};
}

}  // namespace toile
