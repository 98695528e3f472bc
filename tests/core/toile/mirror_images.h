// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/symmetry/symmetry.h"

namespace toile::test {

/// Per piece: whether it is drawn as a mirror image.
std::vector<bool> areMirrored(const PieceResults& results);

/// Those that are lie on their counterparts once they are reflected and laid over them.
void expectMirrorImages(const Garment& garment, const Symmetry& symmetry,
                        const PieceResults& results);

/// Every piece is drawn with the lengths it is to have, without flipped triangles, and seams are
/// equally long on both sides, or as long as their ease has it.
void expectLengths(const Garment& garment, const PieceResults& results);

}  // namespace toile::test
