// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/conformal_interior.h"

#include <limits>
#include <utility>

#include "core/garment/piece.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/intrinsic_delaunay.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

int flippedIn(const Points2& Q, const Piece& piece) {
    return flippedTriangles(triangleAreas2d(Q, piece.mesh.F));
}

}  // namespace

Result<ConformalInterior> ConformalInterior::make(const Piece& piece, const Progress& progress) {
    ConformalInterior interior(piece);
    auto system =
        InteriorSystem::make({piece.table.edges, cotangentWeights(piece.mesh, piece.table)},
                             static_cast<int>(piece.mesh.V.rows()), piece.boundary, progress);
    if (!system && system.error().code == ErrorCode::FactorisationFailed) {
        auto other = interior.withDelaunayWeights(progress);
        if (!other && other.error().code == ErrorCode::FactorisationFailed) {
            return system.error();
        }
        return other;
    }
    if (!system) {
        return system.error();
    }
    interior.system_ = std::move(*system);
    return interior;
}

/// Errors also where no edge has to be turned: the weights are the mesh's own then.
Result<ConformalInterior> ConformalInterior::withDelaunayWeights(const Progress& progress) const {
    auto delaunay = intrinsicDelaunay(piece_->mesh, piece_->table, progress);
    if (!delaunay) {
        return delaunay.error();
    }
    if (delaunay->flips == 0) {
        return Error{ErrorCode::FactorisationFailed, "", "the mesh is Delaunay"};
    }
    auto system =
        InteriorSystem::make(std::move(delaunay->graph), static_cast<int>(piece_->mesh.V.rows()),
                             piece_->boundary, progress);
    if (!system) {
        return system.error();
    }
    ConformalInterior interior(*piece_);
    interior.system_ = std::move(*system);
    interior.delaunayFlips_ = delaunay->flips;
    return interior;
}

Result<Eigen::MatrixXd> ConformalInterior::solve(const Eigen::MatrixXd& b,
                                                 const Progress& progress) {
    auto values = system_.solve(b);
    if (values || values.error().code != ErrorCode::NotFinite || delaunayFlips_ > 0) {
        return values;
    }
    auto other = withDelaunayWeights(progress);
    if (!other) {
        return other.error().code == ErrorCode::Cancelled ? other.error() : values.error();
    }
    *this = std::move(*other);
    return system_.solve(b);
}

Result<Points2> ConformalInterior::place(const Points2& outline, const Progress& progress) {
    auto extended = system_.extend(outline);
    if (!extended && extended.error().code != ErrorCode::NotFinite) {
        return extended.error();
    }
    Result<Points2> points =
        extended ? Result<Points2>(Points2(std::move(*extended))) : extended.error();
    const int flipped = points ? flippedIn(*points, *piece_) : std::numeric_limits<int>::max();
    if (flipped == 0 || delaunayFlips_ > 0) {
        return points;
    }
    auto other = withDelaunayWeights(progress);
    if (!other) {
        return other.error().code == ErrorCode::Cancelled ? other.error() : points;
    }
    auto better = other->system_.extend(outline);
    if (better && flippedIn(*better, *piece_) < flipped) {
        *this = std::move(*other);
        return Points2(std::move(*better));
    }
    return points;
}

}  // namespace toile
