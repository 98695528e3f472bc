// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/drawing_preview.h"

#include <QPainter>
#include <algorithm>
#include <utility>

#include "app/export/paint_drawing.h"

namespace toile::app {

namespace {

constexpr int kEdge = 10;               // pixels around the page
constexpr double kSmallestLetters = 5;  // pixels; smaller texts are illegible
constexpr double kUsualLetters = 5;     // mm
constexpr QSize kHint(420, 360);

}  // namespace

DrawingPreview::DrawingPreview(QWidget* parent) : QWidget(parent) {
    setMinimumSize(240, 200);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Preview"));
}

void DrawingPreview::setDrawing(std::shared_ptr<const Drawing> drawing) {
    drawing_ = std::move(drawing);
    update();
}

void DrawingPreview::setSheets(QVector<QRectF> sheets) {
    sheets_ = std::move(sheets);
    update();
}

QSize DrawingPreview::sizeHint() const {
    return kHint;
}

void DrawingPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Mid));
    if (!drawing_) {
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(rect(), Qt::AlignCenter, tr("Drawing the pattern…"));
        return;
    }
    QRectF all;
    for (const QRectF& sheet : sheets_) {
        all |= sheet;
    }
    if (sheets_.isEmpty()) {
        all = QRectF(0, 0, drawing_->width, drawing_->height);
    }
    const QRectF room = QRectF(rect()).adjusted(kEdge, kEdge, -kEdge, -kEdge);
    const double scale = std::min(room.width() / all.width(), room.height() / all.height());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(room.center());
    painter.scale(scale, scale);
    painter.translate(-all.center());
    painter.fillRect(sheets_.isEmpty() ? all : QRectF(), Qt::white);
    for (const QRectF& sheet : sheets_) {
        painter.fillRect(sheet, Qt::white);
        painter.setPen(QPen(Qt::lightGray, 1 / scale));
        painter.drawRect(sheet);
    }
    paintDrawing(painter, *drawing_,
                 {.line = std::max(0.3, 1 / scale),
                  .texts = kUsualLetters * scale >= kSmallestLetters,
                  .check = sheets_.size() < 2});
}

}  // namespace toile::app
