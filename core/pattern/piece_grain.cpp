// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/piece_grain.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "core/base/units.h"
#include "core/pattern/half_pattern.h"
#include "core/pattern/mirrored_edit.h"
#include "core/quality/measures.h"
#include "core/quality/metric_tensor.h"

namespace toile {
namespace {

constexpr double kLongest = 300;      // mm
constexpr double kShortestGrain = 5;  // mm: a shorter line is useless
constexpr double kShare = 0.8;        // part of the free box that is drawn
constexpr double kSlender = 10;       // ratio of length to width: room for the arrow head
constexpr double kHead = 6;           // mm
constexpr double kHeadShare = 0.15;   // of the line, at most
constexpr double kHeadAngle = 0.35;   // radians to either side

}  // namespace

std::optional<Chord> grainLine(const FreeCloth& cloth, double angle) {
    if (!std::isfinite(angle)) {
        return std::nullopt;
    }
    const PoleSearch search{.tolerance = 0.02,
                            .slack = 0.05,
                            .enough = kLongest / kShare,
                            .useful = kShortestGrain / kShare};
    const auto pole = boxPole(cloth, {1, 1 / kSlender}, angle, coarserIfSmall(search, cloth));
    const double length = pole ? std::min(kLongest, kShare * pole->room) : 0;
    if (length < kShortestGrain) {
        return std::nullopt;
    }
    const Eigen::Vector2d half = 0.5 * length * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    return Chord{pole->place - half, pole->place + half};
}

Points2 arrowPath(const Chord& line) {
    const Eigen::Vector2d way = line.to - line.from;
    const double head = std::min(kHead, kHeadShare * way.norm());
    const Eigen::Vector2d back = -head * way.normalized();
    Points2 path(5, 2);
    path << line.from.transpose(), line.to.transpose(),
        (line.to + Eigen::Rotation2Dd(kHeadAngle) * back).transpose(), line.to.transpose(),
        (line.to + Eigen::Rotation2Dd(-kHeadAngle) * back).transpose();
    return path;
}

namespace {

/// Mean slope, height per length along the cloth, below which a piece lies level.
constexpr double kLevel = 0.05;
/// If the mean change is less than this part of its absolute value, ups and downs cancel out.
constexpr double kCancelled = 0.35;
/// A turned grain is used if its cost is below the first part of the straight grain's, or if its
/// share beyond the fabric's limits is below that part and smaller by the second.
constexpr double kWorthTurning = 0.8, kWorthShare = 0.02;
/// Variance of the normals below which a piece is plane, and length of their mean above which they
/// fill less than a quarter of a turn.
constexpr double kPlane = 1e-9, kNarrow = 0.9;
/// Shares that differ by less are equal.
constexpr double kEqualShares = 1e-9;

/// Gradient of the height over a flat piece, mm per mm.
struct Rise {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();      ///< integral of gradient g over the area
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();  ///< integral of g g^T
    double length = 0;                                  ///< integral of |g|
    double area = 0;
};

/// @param height  per vertex
Rise riseOf(const MeshArrays& mesh, const Points2& Q, const Eigen::VectorXd& height) {
    Rise rise;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3i corner = mesh.F.row(f);
        Eigen::Matrix2d sides;
        sides << Q.row(corner[1]) - Q.row(corner[0]), Q.row(corner[2]) - Q.row(corner[0]);
        const double doubled = sides.determinant();
        const Eigen::Vector2d change(height[corner[1]] - height[corner[0]],
                                     height[corner[2]] - height[corner[0]]);
        const Eigen::Vector2d gradient = sides.inverse() * change;
        if (!(doubled > 0) || !gradient.allFinite()) {
            continue;  // flipped or degenerate
        }
        const double area = doubled / 2;
        rise.sum += area * gradient;
        rise.squares += area * gradient * gradient.transpose();
        rise.length += area * gradient.norm();
        rise.area += area;
    }
    return rise;
}

double angleOf(const Eigen::Vector2d& way) {
    return std::atan2(way.y(), way.x());
}

bool isSewnToItself(const Garment& garment, int piece) {
    return std::ranges::any_of(garment.seams.seams, [piece](const Seam& seam) {
        return seam.kind == SeamKind::Seam && seam.left.piece == piece && seam.right.piece == piece;
    });
}

/// Up, or along a tube; no rows if the piece lies level.
Points3 hangingWarp(const Garment& garment, int piece) {
    const MeshArrays& mesh = garment.pieces[piece]->mesh;
    if (isSewnToItself(garment, piece)) {
        return axisWarp(mesh);
    }
    PieceCloth cloth;
    cloth.warp = Eigen::RowVector3d::UnitY();
    const Eigen::VectorXd areas = triangleAreas3d(mesh);
    double rise = 0;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        rise += areas[f] > 0 ? areas[f] * warpIn(cloth, mesh, f).norm() : 0;
    }
    return rise > kLevel * areas.sum() ? cloth.warp : Points3(0, 3);
}

std::optional<double> verticalGrain(const Garment& garment, const PieceResult& result, int piece) {
    const MeshArrays& mesh = result.piece->mesh;
    const Rise rise = riseOf(mesh, result.flat->Q, mesh.V.col(1));
    if (!(rise.length > kLevel * rise.area)) {
        return std::nullopt;
    }
    if (rise.sum.norm() > kCancelled * rise.length) {
        return angleOf(rise.sum);
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
    axes.computeDirect(rise.squares);
    // On a lying tube, height changes around the tube, and the warp runs along it.
    Eigen::Vector2d way = axes.eigenvectors().col(isSewnToItself(garment, piece) ? 0 : 1);
    const double up = way.dot(rise.sum);
    return angleOf(up < 0 || (up == 0 && way.y() < 0) ? Eigen::Vector2d(-way) : way);
}

/// Up the reference panel.
std::optional<double> referenceGrain(const PieceResult& result) {
    const Rise rise = riseOf(result.piece->mesh, result.flat->Q, result.piece->reference->col(1));
    return rise.sum.norm() > kCancelled * rise.length ? std::optional(angleOf(rise.sum))
                                                      : std::nullopt;
}

/// The straight grain, or a turned one with clearly less area beyond the fabric's limits, or with
/// the same area and clearly less excess. No turn increases the displayed share.
double leastStrained(const PieceResult& result, const Fabric& stated, double straight) {
    // A woven fabric depends on the grain the most.
    const Fabric& fabric = hasLimits(stated) ? stated : *fabricPreset("woven");
    const auto shareAt = [&](double angle) -> double {
        return strainedArea(result.piece->mesh, result.flat->Q, fabric, angle).share();
    };
    const auto costAt = [&](double angle) -> double {
        return grainCost(result.piece->mesh, result.flat->Q, fabric, angle);
    };
    const double straightShare = shareAt(straight), straightCost = costAt(straight);
    double best = straight, bestShare = straightShare, bestCost = straightCost;
    for (const double turn : {kPi / 2, kPi / 4, -kPi / 4}) {
        const double share = shareAt(straight + turn), cost = costAt(straight + turn);
        const bool isWorthIt =
            share <= std::min(kWorthTurning * straightShare, straightShare - kWorthShare) ||
            (share <= straightShare && cost < kWorthTurning * straightCost);
        const bool isBetter =
            share < bestShare - kEqualShares ||
            (share <= bestShare + kEqualShares && cost < kWorthTurning * bestCost);
        if (isWorthIt && isBetter) {  // of equal ones the first
            best = straight + turn;
            bestShare = share;
            bestCost = cost;
        }
    }
    return best;
}

/// The direction of the axis about which a flat piece mirrors itself; nothing if it has none.
std::optional<double> axisOf(const PieceResult& result, const DrawnMirror& drawn,
                             const Symmetry* symmetry, int piece) {
    if (drawn.isSymmetric) {
        const Points2& line = result.flat->line->points;
        return angleOf((line.row(line.rows() / 2) - line.row(0)).transpose());
    }
    const bool isOwnImage = symmetry && symmetry->pieces.counterpart[piece] == piece;
    return isOwnImage
               ? std::optional(
                     wrappedAngle(reflectionBetween(result, result, symmetry->plane).turn + kPi) /
                     2)
               : std::nullopt;
}

/// The direction nearest to `angle` that is a multiple of `step` from the axis.
double alongAxis(double angle, double axis, double step) {
    const double along = axis + std::round(std::remainder(angle - axis, 2 * kPi) / step) * step;
    return std::remainder(along, 2 * kPi);
}

std::optional<double> grainBy(GrainRule rule, const Garment& garment, const PieceResult& result,
                              int piece, const Fabric& fabric, const std::optional<double>& axis) {
    if (rule == GrainRule::Reference && result.piece->reference) {
        if (const auto grain = referenceGrain(result)) {
            return axis ? alongAxis(*grain, *axis, kPi / 4) : grain;
        }
    }
    auto straight = verticalGrain(garment, result, piece);
    if (straight && axis) {
        straight = alongAxis(*straight, *axis, kPi / 2);
    }
    return straight && rule == GrainRule::LeastStrain
               ? std::optional(leastStrained(result, fabric, *straight))
               : straight;
}

}  // namespace

std::vector<std::optional<double>> findGrains(const Garment& garment, const PieceResults& results,
                                              const Symmetry* symmetry, GrainRule rule,
                                              const std::vector<Fabric>& fabrics) {
    std::vector<std::optional<double>> grains(results.size());
    const std::vector<DrawnMirror> mirrors = drawnMirrors(results);
    for (int p = 0; p < static_cast<int>(results.size()); ++p) {
        if (!results[p] || !results[p]->flat) {
            continue;
        }
        const int other = symmetry ? symmetry->pieces.counterpart[p] : -1;
        if (other >= 0 && other < p && grains[other]) {
            grains[p] = mirroredDirection(garment, results, *symmetry, other, *grains[other]);
        }
        if (!grains[p]) {
            grains[p] = grainBy(rule, garment, *results[p], p, fabrics[p],
                                axisOf(*results[p], mirrors[p], symmetry, p));
        }
    }
    return grains;
}

Points3 axisWarp(const MeshArrays& mesh) {
    double area = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero(), centre = mean;
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero(), spread = normals;
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::Matrix3d corner = mesh.V(mesh.F.row(f), Eigen::all).transpose();
        const Eigen::Vector3d normal =
            (corner.col(1) - corner.col(0)).cross(corner.col(2) - corner.col(0)) / 2;
        const double part = normal.norm();
        if (!(part > 0)) {
            continue;
        }
        const Eigen::Vector3d sum = corner.rowwise().sum();
        area += part;
        mean += normal;
        centre += part / 3 * sum;
        normals += normal * normal.transpose() / part;
        spread += part / 12 * (corner * corner.transpose() + sum * sum.transpose());
    }
    mean /= area;
    centre /= area;
    normals = normals / area - mean * mean.transpose();
    spread = spread / area - centre * centre.transpose();
    if (normals.trace() < kPlane) {
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread)
            .eigenvectors()
            .col(2)
            .transpose();
    }
    // The normals of a narrow patch hardly vary along their mean either, which is no axis.
    if (mean.norm() > kNarrow) {
        normals += mean * mean.transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normals)
        .eigenvectors()
        .col(0)
        .transpose();
}

Points3 warpThrough(const MeshArrays& mesh, const Points2& flat, double angle) {
    Points3 warp = Points3::Zero(mesh.V.rows(), 3);
    const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
    for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
        const Eigen::RowVector3i corner = mesh.F.row(f);
        Eigen::Matrix2d sides;
        sides << (flat.row(corner[1]) - flat.row(corner[0])).transpose(),
            (flat.row(corner[2]) - flat.row(corner[0])).transpose();
        const Eigen::Vector2d along = sides.inverse() * way;
        const Eigen::RowVector3d worn = along[0] * (mesh.V.row(corner[1]) - mesh.V.row(corner[0])) +
                                        along[1] * (mesh.V.row(corner[2]) - mesh.V.row(corner[0]));
        if (!worn.allFinite()) {
            continue;  // degenerate in the plane
        }
        for (const int v : corner) {
            warp.row(v) += std::abs(sides.determinant()) * worn;
        }
    }
    for (Eigen::Index v = 0; v < warp.rows(); ++v) {
        warp.row(v).stableNormalize();
    }
    return warp;
}

PieceCloths pieceCloths(const Garment& garment, const std::optional<GrainRule>& rule,
                        const std::vector<Fabric>& fabrics, const PieceResults& known,
                        const std::vector<std::optional<double>>& typed) {
    PieceCloths cloths;
    for (std::size_t p = 0; p < garment.pieces.size(); ++p) {
        const Piece& piece = *garment.pieces[p];
        PieceCloth cloth;
        if (p < fabrics.size()) {
            cloth.fabric = fabrics[p];
            cloth.stiffness = clothStiffness(fabrics[p]);
        }
        if (p < typed.size() && typed[p] && p < known.size() && known[p] && known[p]->flat) {
            cloth.warp = warpThrough(piece.mesh, known[p]->flat->Q, *typed[p]);
        } else if (rule == GrainRule::Reference && piece.reference) {
            cloth.warp = warpThrough(piece.mesh, *piece.reference, kPi / 2);
        } else if (rule) {
            cloth.warp = hangingWarp(garment, static_cast<int>(p));
        }
        cloths.push_back(std::make_shared<const PieceCloth>(std::move(cloth)));
    }
    return cloths;
}

}  // namespace toile
