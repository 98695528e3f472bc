// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/piece.h"

#include "core/mesh/disk_check.h"
#include "core/mesh/tri_mesh.h"

namespace toile {

Piece makePiece(std::string name, MeshArrays mesh) {
    Piece piece;
    piece.name = std::move(name);
    piece.mesh = std::move(mesh);
    DiskCheck check = checkDisk(piece.mesh, piece.name);
    piece.table = std::move(check.table);
    piece.boundary = std::move(check.boundary);
    piece.defect = std::move(check.defect);
    if (!piece.defect) {
        piece.halfedges = buildTriMesh(piece.mesh);
        if (!piece.halfedges) {
            piece.boundary.clear();
            piece.defect = Error{ErrorCode::NonManifoldVertex, piece.name,
                                 "the half-edge structure refused a face"};
        }
    }
    return piece;
}

}  // namespace toile
