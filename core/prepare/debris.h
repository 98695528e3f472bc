// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/mesh/mesh_arrays.h"

namespace toile {

/// What lies about a garment and is none of it.
struct Debris {
    std::vector<int> triangles;  ///< ascending
    int fragments = 0;
    double area = 0;  ///< mm2
};

/// Finds the fragments that no pattern piece could be: parts that hang together by edges, with
/// less than a thousandth of the area of the largest and less than a fifth of its size. What a
/// person may want stays: a belt or a cuff is larger, belt loops and buttons come as several of a
/// kind, and where fragments are a good part of all cloth, they are cloth in pieces and no debris.
/// Rather a fragment too many than a piece lost: that one can be left out by hand.
/// How far a fragment lies off does not matter: pieces of an exploded view lie far, too.
/// @param mesh  mm; corners that lie on each other are welded
/// Cost: linear, but for sorting the fragments. Pure.
Debris findDebris(const MeshArrays& mesh);

}  // namespace toile
