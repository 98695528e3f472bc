// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/piece_flattener.h"

#include <utility>

#include "core/flatten/flatten_with.h"
#include "core/flatten/interior.h"
#include "core/garment/piece.h"

namespace toile {
namespace {

/// Of the factor, and of the positions, on meshes large enough to matter.
constexpr std::size_t kBytesPerTriangle = 250;

}  // namespace

Result<FlatPiece> PieceFlattener::flatten(const std::shared_ptr<const Piece>& piece,
                                          const FlattenOptions& options, const Progress& progress) {
    if (piece->mesh.F.rows() > kMostTriangles) {
        memory_ = {};
        return toile::flatten(*piece, options, progress);
    }
    FlatteningMemory memory = memory_;
    memory.present = piece;
    auto flat = flattenWith(&memory, *piece, options, progress);
    memory.present = nullptr;
    if (flat && !progress.isCancelled()) {
        memory_ = std::move(memory);
    }
    return flat;
}

std::size_t PieceFlattener::expectedBytes(const Piece& piece) {
    const bool isKept = !piece.defect && piece.mesh.F.rows() <= kMostTriangles;
    return isKept ? kBytesPerTriangle * static_cast<std::size_t>(piece.mesh.F.rows()) : 0;
}

std::size_t PieceFlattener::keptBytes() const {
    const std::size_t factor = memory_.interior ? memory_.interior->factorBytes() : 0;
    const std::size_t points =
        memory_.Q ? sizeof(double) * static_cast<std::size_t>(memory_.Q->size()) : 0;
    return factor + points;
}

}  // namespace toile
