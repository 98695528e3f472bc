// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/sheet_preview.h"

#include <QPainter>
#include <algorithm>
#include <utility>

namespace toile::app {

namespace {

constexpr double kThinnestLine = 1;  // pixels
constexpr int kSheetEdge = 10;       // pixels around the sheet
constexpr QSize kSheetHint(420, 460);

}  // namespace

SheetPreview::SheetPreview(QWidget* parent) : QWidget(parent) {
    setMinimumSize(240, 240);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Preview"));
}

void SheetPreview::setPattern(std::shared_ptr<const PrintedPattern> pattern) {
    pattern_ = std::move(pattern);
    update();
}

void SheetPreview::setSheet(int sheet) {
    sheet_ = sheet;
    update();
}

QSize SheetPreview::sizeHint() const {
    return kSheetHint;
}

void SheetPreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().color(QPalette::Mid));
    if (!pattern_ || sheet_ >= pattern_->count()) {
        return;
    }
    const QSizeF paper = pattern_->paper(sheet_);
    const QRectF room = QRectF(rect()).adjusted(kSheetEdge, kSheetEdge, -kSheetEdge, -kSheetEdge);
    const double scale = std::min(room.width() / paper.width(), room.height() / paper.height());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(room.center());
    painter.scale(scale, scale);
    painter.translate(-0.5 * paper.width(), -0.5 * paper.height());
    const QRectF sheet(QPointF(), paper);
    painter.fillRect(sheet, Qt::white);
    painter.setClipRect(sheet);
    pattern_->paint(painter, sheet_, kThinnestLine / scale);
}

}  // namespace toile::app
