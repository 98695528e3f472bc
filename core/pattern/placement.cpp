// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/placement.h"

#include "core/base/units.h"

namespace toile {

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

Points2 turnedLine(const Points2& line, const Placement& placement) {
    if (placement.turn == 0 && !placement.mirrored) {
        return line;
    }
    Points2 turned = line * placement.linear().transpose();
    if (placement.mirrored) {
        turned = turned.colwise().reverse().eval();
    }
    return turned;
}

Points2 placedOutline(const Points2& Q, const std::vector<int>& boundary,
                      const Placement& placement) {
    Points2 points(boundary.size(), 2);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
        points.row(static_cast<Eigen::Index>(i)) =
            placement.applied(Q.row(boundary[i]).transpose()).transpose();
    }
    return points;
}

Eigen::AlignedBox2d outlineBox(const Points2& outline, const Placement& placement) {
    Eigen::AlignedBox2d box;
    const Eigen::Matrix2d linear = placement.linear();
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        box.extend(Eigen::Vector2d(placement.offset + linear * outline.row(i).transpose()));
    }
    return box;
}

}  // namespace toile
