// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSlider>

namespace toile {

/// A slider that goes to where its groove is pressed, whatever the desktop's habit, and can be
/// dragged on from there.
class JumpSlider : public QSlider {
public:
    using QSlider::QSlider;

protected:
    void mousePressEvent(QMouseEvent* event) override;
};

}  // namespace toile
