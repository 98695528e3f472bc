// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/error.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"
#include "core/mesh/repair.h"

namespace toile {

/// Counts the repairs, so that a thousand faults of a kind give one note with the count and the
/// first place.
class RepairNotes {
public:
    /// Counts one more repair: `noun` is the repaired element ("face"), `what` the change, both
    /// literals; `what` is translated (`translatable`).
    void add(ErrorCode code, std::string_view noun, const char* what,
             const Eigen::RowVector3d& place);

    bool empty() const { return entries_.empty(); }

    /// One note per code, in the order of the codes: "3 faces turned, the first at 1.0, 2.0, 0.0
    /// mm"; differences within a code are separated by a semicolon.
    Problems problems(const std::string& piece) const;

private:
    struct Entry {
        ErrorCode code;
        std::string_view noun;
        const char* what;
        Eigen::RowVector3d first;
        int count;
    };

    std::vector<Entry> entries_;
};

/// Which sides of triangles are joined. Two sides may have the same ends and not be joined: during
/// the repair the gluing defines the surface, and vertices are adapted last.
struct Gluing {
    std::vector<int> twin;          ///< per side: the side it is joined to, or -1 on the border
    std::vector<char> cutAtVertex;  ///< per vertex: ends an edge that was cut apart
    bool mayDouble = false;         ///< two edges of the surface may have the same two ends

    /// Joins two sides; if one is -1, the other becomes border.
    void join(int a, int b) {
        if (a >= 0) {
            twin[a] = b;
        }
        if (b >= 0) {
            twin[b] = a;
        }
    }
};

/// The orientation of the faces in the connected parts of a gluing.
struct Sides {
    std::vector<int> component;  ///< per face, numbered by first face
    std::vector<char> turn;      ///< per face: to be flipped to agree with most of the area
    std::vector<char> oneSided;  ///< per component: cannot be oriented; nothing is flipped
    bool anyTurn = false;
};

/// Flood fill over joined sides. If both orientations have the same area, the first face is kept.
Sides findSides(const MeshArrays& mesh, const std::vector<int>& twin);

/// Joins the two faces of every edge that has two. If more meet, joins pairs from the best on: a
/// pair that bends less is better. A pair that edges of two faces join nowhere else counts as bent
/// by a right angle more, and so does one whose windings disagree. No pair is joined that would
/// make an orientable surface one-sided, apart from such edges. Faces without a partner become
/// border.
/// @param table  the edges of `mesh`
Gluing glue(const MeshArrays& mesh, const EdgeTable& table, RepairNotes& notes);

/// Flips the faces whose winding disagrees with most of the area of their component.
void turnWindings(MeshPart& part, Gluing& gluing, RepairNotes& notes);

/// The repairs that need no neighbourhood: removing faces, merging vertices.

/// Removes faces on non-finite positions and faces that repeat a corner.
void dropUnusableFaces(MeshPart& part, RepairNotes& notes);

/// Merges the ends of every edge without length into the vertex of smallest index, and removes the
/// faces that become an edge. Without length: at most kDegenerateHeight of the triangle's longest
/// side, where no height could be larger; or a hundred times that if the triangle has no height.
void collapseNeedles(MeshPart& part, RepairNotes& notes);

/// Keeps the first of faces on the same three vertices, in either winding. Returns the remaining
/// edges.
EdgeTable dropDuplicates(MeshPart& part, RepairNotes& notes);

/// Gives every fan of joined faces a vertex of its own: the fan with the smallest corner keeps the
/// vertex, the others get copies, appended in order of their smallest corners. Afterwards the mesh
/// represents the gluing, except for the edges that `splitDoubledEdges` handles.
void separateFans(MeshPart& part, const Gluing& gluing, RepairNotes& notes);

/// If a surface returns to an edge's two vertices along another edge (a spiral around both, or a
/// flip that met an existing edge), indices alone would join the two. All but the first such edge
/// get a vertex in the middle, with source -1, and their faces are halved.
/// @return whether there were any
bool splitDoubledEdges(MeshPart& part, Gluing& gluing, RepairNotes& notes);

/// Removes triangles without area from a glued surface without opening a hole or T-junction. The
/// third vertex c of such a triangle lies on its longest side ab. If a face abd is joined there,
/// the two become acd and cbd (an edge flip): abd is divided at a point of its own border, and its
/// area is kept. On the border the triangle is dropped: ac and cb replace ab as border. Components
/// that are flat throughout are dropped.
///
/// The flat triangle with the longest side is removed first. If its neighbour is not flat, one flat
/// triangle less remains; if it is flat with the same longest side, the two new ones are shorter.
/// So this terminates; only rounding could make it cycle, and a budget stops that.
/// @param gluing  is updated; corners keep their vertices, see separateFans
/// @return whether anything changed; remaining flat triangles need a collapse or another round
bool removeFlats(MeshPart& part, Gluing& gluing, RepairNotes& notes);

}  // namespace toile
