// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/placement.h"

#include "core/base/units.h"
#include "core/geometry/segment.h"

namespace toile::geometry {

Placement Placement::inverse() const {
    // A reflection before a turn is one after the opposite turn.
    Placement back{{0, 0}, mirrored ? turn : -turn, mirrored};
    back.offset = -(back.linear() * offset);
    return back;
}

Placement fitMotion(const Polygon& from, const Polygon& to, bool mirrored,
                    const Eigen::VectorXd& weights) {
    if (from.rows() == 0) {
        return {};
    }
    const Eigen::VectorXd weight =
        weights.size() > 0 ? weights : Eigen::VectorXd::Ones(from.rows()).eval();
    const Eigen::RowVector2d middle = weight.transpose() * from / weight.sum();
    const Eigen::RowVector2d onto = weight.transpose() * to / weight.sum();
    // Sums of dot and cross products about the centroids: their angle is the turn.
    double along = 0, across = 0;
    for (Eigen::Index i = 0; i < from.rows(); ++i) {
        Eigen::RowVector2d a = from.row(i) - middle;
        const Eigen::RowVector2d b = to.row(i) - onto;
        a.x() *= mirrored ? -1 : 1;
        along += weight[i] * a.dot(b);
        across += weight[i] * cross(a, b);
    }
    Placement motion{{0, 0}, along != 0 || across != 0 ? std::atan2(across, along) : 0, mirrored};
    motion.offset = (onto - motion.appliedToRow(middle)).transpose();
    return motion;
}

double wrappedAngle(double angle) {
    if (!std::isfinite(angle)) {
        return 0;
    }
    const double wrapped = std::remainder(angle, 2 * kPi);
    return wrapped <= -kPi ? wrapped + 2 * kPi : wrapped;
}

double directionTo(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return std::atan2(to.y() - from.y(), to.x() - from.x());
}

Placement movedBy(Placement placement, const Eigen::Vector2d& way) {
    placement.offset += way;
    return placement;
}

Placement turnedAbout(Placement placement, const Eigen::Vector2d& centre, double angle) {
    placement.offset = centre + Eigen::Rotation2Dd(angle) * (placement.offset - centre);
    placement.turn = wrappedAngle(placement.turn + angle);
    return placement;
}

Placement mirroredAt(Placement placement, const Eigen::Vector2d& centre, Mirroring mirroring) {
    const bool across = mirroring == Mirroring::LeftRight;
    const int axis = across ? 0 : 1;
    placement.offset[axis] = 2 * centre[axis] - placement.offset[axis];
    // A reflection after a turn is the opposite turn after a reflection.
    placement.turn = wrappedAngle(across ? -placement.turn : kPi - placement.turn);
    placement.mirrored = !placement.mirrored;
    return placement;
}

double directionOnSheet(const Placement& placement, double direction) {
    return wrappedAngle(placement.turn + (placement.mirrored ? kPi - direction : direction));
}

double directionOnPiece(const Placement& placement, double direction) {
    const double turned = direction - placement.turn;
    return wrappedAngle(placement.mirrored ? kPi - turned : turned);
}

Polygon turnedLine(const Polygon& line, const Placement& placement) {
    if (placement.turn == 0 && !placement.mirrored) {
        return line;
    }
    Polygon turned = line * placement.linear().transpose();
    if (placement.mirrored) {
        turned = turned.colwise().reverse().eval();
    }
    return turned;
}

Polygon placedLine(const Polygon& line, const Placement& placement) {
    return turnedLine(line, placement).rowwise() + placement.offset.transpose();
}

Polygon placedOutline(const Polygon& Q, const std::vector<int>& boundary,
                      const Placement& placement) {
    Polygon points(boundary.size(), 2);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        points.row(static_cast<Eigen::Index>(i)) =
            placement.applied(Q.row(boundary[i]).transpose()).transpose();
    }
    return points;
}

Eigen::AlignedBox2d outlineBox(const Polygon& outline, const Placement& placement) {
    Eigen::AlignedBox2d box;
    const Eigen::Matrix2d linear = placement.linear();
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        box.extend(Eigen::Vector2d(placement.offset + linear * outline.row(i).transpose()));
    }
    return box;
}

std::complex<double> likeness(const CentredPlaces& ours, const CentredPlaces& theirs,
                              std::size_t start) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < ours.size(); ++k) {
        sum += ours[k] * std::conj(theirs[(k + start) % theirs.size()]);
    }
    return sum;
}

double squaresOf(const CentredPlaces& places) {
    double sum = 0;
    for (const std::complex<double>& place : places) {
        sum += std::norm(place);
    }
    return sum;
}

BestLikeness bestLikeness(const CentredPlaces& ours, const CentredPlaces& theirs) {
    BestLikeness best;
    for (std::size_t start = 0; start < ours.size(); ++start) {
        const std::complex<double> like = likeness(ours, theirs, start);
        if (std::abs(like) > std::abs(best.likeness)) {
            best = {like, start};
        }
    }
    return best;
}

}  // namespace toile::geometry
