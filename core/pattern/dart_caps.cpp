// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/dart_caps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

namespace toile {
namespace {

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

}  // namespace

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

}  // namespace toile
