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

/// Counts what a repair does, so that a thousand faults of a kind give one note with the count and
/// the first place.
class RepairNotes {
public:
    /// One more repair: `noun` is what it befell ("face"), `what` what became of it, both literals;
    /// `what` is one for the translations (`translatable`).
    void add(ErrorCode code, std::string_view noun, const char* what,
             const Eigen::RowVector3d& place);

    bool empty() const { return entries_.empty(); }

    /// One note per code, in the order of the codes: "3 faces turned, the first at 1.0, 2.0, 0.0
    /// mm"; what differs within a code is parted by a semicolon.
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

/// Which sides of triangles are joined. Two sides may have the same ends and not be joined: while a
/// mesh is repaired, the gluing says what the surface is, and vertices follow it at last.
struct Gluing {
    std::vector<int> twin;          ///< per side: the side it is joined to, or -1 on the border
    std::vector<char> cutAtVertex;  ///< per vertex: ends an edge that was cut apart
    bool mayDouble = false;         ///< two edges of the surface may have the same two ends

    /// Joins two sides; where one is none, the other becomes border.
    void join(int a, int b) {
        if (a >= 0) {
            twin[a] = b;
        }
        if (b >= 0) {
            twin[b] = a;
        }
    }
};

/// How the faces lie in the connected parts of a gluing.
struct Sides {
    std::vector<int> component;  ///< per face, numbered by first face
    std::vector<char> turn;      ///< per face: to be turned to agree with most of the area
    std::vector<char> oneSided;  ///< per component: no turning can make it agree; nothing turns
    bool anyTurn = false;
};

/// Flood fill over joined sides. Where both ways have the same area, the first face stays.
Sides findSides(const MeshArrays& mesh, const std::vector<int>& twin);

/// Joins the two faces of every edge that has two. Where more meet, joins pairs from the best on:
/// the less a pair bends, the better. A pair that is joined nowhere else, by edges of two faces,
/// counts as bent by a right angle more, and so does one whose windings disagree. No pair is joined
/// that would make a surface one-sided that is not, apart from such edges. What finds no partner
/// becomes border.
/// @param table  the edges of `mesh`
Gluing glue(const MeshArrays& mesh, const EdgeTable& table, RepairNotes& notes);

/// Turns the faces that look away from most of their component.
void turnWindings(MeshPart& part, Gluing& gluing, RepairNotes& notes);

/// The repairs that need no neighbourhood: faces taken out, vertices made one.

/// Takes out faces on non-finite positions and faces that repeat a corner.
void dropUnusableFaces(MeshPart& part, RepairNotes& notes);

/// Makes the ends of every edge without length one vertex, the one of least index, and takes out
/// the faces that shrink to an edge by it. Without length: at most kDegenerateHeight of the
/// triangle's longest side, where no height could be larger; or a hundred times that where the
/// triangle has no height.
void collapseNeedles(MeshPart& part, RepairNotes& notes);

/// Of faces on the same three vertices, in whatever winding, keeps the first. Returns the edges of
/// what is left.
EdgeTable dropDuplicates(MeshPart& part, RepairNotes& notes);

/// Gives every fan of joined faces a vertex of its own: the fan with the least corner keeps the
/// vertex, the others get copies, appended in order of their least corners. After this the mesh
/// itself says what the gluing said, but for what `splitDoubledEdges` does.
void separateFans(MeshPart& part, const Gluing& gluing, RepairNotes& notes);

/// Where a surface comes back to an edge's two vertices along another edge (a spiral around both,
/// or a flip that met an edge already there), indices alone would join the two. All but the first
/// such edge get a vertex in the middle, with source -1, and their faces are halved.
/// @return whether there were any
bool splitDoubledEdges(MeshPart& part, Gluing& gluing, RepairNotes& notes);

/// Takes triangles without area out of a glued surface, so that neither hole nor T-junction opens.
/// The third vertex c of such a triangle lies on its longest side ab. Where a face abd is joined
/// there, the two become acd and cbd (an edge flip): abd is divided at a point of its own border,
/// and its area stays. On the border the triangle is dropped: ac and cb become border where ab was.
/// Components that are flat throughout are dropped.
///
/// The flat triangle with the longest side goes first. Its neighbour then is either no flat
/// triangle, and one flat triangle is gone; or it is flat with the same longest side, and the two
/// new ones are shorter. So this ends; only rounding could make it circle, and a budget stops that.
/// @param gluing  follows the changes; corners keep their vertices, see separateFans
/// @return whether anything changed; what is flat still, needs a collapse or another round
bool removeFlats(MeshPart& part, Gluing& gluing, RepairNotes& notes);

}  // namespace toile
