// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/cut/surface_links.h"

namespace toile {

/// The lines that a mesh has along its edges, and how much each looks like a seam. Where panels
/// were sewn before they became one skin, their borders are still there: straight rows of edges of
/// one length, along which the surface is bent, as panels are smooth within.
struct MeshLines {
    /// From here on a line is taken for a seam, and named as the reason for a cut.
    static constexpr double kLikely = 0.6;

    std::vector<int> lineOf;             ///< per edge
    std::vector<std::vector<int>> ways;  ///< per line: its vertices; a round one repeats its first
    std::vector<double> likeliness;  ///< per line, 0 to below 1; a line of a regular grid has 0.5
    int usual = 0;                   ///< edges that nine lines of ten have at most: the mesh's own
    int sure = -1;                   ///< the line of seams that there are for sure; -1: none
    int firstBorder = -1;            ///< from here on, up to `sure`, lines are borders of the file

    /// How much an edge looks like a part of a seam.
    double at(int edge) const { return likeliness[lineOf[edge]]; }

    /// Makes seams of some edges for sure: of likeliness 1, and of a line of their own, without a
    /// way. @param isSeam  per edge
    void addSure(const std::vector<char>& isSeam);
    bool isSure(int edge) const { return lineOf[edge] == sure; }

    /// Makes lines of edges that are borders in the file: each goes on until three meet, or it
    /// ends. Before `addSure`. @param isBorder  per edge
    void addBorders(const SurfaceLinks& links, const std::vector<char>& isBorder);
    bool isBorder(int edge) const { return isBorderLine(lineOf[edge]); }
    bool isBorderLine(int line) const {
        return firstBorder >= 0 && line >= firstBorder && line != sure;
    }
};

/// Two edges that meet inside the surface belong to one line where each goes on most nearly
/// straight in the other, within acos 0.9, and their lengths differ by less than 12 %. A line is
/// the likelier a seam the more edges it has, next to the usual of this mesh, the evener they are,
/// and the more the surface is curved (angle defect) and bent (dihedral angle) along it, next to
/// the median of the mesh.
/// Cost: linear, and the sorting of three lists. Deterministic. Pure.
MeshLines findMeshLines(const SurfaceLinks& links);

}  // namespace toile
