// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "core/base/progress.h"
#include "core/cut/surface_paths.h"
#include "core/cut/user_cuts.h"
#include "core/garment/piece.h"
#include "core/io/soup.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// Lines of a mesh along its edges, and how likely each is a seam. If panels were sewn before they
/// became one skin, their borders remain: straight rows of edges of equal length, along which the
/// surface is bent, while panels are smooth inside.
struct MeshLines {
    /// From this likeliness on a line is taken for a seam, and named as the reason for a cut.
    static constexpr double kLikely = 0.6;

    std::vector<int> lineOf;             ///< per edge
    std::vector<std::vector<int>> ways;  ///< per line: its vertices; a closed one repeats its first
    std::vector<double> likeliness;  ///< per line, 0 to below 1; 0.5 for a line of a regular grid
    int usual = 0;                   ///< 90 % of lines have at most this many edges
    int sure = -1;                   ///< the line of certain seams; -1: none
    int firstBorder = -1;            ///< lines from here up to `sure` are borders of the file

    /// How likely an edge is part of a seam.
    double at(int edge) const { return likeliness[lineOf[edge]]; }

    /// Marks edges as certain seams: likeliness 1, in a separate line without a way. @param
    /// isSeam  per edge
    void addSure(const std::vector<char>& isSeam);
    bool isSure(int edge) const { return lineOf[edge] == sure; }

    /// Makes lines of edges that are borders in the file: each ends where three meet, or at its
    /// end. Call before `addSure`. @param isBorder  per edge
    void addBorders(const SurfaceLinks& links, const std::vector<char>& isBorder);
    bool isBorder(int edge) const { return isBorderLine(lineOf[edge]); }
    bool isBorderLine(int line) const {
        return firstBorder >= 0 && line >= firstBorder && line != sure;
    }
};

/// Two edges that meet inside the surface belong to one line if each is the straightest
/// continuation of the other, within acos 0.9, and their lengths differ by less than 12 %. The
/// likeliness grows with the number of edges, relative to the usual of this mesh, with their
/// evenness, and with the curvature of the surface (angle defect) and its bend (dihedral angle)
/// along the line, relative to the mesh's median.
/// Cost: linear, plus the sorting of three lists. Deterministic. Pure.
MeshLines findMeshLines(const SurfaceLinks& links);

}  // namespace toile

namespace toile::tailor {

/// A surface with marked edges.
struct MarkedMesh {
    MeshArrays mesh;
    EdgeTable table;
    std::vector<std::vector<int>>
        ways;  ///< the marked lines, as vertices; neighbours share an edge

    /// Per edge: whether it is marked.
    std::vector<char> marks() const;
    /// The vertices on the lines.
    std::set<int> vertices() const;
};

/// The same surface with cuts as edges: split like `cutPieces` splits it, and closed again. Source
/// vertices keep their numbers. Cuts that cannot be made are left out, and so are parts along a rim
/// or another cut.
/// @param mesh  oriented, manifold
/// Cost: that of tracing the cuts and of `cutAlong`. After a cancel the result is invalid.
/// Deterministic. Pure.
MarkedMesh markedMesh(const MeshArrays& mesh, const EdgeTable& table,
                      const std::vector<UserCut>& cuts, const Progress& progress);

}  // namespace toile::tailor

namespace toile {

/// Per edge of a piece: whether its two triangles have different materials, groups or objects in
/// the file, or different UV points. The author of the mesh intended such lines as borders.
/// @param soup  the polygons that the piece was divided from
/// @return empty if there are no borders, or too many to be seams: a UV map of single triangles
/// Cost: linear. Pure.
std::vector<char> fileBorders(const Piece& piece, const PolygonSoup& soup);

}  // namespace toile
