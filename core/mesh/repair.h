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

struct RepairResult {
    MeshPart part;     ///< may have fallen apart into several components, or be empty
    Problems repairs;  ///< one note per kind, with count and first place; none: nothing was done
    std::optional<EdgeTable> validTable{};  ///< the part's edges, where `isValidSurface` holds for
                                            ///< it as it came; then it is as it was
};

/// Makes an oriented manifold with boundary of any triangles, and lists everything it does. In this
/// order, each step relying on those before it:
///   1. faces on a non-finite position or with a repeated corner are left out;
///   2. edges without length are collapsed, so that needles vanish and their neighbours join;
///   3. of faces on the same three vertices, in either winding, the first is kept;
///   4. at an edge of more than two faces the pairs that continue each other best stay joined, see
///      `glue`; the others become border;
///   5. triangles without area give the vertex on their longest side to the neighbour there, which
///      is divided by it; on the border, where no neighbour can be left with a gap, they are
///      dropped, and their two short sides become the border in the same place;
///   6. windings are turned by flood fill to agree with the larger part of the area; a one-sided
///      surface is left as it is, for checkDisk to name;
///   7. a vertex that joins several fans becomes one vertex per fan; where two edges of the surface
///      still join the same two vertices, one gets a vertex in its middle.
/// Area is kept, but for duplicate faces. A mesh without these faults comes back bit for bit, and
/// without notes: to be strict, refuse what has any.
/// A copied vertex keeps its source, an added one has source -1; a divided triangle keeps its
/// source in both halves.
/// @param part  mm; indices in range; any number of components
/// Left over, for checkDisk to name: one-sided surfaces, and flat triangles whose neighbourhood is
/// as flat within rounding.
/// Cost: n log n, in the faces, linear where nothing is to do; no recursion. Pure, re-entrant; same
/// input, same output.
RepairResult repair(MeshPart part, const std::string& name);

}  // namespace toile
