// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/views/jump_slider.h"

#include <QMouseEvent>
#include <QStyle>
#include <QStyleOptionSlider>

namespace toile {

void JumpSlider::mousePressEvent(QMouseEvent* event) {
    QStyleOptionSlider option;
    initStyleOption(&option);
    const auto partOf = [&](QStyle::SubControl part) -> QRect {
        return style()->subControlRect(QStyle::CC_Slider, &option, part, this);
    };
    const QRect handle = partOf(QStyle::SC_SliderHandle), groove = partOf(QStyle::SC_SliderGroove);
    const QPoint at = event->position().toPoint();
    if (event->button() == Qt::LeftButton && !handle.contains(at)) {
        const bool lies = orientation() == Qt::Horizontal;
        const int size = lies ? handle.width() : handle.height();
        const int place = (lies ? at.x() - groove.left() : at.y() - groove.top()) - size / 2;
        const int room = (lies ? groove.width() : groove.height()) - size;
        setValue(
            QStyle::sliderValueFromPosition(minimum(), maximum(), place, room, option.upsideDown));
    }
    QSlider::mousePressEvent(event);  // on the handle now
}

}  // namespace toile
