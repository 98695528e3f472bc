// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/darts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/geometry/line.h"
#include "core/geometry/segment.h"
#include "core/pattern/half_pattern.h"

namespace toile {
namespace {

/// mm: darts that open by no more than this are closed; the rest is rounding.
inline constexpr double kNoIntake = 1e-6;

/// The mirror image of a point in a line. @param along  unit length
inline Eigen::Vector2d mirroredIn(const Eigen::Vector2d& from, const Eigen::Vector2d& along,
                                  const Eigen::Vector2d& point) {
    const Eigen::Vector2d rest = point - from;
    return from + 2 * along.dot(rest) * along - rest;
}

using Eigen::RowVector2d;
using Eigen::Vector2d;
using geometry::cross;

constexpr double kCapTrim = 1e-6;  // part of an edge: caps touch the outline at the mouth

Vector2d foldWay(const PieceDart& dart) {
    return Eigen::Rotation2Dd(0.5 * dart.angle) * (dart.mouth.from - dart.tip).normalized();
}

/// Computes the cap of a dart, in coordinates of the leg over which it is laid.
class CapMaker {
public:
    CapMaker(const PatternPiece& piece, const geometry::Line& outline,
             const std::vector<PieceDart>& darts, const PieceDart& dart)
        : piece_(piece), outline_(outline), darts_(darts), dart_(dart) {}

    /// The middle row is on the fold; empty if the line beyond the leg does not reach the fold.
    Points2 shaped() const {
        std::vector<Vector2d> half = mirroredLine();
        const std::optional<Vector2d> end = cutAtFold(half);
        const double along = end ? fold_.dot(*end - dart_.tip) : 0;
        if (!(along > 0 && along <= reach_)) {
            return {};
        }
        const Vector2d image = mirroredIn(dart_.tip, fold_, mouth_) - *end;
        const Vector2d wanted = (overFirst_ ? dart_.mouth.to : dart_.mouth.from) - *end;
        const double square = image.squaredNorm();
        if (!(square > kNoIntake * kNoIntake)) {
            return {};
        }
        const double c = image.dot(wanted) / square, s = cross(image, wanted) / square;
        const Eigen::Matrix2d ontoMouth = (Eigen::Matrix2d() << c, -s, s, c).finished();
        const auto count = static_cast<Eigen::Index>(half.size());
        Points2 cap(2 * count + 1, 2);
        for (Eigen::Index k = 0; k < count; ++k) {
            const Vector2d& p = half[static_cast<std::size_t>(k)];
            cap.row(k) = p;
            cap.row(2 * count - k) = *end + ontoMouth * (mirroredIn(dart_.tip, fold_, p) - *end);
        }
        cap.row(count) = *end;
        return overFirst_ ? cap : Points2(cap.colwise().reverse());
    }

private:
    /// Length of the line beyond the leg, to the next corner or dart.
    double lengthBeyond() const {
        const double at = overFirst_ ? dart_.from : dart_.to;
        const auto wayTo = [&](double place) {
            const double way = outline_.wrap(overFirst_ ? at - place : place - at);
            return outline_.length() - way > kNoIntake ? way : 0;
        };
        double length = reach_;
        for (const PieceDart& other : darts_) {
            length = std::min(length, wayTo(overFirst_ ? other.to : other.from));
        }
        for (const PatternSegment& segment : piece_.segments) {
            const double way = wayTo(segment.from);
            if (segment.isCorner && way > kNoIntake) {  // the mouth itself is a corner
                length = std::min(length, way);
            }
        }
        return length;
    }

    /// The piece's line from the mouth on, mirrored in the leg.
    std::vector<Vector2d> mirroredLine() const {
        const double at = overFirst_ ? dart_.from : dart_.to;
        const double length = lengthBeyond();
        const Points2 beyond = overFirst_
                                   ? Points2(outline_.part(at - length, at).colwise().reverse())
                                   : outline_.part(at, at + length);
        const double onLeg = std::min({kDartMouth, dart_.leg, dart_.to - dart_.from - dart_.leg});
        const Vector2d inner = outline_.pointAt(overFirst_ ? at + onLeg : at - onLeg);
        const Vector2d leg = (mouth_ - inner).normalized();
        std::vector<Vector2d> mirrored{mouth_};
        mirrored.reserve(static_cast<std::size_t>(beyond.rows()));
        for (Eigen::Index k = 1; k < beyond.rows(); ++k) {
            if ((beyond.row(k) - beyond.row(k - 1)).norm() > kNoIntake) {
                mirrored.push_back(mirroredIn(mouth_, leg, beyond.row(k).transpose()));
            }
        }
        return mirrored;
    }

    /// Signed distance of a point from the fold, positive on the side of the leg.
    double aside(const Vector2d& p) const {
        return (overFirst_ ? -1 : 1) * cross(fold_, p - dart_.tip);
    }

    /// Ends the line at the fold and prolongs it if necessary.
    /// @return its intersection with the fold; nothing if it turns away, or has no length
    std::optional<Vector2d> cutAtFold(std::vector<Vector2d>& line) const {
        std::size_t k = 1;
        while (k < line.size() && aside(line[k]) > 0) {
            ++k;
        }
        const std::size_t last = std::min(k, line.size() - 1);
        if (last == 0) {
            return std::nullopt;
        }
        const Vector2d from = line[last - 1], to = line[last];
        const double before = aside(from), after = aside(to);
        if (!(before > after)) {
            return std::nullopt;
        }
        line.resize(k);
        return from + before / (before - after) * (to - from);
    }

    const PatternPiece& piece_;
    const geometry::Line& outline_;
    const std::vector<PieceDart>& darts_;
    const PieceDart& dart_;
    bool overFirst_ = dart_.lay == DartLay::First;
    Vector2d mouth_ = overFirst_ ? dart_.mouth.from : dart_.mouth.to;
    Vector2d fold_ = foldWay(dart_);
    double reach_ = kLongestFold * (mouth_ - dart_.tip).norm();
};

bool edgesCross(const RowVector2d& a, const RowVector2d& b, const RowVector2d& c,
                const RowVector2d& d) {
    const auto boxOf = [](const RowVector2d& p, const RowVector2d& q) {
        return Eigen::AlignedBox2d(p.cwiseMin(q).transpose(), p.cwiseMax(q).transpose());
    };
    return boxOf(a, b).intersects(boxOf(c, d)) &&
           geometry::exactOrientation(a, b, c) * geometry::exactOrientation(a, b, d) < 0 &&
           geometry::exactOrientation(c, d, a) * geometry::exactOrientation(c, d, b) < 0;
}

bool linesCross(const Points2& open, const Points2& other, bool isClosed) {
    const Eigen::Index n = other.rows();
    for (Eigen::Index i = 0; i + 1 < open.rows(); ++i) {
        for (Eigen::Index k = isClosed ? 0 : 1; k < n; ++k) {
            if (edgesCross(open.row(i), open.row(i + 1), other.row((k + n - 1) % n),
                           other.row(k))) {
                return true;
            }
        }
    }
    return false;
}

/// A cap without its ends, which lie on the outline.
Points2 capInside(const Points2& cap) {
    Points2 inside = cap;
    const Eigen::Index n = cap.rows();
    if (n > 1) {
        inside.row(0) += kCapTrim * (cap.row(1) - cap.row(0));
        inside.row(n - 1) += kCapTrim * (cap.row(n - 2) - cap.row(n - 1));
    }
    return inside;
}

/// Sets a straight cap across the mouth, and the fold's end on it.
void capStraight(PieceDart& dart) {
    const Chord& mouth = dart.mouth;
    dart.cap.resize(2, 2);
    dart.cap << mouth.from.transpose(), mouth.to.transpose();
    double share = 0.5;
    if (dart.intake > kNoIntake) {
        const Vector2d fold = foldWay(dart);
        const double first = -cross(fold, mouth.from - dart.tip);
        share = first / (first + cross(fold, mouth.to - dart.tip));
    }
    dart.fold.to = mouth.from + share * (mouth.to - mouth.from);
}

/// Chooses the first cap that has room: shaped by the line beyond, straight, none.
class CapChoice {
public:
    CapChoice(const PatternPiece& piece, PieceDart& dart, Points2 shaped)
        : outline_(piece.outline), dart_(&dart), shaped_(std::move(shaped)) {
        next();
    }

    void next() {
        do {
            ++tried_;
            take();
        } while (hasNoRoom());
    }
    Points2 inside() const { return capInside(dart_->cap); }

private:
    void take() {
        if (tried_ == 1 && shaped_.rows() > 0) {
            dart_->cap = shaped_;
            dart_->fold.to = shaped_.row(shaped_.rows() / 2).transpose();
        } else if (tried_ <= 2) {
            tried_ = 2;
            capStraight(*dart_);
        } else {
            dart_->cap.resize(0, 2);
            dart_->fold.to = dart_->tip;
        }
    }
    bool hasNoRoom() const {
        const Points2 cap = inside();
        return linesCross(cap, cap, false) || linesCross(cap, outline_, true);
    }

    const Points2& outline_;
    PieceDart* dart_;
    Points2 shaped_;
    int tried_ = 0;
};

/// Adds caps and the ends of folds to the otherwise complete darts of a piece (see `findDarts`).
void addDartCaps(const PatternPiece& piece, const geometry::Line& outline,
                 std::vector<PieceDart>& darts) {
    std::vector<CapChoice> choices;
    choices.reserve(darts.size());
    for (PieceDart& dart : darts) {
        if (dart.intake <= kNoIntake) {
            capStraight(dart);
        } else if (dart.angle > 0) {
            choices.emplace_back(piece, dart, CapMaker(piece, outline, darts, dart).shaped());
        }
    }
    // Simplify both of two crossing caps, so that the order does not matter.
    for (std::vector<bool> crosses(choices.size(), true);
         std::ranges::find(crosses, true) != crosses.end();) {
        crosses.assign(choices.size(), false);
        for (std::size_t i = 0; i < choices.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k) {
                if (linesCross(choices[i].inside(), choices[k].inside(), false)) {
                    crosses[i] = crosses[k] = true;
                }
            }
        }
        for (std::size_t i = 0; i < choices.size(); ++i) {
            if (crosses[i]) {
                choices[i].next();
            }
        }
    }
}

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
        const auto stated = piece.statedDarts.find(first.seam);
        const bool isStated = stated != piece.statedDarts.end();
        dart.isTyped = isStated && stated->second.intake.has_value();
        dart.lay = isStated && stated->second.lay ? *stated->second.lay
                                                  : usualLay(dart, grainOf(piece), middle);
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
