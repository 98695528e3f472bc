// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QWidget>
#include <cstddef>
#include <optional>
#include <vector>

namespace toile::app {

/// Plots mean strain against total cut length: predicted (open points), flattened (filled points)
/// and the target (dashed line). A click or an arrow key selects a point.
class CutChart : public QWidget {
    Q_OBJECT

public:
    struct Step {
        double length = 0;     ///< cumulative, mm
        double predicted = 0;  ///< mean strain, as a fraction
        std::optional<double> solved{};
        bool isStale = false;  ///< predicted before the cut lines were moved
        QString tip{};

        bool operator==(const Step&) const = default;
    };

    explicit CutChart(QWidget* parent = nullptr);

    /// @param steps  the first one is the state before any cut
    void show(std::vector<Step> steps, std::optional<double> enough);
    /// Selects no point if `step` is empty.
    void select(std::optional<std::size_t> step);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Position of the point of a step, in widget coordinates.
    QPointF placeOf(std::size_t step) const;

signals:
    /// `step` is never 0, the state before any cut.
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
