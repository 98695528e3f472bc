// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/tailor/garment_body.h"
#include "core/tailor/tailor_cuts.h"

namespace toile {

/// What a tailor calls a part of a garment that has been cut: "front", "left sleeve", "right leg
/// back", "skirt front", "neck band"; left and right are the wearer's. Parts that are alike in
/// these words have the same.
/// @param body   of the whole piece
/// @param cuts   that were proposed for it; sleeves are beyond armholes, skirts below waists
/// @param part   cut from it: vertices on the rims of the whole lie where they lay
/// @return  empty where the body has no form that is known
/// Cost: linear in the part, and in the rims. Pure.
std::string partName(const Piece& whole, const GarmentBody& body,
                     const std::vector<TailorCut>& cuts, const Piece& part);

}  // namespace toile
