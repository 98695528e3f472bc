// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/tailor/garment_body.h"
#include "core/tailor/tailor_cuts.h"

namespace toile {

/// A tailor's name for a part of a garment that has been cut: "front", "left sleeve", "right leg
/// back", "skirt front", "neck band"; left and right are the wearer's. Names need not be unique.
/// @param body   of the whole piece
/// @param cuts   proposed for it; sleeves are beyond armholes, skirts below waists
/// @param part   cut from it: vertices on the rims of the whole keep their positions
/// @return  empty if the form of the body is unknown
/// Cost: linear in the part, and in the rims. Pure.
std::string partName(const Piece& whole, const GarmentBody& body,
                     const std::vector<TailorCut>& cuts, const Piece& part);

}  // namespace toile
