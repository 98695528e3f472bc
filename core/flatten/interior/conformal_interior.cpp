// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/flatten/interior/conformal_interior.h"

#include <utility>

#include "core/flatten/interior/delaunay_around.h"
#include "core/garment/piece.h"
#include "core/mesh/cotangents.h"
#include "core/mesh/intrinsic_delaunay.h"
#include "core/quality/measures.h"

namespace toile {
namespace {

/// Rings of triangles about flipped ones that get other weights too. Three clear fewer pieces of
/// flips, one or none leaves more of them.
constexpr int kRings = 2;

/// Those that `flippedTriangles` (quality/measures.h) counts.
std::vector<int> flippedIn(const Points2& Q, const Piece& piece) {
    const Eigen::VectorXd areas = triangleAreas2d(Q, piece.mesh.F);
    std::vector<int> flipped;
    for (int f = 0; f < areas.size(); ++f) {
        if (areas[f] <= 0) {
            flipped.push_back(f);
        }
    }
    return flipped;
}

/// True where other weights may do better.
bool isOfTheWeights(const Error& error) {
    return error.code == ErrorCode::NotFinite || error.code == ErrorCode::FactorisationFailed;
}

}  // namespace

Result<ConformalInterior> ConformalInterior::make(const Piece& piece, const Progress& progress) {
    ConformalInterior interior(piece);
    auto system =
        InteriorSystem::make({piece.table.edges, cotangentWeights(piece.mesh, piece.table)},
                             piece.mesh.V, piece.boundary, progress);
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

Result<ConformalInterior> ConformalInterior::withOther(Result<InteriorSystem> system,
                                                       int flips) const {
    if (!system) {
        return system.error();
    }
    ConformalInterior interior(*piece_);
    interior.system_ = std::move(*system);
    interior.delaunayFlips_ = flips;
    return interior;
}

/// Errors also where no edge has to be turned: the weights are the mesh's own then.
Result<ConformalInterior> ConformalInterior::withDelaunayWeights(const Progress& progress) const {
    auto delaunay = intrinsicDelaunay(piece_->mesh, piece_->table, progress);
    if (!delaunay) {
        return delaunay.error();
    }
    if (delaunay->flips == 0) {
        return Error{ErrorCode::FactorisationFailed, {}, "the mesh is Delaunay"};
    }
    auto system = InteriorSystem::make(std::move(delaunay->graph), piece_->mesh.V, piece_->boundary,
                                       progress);
    return withOther(std::move(system), delaunay->flips);
}

/// Errors also where no edge has to be turned.
Result<ConformalInterior> ConformalInterior::withDelaunayWeightsAround(
    const std::vector<int>& faces, const Progress& progress) const {
    auto delaunay = delaunayAround(piece_->mesh, piece_->table, system_.graph().weights, faces,
                                   kRings, progress);
    if (!delaunay) {
        return delaunay.error();
    }
    if (delaunay->flips == 0) {
        return Error{ErrorCode::FactorisationFailed, {}, "the triangles are Delaunay"};
    }
    auto system = InteriorSystem::make(std::move(delaunay->graph), piece_->mesh.V, piece_->boundary,
                                       progress);
    return withOther(std::move(system), delaunay->flips);
}

Result<Eigen::MatrixXd> ConformalInterior::solve(const Eigen::MatrixXd& b,
                                                 const Progress& progress) {
    auto values = system_.solve(b);
    if (values || !isOfTheWeights(values.error()) || delaunayFlips_ > 0) {
        return values;
    }
    auto other = withDelaunayWeights(progress);
    if (!other) {
        return isOfTheWeights(other.error()) ? values.error() : other.error();
    }
    *this = std::move(*other);
    return system_.solve(b);
}

Result<Points2> ConformalInterior::place(const Points2& outline, const Progress& progress) {
    const auto extended = system_.extend(outline);
    if (delaunayFlips_ > 0 || (!extended && !isOfTheWeights(extended.error()))) {
        return extended ? Result<Points2>(Points2(*extended)) : extended.error();
    }
    std::vector<int> flipped;
    if (extended) {
        flipped = flippedIn(Points2(*extended), *piece_);
        if (flipped.empty()) {
            return Points2(*extended);
        }
    }
    auto other =
        extended ? withDelaunayWeightsAround(flipped, progress) : withDelaunayWeights(progress);
    const bool isCancelled = !other && other.error().code == ErrorCode::Cancelled;
    if (isCancelled) {
        return other.error();
    }
    if (other) {
        const auto better = other->system_.extend(outline);
        if (better && (!extended || flippedIn(Points2(*better), *piece_).size() < flipped.size())) {
            *this = std::move(*other);
            return Points2(*better);
        }
    }
    return extended ? Result<Points2>(Points2(*extended)) : extended.error();
}

}  // namespace toile
