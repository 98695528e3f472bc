// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/darts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/dart_caps.h"
#include "core/pattern/half_pattern.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using geometry::cross;

constexpr double kSameTip = 0.01;   // mm: between the end of one side and the start of the other
constexpr double kAtMiddle = 1e-3;  // mm: a dart that passes the middle nearer points at it
constexpr int kDrillPoints = 24;    // of its circle
constexpr double kTipCross = 5;     // mm: length of a stroke
constexpr double kDrillOfLeg = 1.0 / 3, kDrillOfFold = 0.5;

/// The angle at the tip, summed along the legs, so that more than 180 degrees is no crossing.
double openingAngle(const Points2& legs, const Vector2d& tip, Eigen::Index firstOfSecond) {
    double angle = 0;
    std::optional<Vector2d> before;
    bool isBeyondTip = false;
    for (Eigen::Index k = 0; k < legs.rows(); ++k) {
        const Vector2d here = legs.row(k).transpose() - tip;
        if (here.norm() < kNoIntake) {
            continue;
        }
        if (before) {
            double turn = geometry::turnBetween(*before, here);
            const bool isAtTip = k >= firstOfSecond && !isBeyondTip;
            if (isAtTip && turn < -0.5 * std::numbers::pi) {
                turn += 2 * std::numbers::pi;
            }
            angle += turn;
        }
        isBeyondTip = k >= firstOfSecond;
        before = here;
    }
    return angle;
}

/// Centroid of the area; for a half pattern that of the whole piece.
Vector2d middleOf(const PatternPiece& piece) {
    const Points2& line = piece.outline;
    const Vector2d origin = line.row(0);
    Vector2d sum = Vector2d::Zero();
    double area = 0;
    for (Eigen::Index k = 1; k + 1 < line.rows(); ++k) {
        const Vector2d a = line.row(k).transpose() - origin;
        const Vector2d b = line.row(k + 1).transpose() - origin;
        area += cross(a, b);
        sum += cross(a, b) / 3 * (a + b);
    }
    Vector2d middle =
        area > 0 ? Vector2d(origin + sum / area) : Vector2d(line.colwise().mean().transpose());
    if (piece.cutAs != CutAs::OnFold) {
        return middle;
    }
    const Chord fold = foldOf(piece);
    return 0.5 * (middle + mirroredIn(fold.from, (fold.to - fold.from).normalized(), middle));
}

/// Lay by convention.
DartLay usualLay(const PieceDart& dart, double grain, const Vector2d& middle) {
    const Vector2d base = 0.5 * (dart.mouth.from + dart.mouth.to);
    const Vector2d way = (dart.tip - base).normalized();
    const Vector2d up(std::cos(grain), std::sin(grain));
    // The first leg is on the left when looking towards the tip.
    const bool isUpright = std::abs(way.dot(up)) >= std::abs(cross(way, up));
    const double left = isUpright ? cross(way, middle - base) : -cross(way, up);
    return left > -kAtMiddle ? DartLay::First : DartLay::Second;
}

/// The darts without their caps.
std::vector<PieceDart> openDarts(const PatternPiece& piece, const geometry::Line& outline) {
    const Vector2d middle = middleOf(piece);
    std::vector<PieceDart> darts;
    const auto add = [&](const SeamLine& first, const SeamLine& second) {
        const double ofFirst = first.to - first.from, ofSecond = second.to - second.from;
        if (first.kind != SeamKind::Dart || second.kind != SeamKind::Dart ||
            first.number != second.number || first.isRight == second.isRight ||
            !(ofFirst > kSameTip) || !(ofSecond > kSameTip) ||
            outline.apart(first.to, second.from) > kSameTip ||
            !(outline.length() - ofFirst - ofSecond > kSameTip)) {
            return;
        }
        PieceDart& dart = darts.emplace_back();
        dart.seam = first.number;
        dart.from = outline.wrap(first.from);
        dart.leg = ofFirst;
        dart.to = dart.from + outline.wrap(second.to - first.from);
        dart.tip = outline.pointAt(dart.from + ofFirst);
        dart.mouth = {outline.pointAt(dart.from), outline.pointAt(dart.to)};
        dart.intake = (dart.mouth.to - dart.mouth.from).norm();
        dart.fold = {dart.tip, dart.tip};
        dart.drill = dart.tip;
        const Points2 legs = outline.part(dart.from, dart.to);
        const Eigen::Index firstRows = outline.part(dart.from, dart.from + ofFirst).rows();
        dart.angle = openingAngle(legs, dart.tip, firstRows - 1);
        if (!(dart.angle < kWidestDart)) {
            darts.pop_back();
            return;
        }
        const auto said = piece.saidOfDarts.find(first.seam);
        const bool isSaid = said != piece.saidOfDarts.end();
        dart.isTyped = isSaid && said->second.intake.has_value();
        dart.lay =
            isSaid && said->second.lay ? *said->second.lay : usualLay(dart, grainOf(piece), middle);
    };
    for (const SeamLine& first : piece.seams) {
        for (const SeamLine& second : piece.seams) {
            add(first, second);
        }
    }
    std::ranges::stable_sort(darts, {}, &PieceDart::from);
    return darts;
}

}  // namespace

std::vector<PieceDart> findDarts(const PatternPiece& piece) {
    if (piece.outline.rows() < 3 || !piece.outline.allFinite()) {
        return {};
    }
    const auto outline = geometry::Line::closed(piece.outline);
    std::vector<PieceDart> darts = openDarts(piece, outline);
    addDartCaps(piece, outline, darts);
    for (PieceDart& dart : darts) {
        const Vector2d fold = dart.fold.to - dart.fold.from;
        const double before =
            std::min({kDrillBeforeTip, kDrillOfLeg * dart.leg, kDrillOfFold * fold.norm()});
        dart.drill = dart.tip + before * fold.normalized();
    }
    return darts;
}

Points2 drillCircle(const Vector2d& centre) {
    Points2 circle(kDrillPoints, 2);
    for (int k = 0; k < kDrillPoints; ++k) {
        const double at = 2 * std::numbers::pi * k / kDrillPoints;
        circle.row(k) = centre + kDrillRadius * Vector2d(std::cos(at), std::sin(at));
    }
    return circle;
}

DartMarks dartMarks(const PieceDart& dart) {
    DartMarks marks;
    Vector2d way = dart.fold.to - dart.fold.from;
    if (dart.cap.rows() > 0) {
        marks.fold.resize(2, 2);
        marks.fold << dart.fold.from.transpose(), dart.fold.to.transpose();
        marks.drill = drillCircle(dart.drill);
    } else {
        way = 0.5 * (dart.mouth.from + dart.mouth.to) - dart.tip;
    }
    const Vector2d along = way.norm() > 0 ? Vector2d(way.normalized()) : Vector2d(0, 1);
    for (std::size_t k = 0; k < 2; ++k) {
        const Vector2d half = 0.5 * kTipCross * (k == 0 ? along : geometry::leftOf(along));
        marks.cross[k].resize(2, 2);
        marks.cross[k] << (dart.tip - half).transpose(), (dart.tip + half).transpose();
    }
    return marks;
}

}  // namespace toile
