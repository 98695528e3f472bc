// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QLineF>
#include <QPointF>
#include <QRect>
#include <QRectF>
#include <QString>
#include <vector>

#include "app/render/camera.h"
#include "app/views/callouts.h"
#include "app/views/reference_gaps.h"

namespace toile::app {

/// What the pattern view writes over the sheet, in the window and in pictures alike: caption, grain
/// arrows, names, callouts, distances from the reference, scale bar and rulers.
struct PatternText {
    const Document& document;
    const SheetPlaces& places;
    const Camera2D& camera;
    QRect view;  ///< logical pixels, from 0, 0
    const FlaggedSpots& spots;
    const ReferenceGaps& gaps;
    bool strongGrain = false;  ///< while the grain is what is being worked on
    bool isElse = false;       ///< where no piece is flat, something else says why
};

void paintPatternText(QPainter& painter, const RenderStyle& style, const PatternText& text);

/// A piece that is to have its name written on it. Logical pixels.
struct NamedPiece {
    QString name;
    QString note;  ///< " · wrong side up"; may be left out where room is short
    QPointF at;    ///< where its name belongs
    QRectF box;    ///< around the piece
    bool selected = false;
};

struct NameLabel {
    int piece = -1;  ///< index into the list of pieces
    QRectF box;
    QString text;
};

/// Where the names go, none on another nor on what is taken. A name is written out where it fits
/// on its piece, nearly, or lies over no other piece; else without what all names begin with, else
/// shortened in its middle as long as it can be told from all other names. A piece whose name finds
/// no room has no label; it lies on none of the arrows where there is a way. The largest pieces and
/// those that are selected choose first. Cost: quadratic in the pieces.
std::vector<NameLabel> nameLabels(const QFont& font, const std::vector<NamedPiece>& pieces,
                                  std::vector<QRectF> taken,
                                  const std::vector<QLineF>& arrows = {});

}  // namespace toile::app
