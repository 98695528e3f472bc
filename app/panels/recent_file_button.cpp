// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/recent_file_button.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPainter>

namespace toile {

namespace {

constexpr int kPad = 10, kGap = 12;

}  // namespace

RecentFileButton::RecentFileButton(const QString& path, QWidget* parent) : QPushButton(parent) {
    const QFileInfo file(path);
    setText(file.fileName());
    folder_ = QDir::toNativeSeparators(file.absolutePath());
    const QString home = QDir::toNativeSeparators(QDir::homePath());
    if (folder_.startsWith(home)) {
        folder_.replace(0, home.size(), "~");
    }
    date_ = QLocale().toString(file.lastModified().date(), QLocale::ShortFormat);
    setToolTip(QDir::toNativeSeparators(path));
    setAccessibleDescription(folder_);
    setFlat(true);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize RecentFileButton::sizeHint() const {
    return {200, fontMetrics().height() + 14};
}

void RecentFileButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const bool lit = underMouse() || hasFocus();
    if (lit) {
        QColor back = palette().color(QPalette::Highlight);
        back.setAlphaF(0.14F);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(hasFocus() ? QPen(palette().color(QPalette::Highlight)) : QPen(Qt::NoPen));
        painter.setBrush(back);
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    }
    QRect row = rect().adjusted(kPad, 0, -kPad, 0);
    const QColor ink = palette().color(QPalette::WindowText);
    const QColor faint = palette().color(QPalette::PlaceholderText);
    painter.setPen(faint);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, date_);
    row.setRight(row.right() - fontMetrics().horizontalAdvance(date_) - kGap);
    const QString name = fontMetrics().elidedText(text(), Qt::ElideMiddle, row.width());
    painter.setPen(ink);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, name);
    row.setLeft(row.left() + fontMetrics().horizontalAdvance(name) + kGap);
    painter.setPen(faint);
    painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(folder_, Qt::ElideMiddle, row.width()));
}

}  // namespace toile
