// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <map>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "app/render/scene.h"
#include "core/mesh/mesh_arrays.h"

class QFont;
class QPainter;

namespace toile::app {

class Document;
class SheetMap;
struct RenderStyle;

/// The lines of the reference pattern that is open, as far as it is known how it lies; null: none
/// is open, and the scene's own count.
std::shared_ptr<const ReferenceLines> referenceLinesOf(const Document& document);

/// How far the designer's outline lies from ours, all along it: a band between both, and the mm
/// where they are farthest apart; nearer by, more of the places.
class ReferenceGaps {
public:
    struct Gap {
        int piece = -1;
        Eigen::Vector2d theirs, ours;  ///< the piece's own flat coordinates, mm
        double distance = 0;           ///< mm
        bool joins = false;            ///< goes on from the gap before, along the same line
    };

    /// Brings the gaps to what the document shows. Cost: n log n in the points of both outlines,
    /// once for each scene and reference.
    void follow(const Document& document);
    /// All along the lines, in their order; none where nothing is compared.
    const std::vector<Gap>& gaps() const { return gaps_; }
    /// @param view  logical pixels; places outside have no words
    /// @param taken  by other words
    /// @return what the words take
    std::vector<QRectF> paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                              const SheetPlaces& places, const QRectF& view,
                              const std::vector<QRectF>& taken) const;

private:
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const ReferenceLines> lines_;
    std::map<int, Points2> outlines_;  ///< ours, of the pieces that have gaps
    std::vector<Gap> gaps_;
    std::vector<std::size_t> widestFirst_;  ///< indices of the gaps
};

}  // namespace toile::app
