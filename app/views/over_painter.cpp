// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/over_painter.h"

#include <QWidget>
#include <cmath>

#include "app/render/render_style.h"

namespace toile {

OverPainter::OverPainter(const QWidget& widget) : device_(devicePixels(widget)) {
    device_.setDevicePixelRatio(widget.devicePixelRatioF());
    painter_.begin(&device_);
    painter_.setFont(widget.font());
    painter_.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
}

QSize devicePixels(const QWidget& widget) {
    const double ratio = widget.devicePixelRatioF();
    return {static_cast<int>(std::lround(widget.width() * ratio)),
            static_cast<int>(std::lround(widget.height() * ratio))};
}

void paintProblem(QPainter& painter, const RenderStyle& style, const QRect& view,
                  const QString& problem) {
    constexpr int kTextAir = 20;
    painter.fillRect(view, style.bottom);
    painter.setPen(style.text);
    painter.drawText(view.adjusted(kTextAir, kTextAir, -kTextAir, -kTextAir),
                     Qt::AlignCenter | Qt::TextWordWrap, problem);
}

}  // namespace toile
