// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <map>
#include <optional>
#include <vector>

#include "core/layout/arrange.h"
#include "core/mesh/mesh_arrays.h"
#include "core/project/piece_settings.h"

namespace toile::app {

class Document;

/// Where the document's flat pieces lie, and the edits that move them. The cost depends on the
/// outlines of the pieces, not on their triangles; each edit is one step of the history.

/// By piece.
using PiecePlacements = std::map<int, Placement>;
using PieceGrains = std::map<int, std::optional<double>>;

/// The selected pieces that are flat, in order.
std::vector<int> selectedFlat(const Document& document);
/// All flat pieces.
std::vector<int> allFlat(const Document& document);
/// The selected flat pieces, or all if none is selected.
std::vector<int> selectedOrAllFlat(const Document& document);

/// Seam line and cutting line of a piece in its own coordinates; empty if it is not flat.
const Points2& flatOutline(const Document& document, int piece);
const Points2& cutOutline(const Document& document, int piece);
Placement placementOf(const Document& document, int piece);
/// How files draw the piece; the sheet always shows all of it.
CutAs cutAsOf(const Document& document, int piece);
/// Box around the cutting line where the piece lies; empty if it is not flat.
Eigen::AlignedBox2d boxOnSheet(const Document& document, int piece);
Eigen::AlignedBox2d boxOnSheet(const Document& document, const std::vector<int>& pieces);

/// @param text  for the undo menu, with %1 for the pieces (`stepOf`); so for all edits here
/// @param gesture  as for Document::edit
void place(Document& document, const QString& text, const PiecePlacements& placements,
           int gesture = -1);
/// Moves the pieces back to where they were before a gesture, and forgets that the user has moved
/// them.
/// @param before  the settings of all pieces at that time
void placeBack(Document& document, const QString& text, const PiecePlacements& pieces,
               const std::vector<PieceSettings>& before, int gesture);
/// Turns the grain of mirrored pieces' counterparts, too (`withMirroredGrains`).
void setGrain(Document& document, const QString& text, const PieceGrains& grains, int gesture = -1);

/// Turns the pieces together about the middle of the box around them.
void turnTogether(Document& document, const QString& text, const std::vector<int>& pieces,
                  double angle);
/// Mirrors the pieces together at the middle of the box around them.
void mirrorTogether(Document& document, const QString& text, const std::vector<int>& pieces,
                    Mirroring mirroring);
/// Turns each piece about its own middle so that its grain runs upwards on the sheet.
void turnGrainUpwards(Document& document, const std::vector<int>& pieces);
void align(Document& document, const std::vector<int>& pieces, Alignment alignment);
void distribute(Document& document, const std::vector<int>& pieces, Direction direction);
/// Lays the pieces in rows, turned as they are; beside the others where these are not all.
void layOutAgain(Document& document, const std::vector<int>& pieces);

}  // namespace toile::app
