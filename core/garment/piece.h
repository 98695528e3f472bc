// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/garment/lineage.h"
#include "core/mesh/edge_table.h"
#include "core/mesh/mesh_arrays.h"

namespace toile {

/// A part of the garment that is cut from one piece of cloth. Immutable after construction.
struct Piece {
    std::string name;                 ///< unique within the garment
    PieceId id;                       ///< unique too, and stable in its next version
    Lineage lineage;                  ///< its origin in the division
    std::vector<EdgeOrigin> origins;  ///< of its rims' edges, sorted by tail
    int file = 0;                     ///< index into Garment::files
    MeshArrays mesh;                  ///< millimetres, y up
    std::vector<int> sourceVertex;    ///< per vertex: position index in the file's soup, or -1
    std::vector<int> sourceFace;      ///< per triangle: face index in the file's soup
    EdgeTable table;                  ///< edges, and the three of each triangle

    /// The reference panel: the designer's own, if the file's UV map contains it: #V x 2, mm, for
    /// comparison. May be mirrored.
    std::optional<Points2> reference;

    /// The following fields are only set if the piece is a disk except for holes (defect is empty).
    std::vector<int> boundary;  ///< the outline, surface on its left; starts at the lowest index
    std::vector<std::vector<int>> holes;  ///< loops inside the outline that stay open, surface on
                                          ///< their left
    std::optional<Error> defect;          ///< why the piece cannot be flattened
};

inline Subject subjectOf(const Piece& piece) {
    return Subject::piece(piece.name, piece.id);
}

/// Updates the defect's subject after a change of the piece's name or id.
inline void nameDefect(Piece& piece) {
    if (piece.defect) {
        piece.defect->subject = subjectOf(piece);
    }
}

/// Checks the mesh and stores a defect if there is one. The mapping back to a file and the id are
/// left empty. Loops that are holes in the cloth (`sortLoops`) are no defect.
/// @param mesh        one connected component, mm
/// @param validTable  its edges, if it is known to be a valid surface (`isValidSurface`): skips
///                    checks that were made before
/// Cost: linear. Pure.
Piece makePiece(std::string name, MeshArrays mesh,
                std::optional<EdgeTable> validTable = std::nullopt);

/// Lengths of all boundary loops, mm; on a non-manifold mesh, of those that can be followed.
std::vector<double> loopLengths(const Piece& piece);

/// The piece with its holes closed by caps, for a solver that needs a disk: the piece's vertices
/// and faces come first, with the same indices. Precondition: no defect. Cost: linear.
Piece withHolesFilled(const Piece& piece);

}  // namespace toile
