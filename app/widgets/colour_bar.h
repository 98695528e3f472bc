// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "app/document/view_state.h"
#include "app/render/overlay_scale.h"

namespace toile {

/// Legend of the overlay: what the colours mean, in numbers. Shows nothing of the garment itself.
class ColourBar : public QWidget {
    Q_OBJECT

public:
    explicit ColourBar(QWidget* parent = nullptr);

    void show(Overlay overlay, const OverlayScale& scale);

    /// For tests and screen readers: "Edge strain: <= -5 % to >= 5 %".
    QString summary() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Words {
        QString title, unit, meaning;
    };

    Words words() const;
    QString number(double value) const;
    QString endLabel(bool high) const;
    void paintBar(QPainter& painter, const QRectF& bar) const;
    void paintSquares(QPainter& painter, const QRectF& area) const;

    Overlay overlay_ = Overlay::None;
    OverlayScale scale_;
};

}  // namespace toile
