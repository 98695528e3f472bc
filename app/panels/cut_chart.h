// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <cstddef>
#include <optional>
#include <vector>

namespace toile::app {

/// Strain against the length of the cuts made so far: as predicted a line with open points, as
/// flattened filled ones, and a line at what is enough. A click or the arrow keys select a point.
class CutChart : public QWidget {
    Q_OBJECT

public:
    struct Step {
        double length = 0;     ///< so far, mm
        double predicted = 0;  ///< mean strain, part of 1
        std::optional<double> solved{};
        bool isStale = false;  ///< the prediction is of other lines
        QString tip{};

        bool operator==(const Step&) const = default;
    };

    explicit CutChart(QWidget* parent = nullptr);

    /// @param steps  the first: before any cut
    void show(std::vector<Step> steps, std::optional<double> enough);
    /// Which step; none: no cut.
    void select(std::optional<std::size_t> step);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Where a step is drawn, for tests.
    QPointF placeOf(std::size_t step) const;

signals:
    /// Never the first.
    void selected(std::size_t step);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    double shownStrain(const Step& step) const;
    double highest() const;
    QRectF field() const;
    QPointF at(double length, double strain) const;
    std::optional<std::size_t> stepAt(const QPointF& at) const;

    std::vector<Step> steps_;
    std::optional<double> enough_;
    std::optional<std::size_t> selected_, hovered_;
};

}  // namespace toile::app
