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

/// The cloth of a piece on the screen, as far as a name may lie on it. Logical pixels; angles in
/// radians, anti-clockwise.
class NameCloth {
public:
    /// @param outline  closed  @param own  its grain arrow  @param arrows, taken  of the whole view
    NameCloth(const QPolygonF& outline, const std::optional<QLineF>& own,
              const std::vector<QLineF>& arrows, const std::vector<QRectF>& taken);

    /// Ways for words that find no room across: along the cloth where it is long, and along its
    /// grain arrow; none twice.
    const std::vector<double>& ways() const { return ways_; }

    /// The middle of the roomiest place for a box of this size, if it fits. Cost: that of boxPlace.
    std::optional<QPointF> placeFor(const QSizeF& size, double angle) const;
    /// Whether a box that is not turned lies on the cloth, over no line.
    bool holds(const QRectF& box) const;
    /// From a place beside the piece straight onto the cloth, level or plumb: where the line first
    /// meets cloth, a little in. Nothing where it meets none.
    std::optional<QPointF> onto(const QPointF& from, const QPointF& way) const;
    /// Whether an arrow is at this place.
    bool isOnArrow(const QPointF& at) const;

private:
    void addArrow(const QLineF& arrow);

    FreeCloth cloth_;  ///< y up, as the core has it
    QRectF box_;
    std::vector<double> ways_;
    std::vector<QLineF> arrows_;
};

}  // namespace toile::app
