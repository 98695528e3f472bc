// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/paint_drawing.h"

#include <QBuffer>
#include <QPainter>
#include <cmath>
#include <numbers>

#include "core/formats/drawing/text_outlines.h"
#include "core/pattern/label.h"

namespace toile::app {

namespace {

/// In the order of the layer kinds.
constexpr QRgb kLayerColours[] = {0xd00000, 0x606060, 0xc06000, 0x0070c0,
                                  0x008000, 0x800080, 0x000000, 0x0000ff};
static_assert(std::size(kLayerColours) == kLayerKinds.size());

constexpr double kMaxDots = 30000;  // per side; QPainter supports at most 32767
constexpr double kMaxOfPicture = 400e6;

QColor colourOf(LayerKind kind) {
    return QColor::fromRgb(kLayerColours[static_cast<std::size_t>(kind)]);
}

QPolygonF polygonOf(const DrawnPath& path, double height) {
    QPolygonF polygon;
    polygon.reserve(path.points.rows());
    for (Eigen::Index k = 0; k < path.points.rows(); ++k) {
        polygon << QPointF(path.points(k, 0), height - path.points(k, 1));
    }
    return polygon;
}

void paintText(QPainter& painter, const DrawnText& text, double height) {
    painter.save();
    painter.translate(text.position.x(), height - text.position.y());
    painter.rotate(-text.angle * 180 / std::numbers::pi);
    double baseline = 0.5 * text.height;
    for (const std::string& line : text.lines) {
        const Letters letters = lettersOf(line, text.height);
        painter.fillPath(letters.path.translated(-0.5 * letters.width, baseline),
                         colourOf(text.layer));
        baseline += kLineSpacing * text.height;
    }
    painter.restore();
}

Result<ExportedFiles> makePng(const ExportSource& source) {
    const Result<QImage> picture = pictureOf(source.drawing(), source.options().png.dpi);
    if (!picture) {
        return picture.error();
    }
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    if (!picture->save(&buffer, "PNG")) {
        return Error{ErrorCode::OutOfMemory};
    }
    return ExportedFiles{{"", bytes.toStdString()}};
}

}  // namespace

Letters lettersOf(const std::string& line, double height) {
    const TextOutlines outlines = textOutlines(line, height);
    Letters letters{{}, outlines.width};
    letters.path.setFillRule(Qt::WindingFill);
    const auto at = [](const Eigen::Vector2d& point) { return QPointF(point.x(), -point.y()); };
    for (const auto& contour : outlines.contours) {
        for (std::size_t k = 0; k < contour.size(); ++k) {
            if (k == 0) {
                letters.path.moveTo(at(contour[k].start));
            }
            letters.path.cubicTo(at(contour[k].startHandle), at(contour[k].endHandle),
                                 at(contour[k].end));
        }
        letters.path.closeSubpath();
    }
    return letters;
}

void paintDrawing(QPainter& painter, const Drawing& drawing, const DrawingLook& look) {
    const auto isSeen = [&look](LayerKind layer) -> bool {
        return look.check || layer != LayerKind::Check;
    };
    for (const DrawnPath& path : drawing.paths) {
        if (!isSeen(path.layer)) {
            continue;
        }
        painter.setPen(
            QPen(colourOf(path.layer), look.line, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        const QPolygonF polygon = polygonOf(path, drawing.height);
        if (path.closed) {
            painter.setBrush(Qt::NoBrush);
            painter.drawPolygon(polygon);
        } else {
            painter.drawPolyline(polygon);
        }
    }
    for (const DrawnText& text : drawing.texts) {
        if (look.texts && isSeen(text.layer)) {
            paintText(painter, text, drawing.height);
        }
    }
}

Result<QImage> pictureOf(const Drawing& drawing, double dpi) {
    const double scale = dpi / kMillimetresPerInch;
    const double width = std::round(drawing.width * scale),
                 height = std::round(drawing.height * scale);
    if (!(width <= kMaxDots && height <= kMaxDots && width * height <= kMaxOfPicture)) {
        const double most = std::min(
            {kMaxDots / width, kMaxDots / height, std::sqrt(kMaxOfPicture / (width * height))});
        const double fitting = std::floor(most * dpi);
        return Error{ErrorCode::PageTooSmall,
                     {},
                     fitting < 1
                         ? worded("%1 x %2 mm are too large for a picture at any resolution",
                                  {figure(drawing.width), figure(drawing.height)})
                         : worded("%1 x %2 pixels; the maximum is %3 dpi",
                                  {figure(width), figure(height), figure(fitting)})};
    }
    QImage picture(static_cast<int>(width), static_cast<int>(height), QImage::Format_RGB32);
    if (picture.isNull()) {
        return Error{ErrorCode::OutOfMemory};
    }
    picture.fill(Qt::white);
    const double dotsPerMetre = 1000 * scale;
    picture.setDotsPerMeterX(static_cast<int>(std::lround(dotsPerMetre)));
    picture.setDotsPerMeterY(static_cast<int>(std::lround(dotsPerMetre)));
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(scale, scale);
    paintDrawing(painter, drawing);
    return picture;
}

void provideWriters() {
    provideWriter(FormatId::Png, makePng);
}

}  // namespace toile::app
