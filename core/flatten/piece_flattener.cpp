// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/piece_flattener.h"

#include <utility>

#include "core/flatten/isometric/kkt_solver.h"
#include "core/garment/piece.h"

namespace toile {
namespace {

/// Of the positions, on meshes large enough to matter.
constexpr std::size_t kBytesPerTriangle = 25;
/// Of the model that `isometric` keeps of pieces that are not large.
constexpr std::size_t kModelBytesPerTriangle = 1200;

}  // namespace

Result<FlatPiece> PieceFlattener::flatten(const std::shared_ptr<const Piece>& piece,
                                          const FlattenOptions& options, const Progress& progress) {
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
    const bool hasModel = piece.mesh.V.rows() < KktSizes{}.large;
    const std::size_t each = kBytesPerTriangle + (hasModel ? kModelBytesPerTriangle : 0);
    return piece.defect ? 0 : each * static_cast<std::size_t>(piece.mesh.F.rows());
}

std::size_t PieceFlattener::keptBytes() const {
    const std::size_t model = memory_.model ? memory_.model->factor->bytes() : 0;
    const auto bytesOf = [](const std::shared_ptr<const Points2>& points) -> std::size_t {
        return points ? sizeof(double) * static_cast<std::size_t>(points->size()) : 0;
    };
    const bool isApart = memory_.simple != memory_.Q;
    return model + bytesOf(memory_.Q) + (isApart ? bytesOf(memory_.simple) : 0);
}

}  // namespace toile
