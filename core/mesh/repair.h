// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Triangles that are to become a piece, in mm, with their indices in the file.
struct MeshPart {
    MeshArrays mesh;
    std::vector<int> sourceVertex;  ///< per vertex: position index in the file, or -1 if new
    std::vector<int> sourceFace;    ///< per triangle: face index in the file
};

/// The corners of all faces, face by face: corner 3 * f + k.
inline std::span<int> cornersOf(Triangles& F) {
    return {F.data(), static_cast<std::size_t>(F.size())};
}

/// Per vertex: 1 if a triangle uses it.
std::vector<char> usedVertices(const Triangles& F, Eigen::Index vertexCount);

/// Removes the faces whose flag is set; the others keep their order. Vertices stay.
/// @return whether there were any
bool eraseFaces(MeshPart& part, const std::vector<char>& erased);

/// Removes vertices that no face uses; the others keep their order. Returns the number removed.
int eraseUnusedVertices(MeshPart& part);

/// Appends a copy of each of these vertices: same position, same source.
void appendCopies(MeshPart& part, const std::vector<int>& originals);

/// The faces at an edge that have the same three vertices as an earlier one there. Each is reported
/// at one edge only, that between its two smallest vertices. Over all edges of a mesh these are the
/// faces that repeat another, in either winding.
std::vector<int> doubledFaces(const Triangles& F, const EdgeTable& table, Eigen::Index edge);

/// Length of the longest side, and whether the height over it is too small for angles: the measure
/// of `checkDisk`, so that triangles that pass here pass there. Scale-free.
struct FaceShape {
    double longest = 0;   ///< mm
    double shortest = 0;  ///< mm
    int longestSide = 0;  ///< from corner k to k + 1; the first of equals
    bool flat = false;
};

FaceShape shapeOf(const MeshArrays& mesh, int face);

/// A connected part, with the earlier indices of its vertices.
struct ConnectedPart {
    MeshPart part;
    std::vector<int> vertex;  ///< per vertex: its index in the mesh that was divided
};

/// Divides a part into those connected by shared vertices, in order of first face. Vertices and
/// faces keep their order; unused vertices are removed, unless the part was connected: then it is
/// returned unchanged. Linear.
std::vector<ConnectedPart> connectedParts(MeshPart part);

struct RepairResult {
    MeshPart part;     ///< may have several components now, or be empty
    Problems repairs;  ///< one note per kind, with count and first place; empty: no change
    std::optional<EdgeTable> validTable{};  ///< the part's edges, if it was a valid surface (see
                                            ///< `isValidSurface`) and is unchanged
};

/// Turns any triangles into an oriented manifold with boundary, and lists every change. In this
/// order, each step relying on those before it:
///   1. faces on a non-finite position or with a repeated corner are left out;
///   2. edges without length are collapsed, which removes needles and joins their neighbours;
///   3. of faces on the same three vertices, in either winding, the first is kept;
///   4. at an edge of more than two faces the pairs that bend least stay joined, see `glue`; the
///      others become border;
///   5. triangles without area are removed: the neighbour at their longest side is divided at the
///      vertex on that side; on the border, where no gap can arise, they are dropped, and their
///      two short sides become the border in the same place;
///   6. windings are flipped by flood fill to agree with the larger part of the area; a one-sided
///      surface is left unchanged, and checkDisk reports it;
///   7. a vertex that joins several fans becomes one vertex per fan; if two edges of the surface
///      still join the same two vertices, one gets a vertex in its middle.
/// Area is kept, except for duplicate faces. A mesh without these faults is returned bit for bit,
/// without notes: strict callers can reject a mesh that has any.
/// A copied vertex keeps its source, a new vertex has source -1; a divided triangle keeps its
/// source in both halves.
/// @param part  mm; indices in range; any number of components
/// Not repaired, reported by checkDisk: one-sided surfaces, and flat triangles whose neighbourhood
/// is as flat within rounding.
/// Cost: n log n in the faces, linear if nothing is repaired; no recursion. Pure, re-entrant; same
/// input, same output.
RepairResult repair(MeshPart part, const std::string& name);

}  // namespace toile
