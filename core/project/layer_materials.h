// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// Of how many layers a file consists (FileReading::layerOfFace); 1 of most. Linear.
int layerCount(const FileReading& reading);

/// Per piece: the layer that it is of, from the outermost, 0; empty where no file has several.
/// Linear. Pure.
std::vector<int> layersOf(const Garment& garment);

/// Per piece: what it is cut from as long as nobody has said it. Inner layers are cut from a
/// material each, in words for a person: "Lining", or "Layer 2" where there are more; the others
/// from the garment's own fabric, empty. Linear. Pure.
std::vector<Wording> usualMaterials(const Garment& garment);

/// What is said of the pieces of a garment of which nobody has said anything. Linear. Pure.
std::vector<PieceSettings> usualSettings(const Garment& garment);

/// The materials that some pieces name, and those that have a fabric of their own; new ones begin
/// as the garment's fabric. @param used  names, also empty ones  Cost: of used times known. Pure.
MaterialList materialsInUse(MaterialList known, const std::vector<std::string>& used,
                            const Fabric& own);

}  // namespace toile
