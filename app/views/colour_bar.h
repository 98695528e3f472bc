// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/views/colour_legend.h"

namespace toile::app {

/// Legend of the overlay. Shows nothing of the garment itself.
class ColourBar : public QWidget {
    Q_OBJECT

public:
    explicit ColourBar(QWidget* parent = nullptr);
    /// In the lower right corner of a view, above what it draws; seen while the overlay's colours
    /// have to be told.
    static ColourBar* inCorner(QWidget& view);

    /// The value under the pointer stays, where the overlay does.
    void show(const ColourLegend& legend);

    QString summary() const { return legend_.summary(); }
    QString valueText() const { return legend_.valueText(); }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// The value under the pointer: a mark on the bar and a number.
    void showValue(std::optional<double> value);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void placeInCorner();

    LegendShape shape_ = LegendShape::Row;
    ColourLegend legend_;
};

}  // namespace toile::app
