// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QVector>
#include <QWidget>
#include <memory>

#include "core/formats/drawing/drawing.h"

namespace toile::app {

/// The page as it will be written, fitted into the widget.
class DrawingPreview : public QWidget {
    Q_OBJECT

public:
    explicit DrawingPreview(QWidget* parent = nullptr);

    /// @param drawing  null: not ready yet
    void setDrawing(std::shared_ptr<const Drawing> drawing);
    /// Sheets of the printed drawing, mm, y down from its upper left corner; empty: one sheet.
    void setSheets(QVector<QRectF> sheets);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::shared_ptr<const Drawing> drawing_;
    QVector<QRectF> sheets_;
};

}  // namespace toile::app
