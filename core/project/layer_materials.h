// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/garment/fabric.h"
#include "core/garment/garment.h"
#include "core/project/piece_settings.h"

namespace toile {

/// Number of layers of a file (FileReading::layerOfFace), mostly 1. Linear.
int layerCount(const FileReading& reading);

/// Per piece: its layer, counted from the outermost, 0; empty if no file has several layers.
/// Linear. Pure.
std::vector<int> layersOf(const Garment& garment);

/// Per piece: the default material. Each inner layer has its own material, named for the user:
/// "Lining", or "Layer 2" if there are more. Other pieces use the garment's fabric (empty). Linear.
/// Pure.
std::vector<Wording> usualMaterials(const Garment& garment);

/// Default settings for the pieces of a garment. Linear. Pure.
std::vector<PieceSettings> usualSettings(const Garment& garment);

/// The materials used by pieces, and others whose fabric differs from the garment's; new ones start
/// with the garment's fabric. @param used  names or empty  Cost: used times known. Pure.
MaterialList materialsInUse(MaterialList known, const std::vector<std::string>& used,
                            const Fabric& own);

}  // namespace toile
