// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/flatten.h"

#include <utility>

#include <Eigen/Eigenvalues>

#include "core/base/text.h"
#include "core/flatten/base/flat_notes.h"
#include "core/flatten/conformal/conformal_methods.h"
#include "core/flatten/isometric/isometric.h"
#include "core/flatten/isometric/kkt_solver.h"
#include "core/flatten/reference/reference_methods.h"
#include "core/garment/garment.h"

namespace toile {
namespace {

/// A piece whose height in the garment changes by less than this per unit of flat length is level
/// (a waistband, the top of a cap) and has no reliable "up".
constexpr double kLevelSlope = 0.2;
/// mm: beyond this, squares of areas overflow.
constexpr double kLargestCoordinate = 1e75;
/// Bytes of the positions, on meshes large enough to matter.
constexpr std::size_t kBytesPerTriangle = 25;
/// Bytes of the model that `isometric` keeps for pieces that are not large.
constexpr std::size_t kModelBytesPerTriangle = 1200;

Result<FlatPiece> runMethod(const Piece& piece, const FlattenOptions& options,
                            const OutlineTargets& targets, const PieceClothPointer& cloth,
                            const Progress& progress, FlatteningMemory* memory) {
    switch (options.method) {
        case Method::Isometric:
            return flattenIsometric(piece, options, progress, memory, targets, cloth);
        case Method::Curvature:
            return flattenCurvature(piece, options, progress, targets);
        case Method::Wang2005:
            return flattenWang2005(piece, options, progress, targets);
        case Method::Stretch:
            return flattenStretch(piece, options, progress, targets);
        case Method::Natural:
            return flattenNatural(piece, options, progress);
        case Method::Lscm:
            return flattenLscm(piece, options, progress);
        case Method::Abf:
            return flattenAbf(piece, options, progress);
        case Method::Convex:
            return flattenConvex(piece, options, progress, targets);
    }
    return Error{ErrorCode::NotFinite, subjectOf(piece), "unknown method"};
}

/// The flat direction in which the garment's y rises fastest (least squares over the vertices); for
/// a level piece the direction across its longer axis.
Eigen::Vector2d upDirection(const Points3& V, const Points2& Q) {
    const Eigen::RowVector2d middle = Q.colwise().mean();
    const Points2 centred = Q.rowwise() - middle;
    const Eigen::VectorXd height = V.col(1).array() - V.col(1).mean();
    const Eigen::Matrix2d spread = centred.transpose() * centred;
    const Eigen::Vector2d slope = spread.fullPivLu().solve(centred.transpose() * height);
    if (slope.allFinite() && slope.norm() > kLevelSlope) {
        return slope.normalized();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(spread);
    const Eigen::Vector2d across = axes.eigenvectors().col(0);
    return across.dot(slope) < 0 ? Eigen::Vector2d(-across) : across;
}

/// Turns the piece so that its up direction is +y and its box starts at the origin. A rotation
/// keeps lengths and orientation.
void standUpright(const Points3& V, Points2& Q) {
    const Eigen::Vector2d up = upDirection(V, Q);
    const Eigen::Vector2d right(up.y(), -up.x());
    Eigen::Matrix2d turn;
    turn << right, up;
    Q = (Q * turn).eval();
    Q.rowwise() -= Q.colwise().minCoeff().eval();
}

/// The piece with its holes filled, with sources of its vertices and faces; caps have none.
std::shared_ptr<const Piece> filledPiece(const Piece& piece) {
    auto filled = std::make_shared<Piece>(withHolesFilled(piece));
    filled->file = piece.file;
    if (!piece.sourceFace.empty()) {
        filled->sourceVertex = piece.sourceVertex;
        filled->sourceVertex.resize(static_cast<std::size_t>(filled->mesh.V.rows()), -1);
        filled->sourceFace = piece.sourceFace;
        filled->sourceFace.resize(static_cast<std::size_t>(filled->mesh.F.rows()), -1);
    }
    return filled;
}

/// `flatten`, with the memory of earlier calls, or null.
/// @param memory  `present` is the piece; modified even if an error is returned
Result<FlatPiece> flattenWith(FlatteningMemory* memory, const Piece& piece,
                              const FlattenOptions& options, const OutlineTargets& targets,
                              const PieceClothPointer& cloth, const Progress& progress) {
    if (piece.defect) {
        return *piece.defect;
    }
    if (auto fault = faultOf(piece, targets)) {
        return std::move(*fault);
    }
    if (progress.isCancelled()) {
        return Error{ErrorCode::Cancelled, subjectOf(piece), ""};
    }
    if (const double most = piece.mesh.V.cwiseAbs().maxCoeff(); !(most <= kLargestCoordinate)) {
        return Error{ErrorCode::NotFinite, subjectOf(piece),
                     "coordinates reach " + shortest(most) + " mm"};
    }
    // Holes are filled for the solve and the caps are dropped, so rims follow the cloth around
    // them. Only `isometric`, which moves the interior freely, keeps the rims' lengths too.
    const std::shared_ptr<const Piece> filled = piece.holes.empty() ? nullptr : filledPiece(piece);
    if (memory != nullptr && filled) {
        memory->present = filled;
    }
    const bool keepsRims = filled && options.method == Method::Isometric;
    auto flat = runMethod(filled ? *filled : piece, options, targets, cloth, progress, memory);
    if (flat) {
        flat->Q.conservativeResize(piece.mesh.V.rows(), 2);
    }
    if (flat && keepsRims) {
        if (const auto kept = keepRimLengths(piece, options, *flat, progress, targets, cloth);
            !kept) {
            flat = kept.error();
        }
    }
    if (!flat) {
        Error error = flat.error();
        error.subject = subjectOf(piece);
        return error;
    }
    standUpright(piece.mesh.V, flat->Q);
    if (!flat->Q.allFinite()) {
        return Error{ErrorCode::NotFinite, subjectOf(piece), "flat positions"};
    }
    const auto add = [&flat](std::optional<Error> note) {
        if (note) {
            flat->notes.push_back(std::move(*note));
        }
    };
    flat->crossings = findOutlineCrossings(flat->Q, piece.boundary);
    add(crossingNote(piece, flat->Q, flat->crossings));
    noteFlips(piece, flat->Q, flat->notes);
    if (traits(options.method).keepsLengths) {
        add(shortEdgesNote(piece, flat->Q, targets));
    }
    add(degenerateNote(piece));
    return flat;
}

}  // namespace

Result<FlatPiece> flatten(const Piece& piece, const FlattenOptions& options,
                          const Progress& progress, const OutlineTargets& targets,
                          const PieceClothPointer& cloth) {
    return flattenWith(nullptr, piece, options, targets, cloth, progress);
}

Result<FlatPiece> PieceFlattener::flatten(const std::shared_ptr<const Piece>& piece,
                                          const FlattenOptions& options, const Progress& progress,
                                          const OutlineTargets& targets,
                                          const PieceClothPointer& cloth) {
    FlatteningMemory memory = memory_;
    memory.present = piece;
    auto flat = flattenWith(&memory, *piece, options, targets, cloth, progress);
    memory.present = nullptr;
    if (flat && !progress.isCancelled()) {
        memory_ = std::move(memory);
    }
    return flat;
}

std::size_t PieceFlattener::expectedBytes(const Piece& piece) {
    const bool hasModel = piece.mesh.V.rows() < isometric::KktSizes{}.large;
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
