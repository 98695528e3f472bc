// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/fabric_stiffness.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace toile {
namespace {

struct KnownStiffness {
    std::string_view fabric;  ///< id of the preset
    ClothStiffness stiffness;
};

/// A sheet of one material. @param modulus  Pa  @param thickness  m  @param weight  g/m²
constexpr ClothStiffness sheet(double modulus, double thickness, double weight) {
    constexpr double kPoisson = 0.3;
    ClothStiffness made = isotropicStiffness(
        modulus * thickness, kPoisson,
        modulus * thickness * thickness * thickness / (12 * (1 - kPoisson * kPoisson)));
    made.weight = weight;
    return made;
}

/// Weft, warp, coupling, shear, bending, weight: with their sources in docs/prove.md. One cloth of
/// [WOR11] each for woven, denim, jersey and spandex, the others estimated.
constexpr KnownStiffness kKnownStiffness[] = {
    {"woven", {2017, 2035, 9, 52, 125e-6, 220}},    {"denim", {205, 1014, 10, 27, 81e-6, 324}},
    {"canvas", {4000, 4000, 40, 150, 250e-6, 400}}, {"jersey", {17, 34, 0, 18, 19e-6, 187}},
    {"spandex", {48, 105, 7, 30, 56e-6, 204}},      {"neoprene", sheet(0.5e6, 3e-3, 600)},
    {"leather", sheet(10e6, 0.8e-3, 500)},          {"faux-leather", sheet(4e6, 0.8e-3, 350)},
    {"eva-foam", sheet(1.5e6, 5e-3, 500)},
};

}  // namespace

ClothStiffness clothStiffness(const Fabric& fabric) {
    const auto* found = std::ranges::find(kKnownStiffness, fabric.id, &KnownStiffness::fabric);
    return found == std::end(kKnownStiffness) ? kUnstatedStiffness : found->stiffness;
}

ClothStiffness StatedStiffness::over(ClothStiffness fabric) const {
    const double before = std::sqrt(fabric.warp * fabric.weft);
    fabric.warp = warp.value_or(fabric.warp);
    fabric.weft = weft.value_or(fabric.weft);
    fabric.coupling *= before > 0 ? std::sqrt(fabric.warp * fabric.weft) / before : 1;
    fabric.shear = shear.value_or(fabric.shear);
    fabric.bending = bending.value_or(fabric.bending);
    fabric.weight = weight.value_or(fabric.weight);
    return fabric;
}

}  // namespace toile
