// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <memory>
#include <vector>

#include "app/views/tool.h"
#include "core/marker/cloth_marker.h"

class QPainter;

namespace toile::app {

struct RenderStyle;

/// A copy as it is painted.
struct ClothShape {
    Points2 edge, seam;  ///< as it lies; the seam line is empty where it is cut along that
    Eigen::Vector2d label = Eigen::Vector2d::Zero();
    Eigen::Vector2d grain = Eigen::Vector2d::UnitX();  ///< along the warp of the piece
    QColor colour;
    QString name;
    bool isKept = false, isMisplaced = false, isSelected = false, isStated = false;
};

/// Where names go, found once for each piece of a pattern.
class ClothLabels {
public:
    /// On the piece, as far from its edge as may be.
    const Eigen::Vector2d& of(const std::shared_ptr<const Pattern>& pattern, int piece);

private:
    std::shared_ptr<const Pattern> pattern_;
    std::vector<std::optional<Eigen::Vector2d>> places_;
};

/// The cloth: its edges, where it is folded, its stripes, how long it is.
void paintCloth(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                const ClothMarker& marker, const MarkerSettings& settings, const QColor& ground);

/// The copies; those that are selected or misplaced over the others.
void paintCopies(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                 const std::vector<ClothShape>& shapes);

/// As it is painted where something lies on another thing, or beyond the cloth.
QColor misplacedColour();

}  // namespace toile::app
