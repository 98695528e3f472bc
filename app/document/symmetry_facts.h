// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/flatten/base/piece_result.h"
#include "core/garment/garment.h"
#include "core/symmetry/symmetry.h"

namespace toile::app {

/// Two pieces that mirror each other, one that is symmetric in itself, or one that is neither.
struct MirroredPieces {
    enum class Drawing {
        Equal,         ///< as mirror images
        Kept,          ///< each as in the file: a seam differs too much from its mirror image
        OtherOutline,  ///< each as it is: the segments of the outlines do not correspond in order
        NotFlat,
        NotDrawn,  ///< it should be equal, and could not
    };

    int piece = -1;
    int counterpart = -1;  ///< itself if symmetric in itself; -1: none
    double deviation = 0;  ///< MirrorPieces::deviation, mm
    Drawing drawing = Drawing::OtherOutline;
    std::optional<UnequalPieces> unequal{};  ///< if a seam differs too much
    int lead = -1;                           ///< if drawn equal: the piece whose line is mirrored

    bool isPair() const { return counterpart >= 0 && counterpart != piece; }
    std::vector<int> pieces() const {
        return isPair() ? std::vector{piece, counterpart} : std::vector{piece};
    }
};

/// Facts about the symmetry of a garment.
struct SymmetryFacts {
    /// Every piece once: pairs, then those that are symmetric in themselves, then the others.
    std::vector<MirroredPieces> rows;
    std::vector<int> seams;              ///< seams and free edges without a counterpart
    double lengthChange = 0;             ///< largest, of a seam to its common length, mm
    double exactStrain = 0, strain = 0;  ///< largest of an edge, before and after drawing
    int equal = 0, pairs = 0;            ///< rows drawn equal, of those with a counterpart
};

/// Cost: linear. Pure.
/// @param results   one per piece, or empty  @param symmetry  of this garment
SymmetryFacts symmetryFacts(const Garment& garment, const PieceResults& results,
                            const Symmetry& symmetry);

}  // namespace toile::app
