// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/tailor/body_ways.h"
#include "core/tailor/mesh_lines.h"
#include "core/tailor/seam_pull.h"

namespace toile {

/// Kinds of lines along which tailors cut.
enum class TailorLine {
    Side,
    Underarm,
    Armhole,
    Shoulder,
    Centre,
    Inseam,
    Waist,
    Style,
    Band,     ///< a style line all round a neck, a cuff, a waist, near its rim
    Ridge,    ///< an edge of the form, as of a box's lid
    Opening,  ///< the shortest cut that lets a closed form lie flat
    Dart,
};

/// One line along edges, from its first vertex to its last; a closed one ends at its first vertex.
struct TailorSeam {
    TailorLine line;
    int side = 0;           ///< of the mirror plane: -1, 1; 0 in the middle
    std::vector<int> way;   ///< vertices; neighbours share an edge
    double likeliness = 0;  ///< mean of `MeshLines` along it, by length
};

/// Proposes the lines of a top, of trousers or of a skirt: where front meets back along trunk,
/// sleeves and legs, around the arms, along the shoulders. First by the form alone; then each is
/// pulled to near lines of the mesh that look like seams.
/// @param cuts  ways that are cut in any case, certain seams of `lines`: lines run to them; parts
///              along them are left out, so that a line may be split in several stretches
/// Cost: some dozens of searches, O(#E log #E) each. Deterministic. Pure.
std::vector<TailorSeam> tailorSeams(const BodyWays& ways, const MeshLines& lines,
                                    const std::vector<std::vector<int>>& cuts = {},
                                    const Progress& progress = {});

}  // namespace toile

namespace toile::tailor {

/// Lines of one side of a top, each a path of vertices.
struct TopSide {
    std::vector<int> under;    ///< from the cuff past the armpit to the hem
    std::vector<int> ridge;    ///< from the neck to the cuff
    bool hasSleeve = true;     ///< false: the cuff is the armhole
    std::size_t armpit = 0;    ///< index into `under`; 0 without a sleeve
    std::size_t shoulder = 0;  ///< index into `ridge`; its end without a sleeve
    std::vector<int> armhole;  ///< closed: armpit, front, shoulder, back
};

/// @param side  -1 or 1: of the mirror plane
std::optional<TopSide> topSide(const BodyWays& ways, const SeamPull& pull, int side);

}  // namespace toile::tailor
