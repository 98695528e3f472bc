// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QString>
#include <memory>
#include <vector>

#include "app/render/scene.h"
#include "core/garment/piece.h"

class QPainter;

namespace toile::app {

class Document;
class SheetMap;
struct RenderStyle;

/// The outlines of pieces as they lay when the pattern was last up to date: pale in the place of
/// those that edits have changed, until these are flattened.
class OldOutlines {
public:
    /// Remembers what is up to date. Cost: linear in the outlines.
    void follow(const Document& document, const SheetPlaces& sheet);
    /// Whether any of the pieces that were there waits to be flattened in another shape.
    bool isAny(const Document& document) const;
    void paint(QPainter& painter, const RenderStyle& style, const SheetMap& onScreen,
               const Document& document) const;

private:
    struct Outline {
        std::shared_ptr<const Piece> piece;
        Points2 points;  ///< on the sheet, mm
    };

    /// Those of pieces that are no more, while others wait.
    std::vector<const Outline*> shown(const Document& document) const;

    std::vector<Outline> outlines_;
};

}  // namespace toile::app
