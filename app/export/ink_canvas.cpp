// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/ink_canvas.h"

#include <QPainter>
#include <algorithm>
#include <numbers>
#include <string>

#include "app/export/paint_drawing.h"
#include "core/base/characters.h"

namespace toile::app {

namespace {

QPointF pointOf(const Eigen::Vector2d& point) {
    return {point.x(), point.y()};
}

QRectF rectOf(const Eigen::AlignedBox2d& box) {
    return {pointOf(box.min()), pointOf(box.max())};
}

/// With dashes as long as they are.
QPen asWide(QPen pen, double thinnest) {
    const double width = pen.widthF();
    if (width >= thinnest) {
        return pen;
    }
    QList<qreal> dashes = pen.dashPattern();
    for (qreal& length : dashes) {
        length *= width / thinnest;
    }
    pen.setWidthF(thinnest);
    if (pen.style() == Qt::CustomDashLine) {
        pen.setDashPattern(dashes);
    }
    return pen;
}

}  // namespace

void InkCanvas::restore() {
    state_ = std::move(kept_.back());
    kept_.pop_back();
}

void InkCanvas::transform(double a, double b, double c, double d, const Eigen::Vector2d& move) {
    state_.place = QTransform(a, b, c, d, move.x(), move.y()) * state_.place;
}

void InkCanvas::clip(const Eigen::AlignedBox2d& box) {
    const QRectF placed = state_.place.mapRect(rectOf(box));
    state_.clip = state_.clip ? *state_.clip & placed : placed;
}

void InkCanvas::drawing() {
    for (const Ink& drawn : pattern_) {
        Ink ink = drawn;
        ink.path = state_.place.map(drawn.path);
        ink.clip = state_.clip;
        const double edge = ink.pen.widthF();
        const QRectF reach = ink.path.controlPointRect().adjusted(-edge, -edge, edge, edge);
        if (!ink.clip || ink.clip->intersects(reach)) {
            inks_.push_back(std::move(ink));
        }
    }
}

void InkCanvas::setGrey(double grey) {
    state_.pen.setColor(QColor::fromRgbF(static_cast<float>(grey), static_cast<float>(grey),
                                         static_cast<float>(grey)));
}

void InkCanvas::setRoundEnds() {
    state_.pen.setCapStyle(Qt::RoundCap);
    state_.pen.setJoinStyle(Qt::RoundJoin);
}

void InkCanvas::stroke(const QPainterPath& path) {
    QPen pen = state_.pen;
    if (!state_.dashes.isEmpty()) {
        QList<qreal> inWidths;
        for (const qreal length : state_.dashes) {
            inWidths << length / pen.widthF();
        }
        pen.setDashPattern(inWidths);
    }
    inks_.push_back({state_.place.map(path), pen, {}, state_.clip});
}

void InkCanvas::line(const Points2& points, bool closed) {
    QPainterPath path;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        const QPointF point(points(k, 0), points(k, 1));
        k == 0 ? path.moveTo(point) : path.lineTo(point);
    }
    if (closed) {
        path.closeSubpath();
    }
    stroke(path);
}

void InkCanvas::curves(const std::vector<CubicCurve>& curves, bool closed) {
    QPainterPath path;
    path.moveTo(pointOf(curves.front().start));
    for (const CubicCurve& curve : curves) {
        if (curve.isLine) {
            path.lineTo(pointOf(curve.end));
        } else {
            path.cubicTo(pointOf(curve.startHandle), pointOf(curve.endHandle), pointOf(curve.end));
        }
    }
    if (closed) {
        path.closeSubpath();
    }
    stroke(path);
}

void InkCanvas::box(const Eigen::AlignedBox2d& box) {
    QPainterPath path;
    path.addRect(rectOf(box));
    stroke(path);
}

void InkCanvas::segment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    QPainterPath path;
    path.moveTo(pointOf(from));
    path.lineTo(pointOf(to));
    stroke(path);
}

double InkCanvas::text(std::string_view text, const Eigen::Vector2d& position, double height,
                       TextStart start, double angle, double most) {
    const Letters letters = lettersOf(cleanText(text), height);
    if (!(letters.width > 0)) {
        return 0;
    }
    const double scale = most > 0 ? std::min(1.0, most / letters.width) : 1;
    QTransform place;
    place.translate(position.x(), position.y());
    place.rotateRadians(angle);
    place.scale(scale, -scale);  // letters are y down
    place.translate(start == TextStart::Middle ? -0.5 * letters.width : 0, 0);
    inks_.push_back({(place * state_.place).map(letters.path), QPen(Qt::NoPen), state_.pen.color(),
                     state_.clip});
    return scale * letters.width;
}

void paintInks(QPainter& painter, const std::vector<Ink>& inks, double height, double thinnest) {
    painter.save();
    painter.translate(0, height);
    painter.scale(1, -1);
    for (const Ink& ink : inks) {
        painter.save();
        if (ink.clip) {
            painter.setClipRect(*ink.clip, Qt::IntersectClip);
        }
        if (ink.pen.style() == Qt::NoPen) {
            painter.fillPath(ink.path, ink.colour);
        } else {
            painter.strokePath(ink.path, asWide(ink.pen, thinnest));
        }
        painter.restore();
    }
    painter.restore();
}

}  // namespace toile::app
