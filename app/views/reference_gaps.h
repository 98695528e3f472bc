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

/// The aligned lines of the open reference file. Null: no file is open, and the scene's own lines
/// are used.
std::shared_ptr<const ReferenceLines> referenceLinesOf(const Document& document);

/// Differences between the designer's outline and ours: a band between both, labelled in mm at the
/// widest places. Zooming in labels more places.
class ReferenceGaps {
public:
    struct Gap {
        int piece = -1;
        Eigen::Vector2d theirs, ours;  ///< the piece's own flat coordinates, mm
        double distance = 0;           ///< mm
        bool joins = false;            ///< continues the previous gap along the same line
    };

    /// Updates the gaps from the document. Cost: n log n in the points of both outlines, once for
    /// each scene and reference.
    void follow(const Document& document);
    /// In order along the lines; empty if nothing is compared.
    const std::vector<Gap>& gaps() const { return gaps_; }
    /// @param view  logical pixels; labels outside are omitted
    /// @param taken  areas of other words
    /// @return the areas of the labels
    std::vector<QRectF> paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
                              const SheetPlaces& places, const QRectF& view,
                              const std::vector<QRectF>& taken) const;

private:
    std::shared_ptr<const Scene> scene_;
    std::shared_ptr<const ReferenceLines> lines_;
    std::map<int, Points2> outlines_;  ///< our outlines of the pieces with gaps
    std::vector<Gap> gaps_;
    std::vector<std::size_t> widestFirst_;  ///< indices of the gaps
};

}  // namespace toile::app
