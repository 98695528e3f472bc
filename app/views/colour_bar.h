// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "app/views/colour_legend.h"

namespace toile::app {

/// Legend of the overlay. Does not depend on the garment.
class ColourBar : public QWidget {
    Q_OBJECT

public:
    explicit ColourBar(QWidget* parent = nullptr);
    /// Creates the legend in the lower right corner of a view. It is visible while an overlay needs
    /// a legend.
    static ColourBar* inCorner(QWidget& view);

    /// Keeps the value under the pointer if the overlay stays the same.
    void show(const ColourLegend& legend);

    QString summary() const { return legend_.summary(); }
    QString valueText() const { return legend_.valueText(); }
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// Marks the value under the pointer on the bar and writes it.
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
