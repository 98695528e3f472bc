// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/garment/piece.h"

#include <utility>

#include "core/cut/fill_holes.h"
#include "core/mesh/disk_check.h"

namespace toile {
namespace {

/// If a piece has several loops, all but the outline may be holes in the cloth. The check of the
/// piece with these filled then replaces the first check, except for the edges.
void acceptHoles(Piece& piece, DiskCheck& check) {
    const SurfaceLinks links(piece.mesh, check.table);
    SortedLoops loops = sortLoops(links);
    if (loops.openings.size() != 1) {
        return;
    }
    DiskCheck filled = checkDisk(fillHoles(piece.mesh, loops.holes), piece.name);
    check.boundary = std::move(filled.boundary);
    check.defect = std::move(filled.defect);
    if (!check.defect) {
        for (RimLoop& hole : loops.holes) {
            piece.holes.push_back(std::move(hole.vertices));
        }
    }
}

}  // namespace

Piece makePiece(std::string name, MeshArrays mesh, std::optional<EdgeTable> validTable) {
    Piece piece;
    piece.name = std::move(name);
    piece.mesh = std::move(mesh);
    DiskCheck check = checkDisk(piece.mesh, piece.name, std::move(validTable));
    if (check.defect && check.defect->code == ErrorCode::SeveralLoops) {
        acceptHoles(piece, check);
    }
    piece.table = std::move(check.table);
    piece.boundary = std::move(check.boundary);
    piece.defect = std::move(check.defect);
    return piece;
}

std::vector<double> loopLengths(const Piece& piece) {
    std::vector<double> lengths;
    for (const RimLoop& loop : rimsOf(piece.mesh, piece.table)) {
        lengths.push_back(loop.perimeter);
    }
    return lengths;
}

Piece withHolesFilled(const Piece& piece) {
    std::vector<RimLoop> loops;
    for (const auto& hole : piece.holes) {
        RimLoop loop{hole, 0};
        for (std::size_t i = 0; i < hole.size(); ++i) {
            const int next = hole[i + 1 < hole.size() ? i + 1 : 0];
            loop.perimeter += (piece.mesh.V.row(next) - piece.mesh.V.row(hole[i])).norm();
        }
        loops.push_back(std::move(loop));
    }
    Piece filled = makePiece(piece.name, fillHoles(piece.mesh, loops));
    filled.id = piece.id;
    return filled;
}

}  // namespace toile
