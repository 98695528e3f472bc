// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/garment/garment.h"

namespace toile {

/// Indices of the vertices and texture vertices of a garment in its OBJ, counted from 1.
struct ObjIndices {
    std::vector<std::string> group;  ///< per piece: its name for a `g` line, unique
    std::vector<int> firstVertex;    ///< per file: index of its first input vertex
    std::vector<int> firstUv;        ///< per piece: index of its first vt; 0 if it has none
    std::vector<std::vector<int>> addedVertex;  ///< per piece, per vertex: index of its own `v`
                                                ///< line, 0 if the input has it; may be empty
};

/// Numbers of input faces that are written differently.
struct FaceChanges {
    int divided = 0;  ///< as the triangles used
    int turned = 0;   ///< with the opposite winding
};

/// The group of faces that are in no piece because they could not be used.
inline constexpr const char* kUnassignedGroup = "unassigned";

/// Appends the `g` and `f` lines of one file, in its face order. A polygon is kept whole while its
/// corners still represent it. A face that cleaning divided (over pieces, or with added vertices)
/// is written as its triangles, one that repair flipped is written turned, and triangles without a
/// face follow at the end. Corners take their vt from the piece that contains the face. Cost:
/// linear in triangles; quadratic in the corners of one polygon; one with more than 2000 is written
/// as its triangles.
FaceChanges appendFaces(std::string& out, const Garment& garment, int file,
                        const ObjIndices& indices);

}  // namespace toile
