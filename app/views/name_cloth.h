// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineF>
#include <QPointF>
#include <QPolygonF>
#include <QRectF>
#include <QSizeF>
#include <optional>
#include <vector>

#include "core/pattern/pole.h"

namespace toile::app {

/// The area of a piece on the screen that a name can use. Logical pixels; angles in radians,
/// anticlockwise.
class NameCloth {
public:
    /// @param outline  closed  @param own  its grain arrow  @param arrows, taken  of the whole view
    NameCloth(const QPolygonF& outline, const std::optional<QLineF>& own,
              const std::vector<QLineF>& arrows, const std::vector<QRectF>& taken);

    /// Angles for words that do not fit horizontally: along elongated cloth and along its grain
    /// arrow, without duplicates.
    const std::vector<double>& ways() const { return ways_; }

    /// Middle of the roomiest place for a box of this size, if it fits. Cost: see boxPlace.
    std::optional<QPointF> placeFor(const QSizeF& size, double angle) const;
    /// Whether an unrotated box lies on the cloth without crossing a line.
    bool holds(const QRectF& box) const;
    /// Casts a horizontal or vertical line from a place beside the piece. Returns a point slightly
    /// inside where it first meets cloth, or nullopt.
    std::optional<QPointF> onto(const QPointF& from, const QPointF& way) const;
    bool isOnArrow(const QPointF& at) const;

private:
    void addArrow(const QLineF& arrow);

    FreeCloth cloth_;  ///< y up, as the core has it
    QRectF box_;
    std::vector<double> ways_;
    std::vector<QLineF> arrows_;
};

}  // namespace toile::app
