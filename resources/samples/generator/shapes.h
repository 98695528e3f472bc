// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "piece.h"

namespace toile::samples {

/// A cube of 8 x 8 squares a side, 768 triangles, cut along five edges shaped like an H, each
/// square by one diagonal, alternating: the cube of C. C. L. Wang, "Length-preserved Natural
/// Boundary for Intrinsic Parameterization" (2005), Table 1, Example IV.
Garment makeCubeOpenedAlongH();

}  // namespace toile::samples
