// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Triangles on their way to become a piece, in mm, with the way back to the file.
struct MeshPart {
    MeshArrays mesh;
    std::vector<int> sourceVertex;  ///< per vertex: position index in the file, or -1 if made here
    std::vector<int> sourceFace;    ///< per triangle: face index in the file
};

/// The corners of all faces, face by face: corner 3 * f + k.
inline std::span<int> cornersOf(Triangles& F) {
    return {F.data(), static_cast<std::size_t>(F.size())};
}

/// Per vertex: 1 where a triangle uses it.
std::vector<char> usedVertices(const Triangles& F, Eigen::Index vertexCount);

/// Takes out the faces whose flag is set; the others keep their order. Vertices stay.
/// @return whether there were any
bool eraseFaces(MeshPart& part, const std::vector<char>& erased);

/// Takes out vertices that no face uses; the others keep their order. Returns how many went.
int eraseUnusedVertices(MeshPart& part);

/// Appends a copy of each of these vertices: same position, same source.
void appendCopies(MeshPart& part, const std::vector<int>& originals);

/// The faces at an edge that lie on the three vertices of another one before them there. Each is
/// named at one of its edges: that between its two least vertices. Of all edges of a mesh these are
/// the faces that repeat another, in whatever winding.
std::vector<int> doubledFaces(const Triangles& F, const EdgeTable& table, Eigen::Index edge);

/// Length of the longest side and whether the triangle's height over it is too small for angles:
/// the measure of `checkDisk`, so that what passes here passes there. Scale-free.
struct FaceShape {
    double longest = 0;   ///< mm
    double shortest = 0;  ///< mm
    int longestSide = 0;  ///< from corner k to k + 1; the first of equals
    bool flat = false;
};

FaceShape shapeOf(const MeshArrays& mesh, int face);

/// A part that hangs together, and where its vertices were before.
struct ConnectedPart {
    MeshPart part;
    std::vector<int> vertex;  ///< per vertex: its index in the mesh that was taken apart
};

/// Takes a part to pieces where it does not hang together by shared vertices, in order of first
/// face. Vertices and faces keep their order; vertices without a face go, unless it was one piece
/// all along: then it comes back untouched. Linear.
std::vector<ConnectedPart> connectedParts(MeshPart part);

}  // namespace toile
