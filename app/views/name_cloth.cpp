// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/name_cloth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/geometry/segment.h"
#include "core/pattern/pole.h"
#include "core/pattern/seam_marks.h"

namespace toile::app {
namespace {

constexpr double kOnto = 7;         ///< pixels that a leader extends onto the cloth, at most
constexpr double kOffArrow = 3.5;   ///< pixels to either side of a grain arrow
constexpr double kLeaderOff = 5;    ///< pixels from the end of a leader to an arrow
constexpr double kLongMoment = 3;   ///< ratio of the moments: a rectangle of about 1.5 to 1
constexpr double kOutlineStep = 1;  ///< pixels between outline points that are kept
constexpr double kRoomy = 3;        ///< times the box: large enough to stop the search
constexpr double kSameWay = 0.02;   ///< radians

/// The long axis of a clearly elongated piece in reading direction, radians. Nullopt if the piece
/// is about as wide as long.
std::optional<double> wayAlong(const Points2& outline) {
    // Second moments of the line itself do not depend on the spacing of its points.
    double length = 0;
    Eigen::Vector2d first(0, 0);
    Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
    for (Eigen::Index i = 0; i < outline.rows(); ++i) {
        const Eigen::Vector2d from = (outline.row(i) - outline.row(0)).transpose();
        const Eigen::Vector2d to =
            (outline.row((i + 1) % outline.rows()) - outline.row(0)).transpose();
        const Eigen::Vector2d middle = 0.5 * (from + to), way = to - from;
        const double part = way.norm();
        length += part;
        first += part * middle;
        second += part * (middle * middle.transpose() + way * way.transpose() / 12);
    }
    if (!(length > 0 && std::isfinite(length))) {
        return std::nullopt;
    }
    const Eigen::Vector2d mean = first / length;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> moments;
    moments.computeDirect(second / length - mean * mean.transpose());
    const Eigen::Vector2d& sizes = moments.eigenvalues();
    const Eigen::Vector2d way = moments.eigenvectors().col(1);
    if (!(sizes.y() > kLongMoment * sizes.x())) {
        return std::nullopt;
    }
    return readableAngle(std::atan2(way.y(), way.x()));
}

Points2 closedBox(const QRectF& box) {
    Points2 line(5, 2);
    line << box.left(), -box.top(), box.right(), -box.top(), box.right(), -box.bottom(), box.left(),
        -box.bottom(), box.left(), -box.top();
    return line;
}

}  // namespace

NameCloth::NameCloth(const QPolygonF& outline, const std::optional<QLineF>& own,
                     const std::vector<QLineF>& arrows, const std::vector<QRectF>& taken)
    : box_(outline.boundingRect()) {
    Points2 points(outline.size(), 2);
    Eigen::Index count = 0;
    for (const QPointF& at : outline) {
        const Eigen::RowVector2d point(at.x(), -at.y());
        if (count == 0 || (point - points.row(count - 1)).norm() > kOutlineStep) {
            points.row(count++) = point;
        }
    }
    points.conservativeResize(count, 2);
    if (const auto along = wayAlong(points)) {
        ways_.push_back(*along);
    }
    if (own && own->length() > 0) {
        const double angle = readableAngle(std::atan2(-own->dy(), own->dx()));
        if (ways_.empty() || std::abs(std::sin(angle - ways_.front())) > kSameWay) {
            ways_.push_back(angle);
        }
    }
    cloth_.loops = {std::move(points)};
    for (const QLineF& arrow : arrows) {
        addArrow(arrow);
    }
    for (const QRectF& box : taken) {
        if (box.intersects(box_)) {
            cloth_.obstacles.push_back(closedBox(box));
        }
    }
}

std::optional<QPointF> NameCloth::placeFor(const QSizeF& size, double angle) const {
    const double shorter = std::min(size.width(), size.height());
    if (cloth_.loops.front().rows() < 3 || std::hypot(box_.width(), box_.height()) < size.width() ||
        std::min(box_.width(), box_.height()) < shorter) {
        return std::nullopt;
    }
    const auto pole = boxPlace(cloth_, {size.width(), size.height()}, angle,
                               {.tolerance = 0.03, .slack = 0.05, .enough = kRoomy});
    return pole ? std::optional(QPointF(pole->place.x(), -pole->place.y())) : std::nullopt;
}

bool NameCloth::holds(const QRectF& box) const {
    const Points2& loop = cloth_.loops.front();
    if (!box_.contains(box) || loop.rows() < 3) {
        return false;
    }
    const Eigen::Vector2d low(box.left(), -box.bottom()), high(box.right(), -box.top());
    const auto meets = [&](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
        const auto share = geometry::shareInBox<Eigen::Vector2d>(from, to - from, low, high);
        return share.first <= share.last;
    };
    bool isInside = false;
    const Eigen::Vector2d middle = 0.5 * (low + high);
    for (Eigen::Index i = 0; i < loop.rows(); ++i) {
        const Eigen::Vector2d from = loop.row(i), to = loop.row((i + 1) % loop.rows());
        if (meets(from, to)) {
            return false;
        }
        if ((from.y() > middle.y()) != (to.y() > middle.y()) &&
            from.x() + (middle.y() - from.y()) / (to.y() - from.y()) * (to.x() - from.x()) >
                middle.x()) {
            isInside = !isInside;
        }
    }
    return isInside && std::ranges::none_of(cloth_.obstacles, [&](const Points2& line) {
               for (Eigen::Index i = 1; i < line.rows(); ++i) {
                   if (meets(line.row(i - 1), line.row(i))) {
                       return true;
                   }
               }
               return false;
           });
}

std::optional<QPointF> NameCloth::onto(const QPointF& from, const QPointF& way) const {
    const Points2& loop = cloth_.loops.front();
    std::vector<double> meets;
    const Eigen::Vector2d start(from.x(), -from.y()), along(way.x(), -way.y());
    const Eigen::Vector2d across(-along.y(), along.x());
    for (Eigen::Index i = 0; i < loop.rows(); ++i) {
        const Eigen::Vector2d a = loop.row(i).transpose() - start,
                              b = loop.row((i + 1) % loop.rows()).transpose() - start;
        const double from0 = across.dot(a), to0 = across.dot(b);
        if ((from0 > 0) != (to0 > 0)) {
            meets.push_back(along.dot(a + from0 / (from0 - to0) * (b - a)));
        }
    }
    std::ranges::sort(meets);
    if (meets.size() < 2 || meets[0] < 0) {
        return std::nullopt;
    }
    return from + (meets[0] + std::min(kOnto, 0.5 * (meets[1] - meets[0]))) * way;
}

bool NameCloth::isOnArrow(const QPointF& at) const {
    return std::ranges::any_of(arrows_, [&at](const QLineF& arrow) -> bool {
        return geometry::distanceToSegment<Eigen::Vector2d>({at.x(), at.y()},
                                                            {arrow.x1(), arrow.y1()},
                                                            {arrow.x2(), arrow.y2()}) < kLeaderOff;
    });
}

void NameCloth::addArrow(const QLineF& arrow) {
    if (arrow.length() <= 0 ||
        !box_.adjusted(-kOffArrow, -kOffArrow, kOffArrow, kOffArrow)
             .intersects(QRectF(arrow.p1(), arrow.p2()).normalized().adjusted(-1, -1, 1, 1))) {
        return;
    }
    const Eigen::RowVector2d from(arrow.x1(), -arrow.y1()), to(arrow.x2(), -arrow.y2());
    const Eigen::RowVector2d along = (to - from).normalized() * kOffArrow;
    const Eigen::RowVector2d aside(-along.y(), along.x());
    Points2 line(5, 2);
    line << from - along + aside, from - along - aside, to + along - aside, to + along + aside,
        from - along + aside;
    cloth_.obstacles.push_back(std::move(line));
    arrows_.push_back(arrow);
}

}  // namespace toile::app
